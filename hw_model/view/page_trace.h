// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <utility>

#include "hw_model/trace/trace.h"
#include "hw_model/view/frame_tables.h"

namespace pyrasim::hw {

/// Writes the trace page of a run, .html, once it is over.
class PageTrace final : public Trace {
 public:
  /// `run` describes scene and settings.
  PageTrace(Processor& processor, nlohmann::ordered_json run, OutputFile& output)
      : processor_(processor), run_(std::move(run)), output_(output), tables_(processor) {}

  void finish(Cycle cycles) override;

 private:
  Processor& processor_;
  nlohmann::ordered_json run_;
  OutputFile& output_;
  FrameTables tables_;
};

}  // namespace pyrasim::hw
