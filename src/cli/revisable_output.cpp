// SPDX-License-Identifier: Apache-2.0
#include "cli/revisable_output.h"

#include <iostream>

#include "error.h"

namespace pyrasim::cli {

RevisableOutput::RevisableOutput(const std::string& file) {
  if (file != "-") output_.emplace(file);
  if (!output_ || !output_->revisable()) scratch_.emplace(OutputFile::Scratch{});
}

void RevisableOutput::commit() {
  if (!output_) {
    scratch_->copy_to([](std::string_view text) { std::cout << text; });
    std::cout << std::flush;
    if (!std::cout) throw RunError("stdout: cannot write");
    return;
  }
  if (scratch_) scratch_->copy_to([this](std::string_view text) { output_->write(text); });
  output_->commit();
}

}  // namespace pyrasim::cli
