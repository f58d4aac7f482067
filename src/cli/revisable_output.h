// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "files/output_file.h"

namespace pyrasim::cli {

/// A file named on the command line, "-" for stdout, whose bytes may be overwritten until it is complete. What is
/// written to directly, as stdout and pipes are, is kept in a nameless file until then, and copied in the end. Opened
/// before the work begins so that a mistake shows at once.
class RevisableOutput {
 public:
  /// Throws RunError, as OutputFile does.
  explicit RevisableOutput(const std::string& file);

  OutputFile& file() { return scratch_ ? *scratch_ : *output_; }
  /// Gives a file of its own its name with what it holds, and lets it grow from now on; other outputs wait for
  /// commit().
  void publish() {
    if (!scratch_) output_->publish();
  }
  /// Completes the output. Throws RunError, as OutputFile does.
  void commit();

 private:
  std::optional<OutputFile> output_;   ///< none: stdout
  std::optional<OutputFile> scratch_;  ///< none: the output is revisable itself
};

}  // namespace pyrasim::cli
