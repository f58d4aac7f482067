// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/command.h"
#include "cli/output_plan.h"
#include "cli/revisable_output.h"
#include "hw_model/trace/trace.h"

namespace pyrasim::cli {

/// --trace, and what of the frame traces show.
struct TraceOptions {
  std::vector<std::string> files;
  hw::TraceWindow window;  ///< without its pixels
  std::vector<std::string> pixels;
  std::optional<std::string> limit;  ///< "10M"

  void add(const Command& command);
};

/// The files of --trace, each in the format that its name ends in.
class TraceOutputs {
 public:
  /// Throws UsageError.
  TraceOutputs(const TraceOptions& asked, const PixelWindow& rendered, OutputPlan& plan);

  /// Opens the files.
  void open();
  /// Takes what happens in `processor`, whose simulation has not started, and which outlives this. `run` describes
  /// scene and settings.
  void begin(hw::Processor& processor, const nlohmann::ordered_json& run);
  /// Completes the files, of a frame that is over or was broken off after `cycles`.
  void finish(hw::Cycle cycles);

 private:
  void require_names(const hw::Processor& processor) const;

  struct Asked {
    std::string file;
    const hw::TraceFormat* format;
  };

  hw::TraceWindow window_;
  std::vector<Asked> asked_;
  std::vector<std::unique_ptr<RevisableOutput>> outputs_;
  std::vector<std::unique_ptr<hw::Trace>> traces_;
};

}  // namespace pyrasim::cli
