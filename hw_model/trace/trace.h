// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string_view>

#include "files/output_file.h"
#include "hw_model/processor.h"
#include "hw_model/trace/trace_window.h"

namespace pyrasim::hw {

/// What happens in a machine, written as a file while the frame runs.
class Trace {
 public:
  virtual ~Trace() = default;
  /// Writes the rest, of a frame of `cycles` that is over or was broken off. The output is not committed.
  virtual void finish(Cycle cycles) = 0;
  /// The cycle with which it ended at the limit of its size, if it did.
  virtual std::optional<Cycle> full() const { return std::nullopt; }
};

/// A format that a trace can have.
struct TraceFormat {
  std::string_view ending;  ///< of files' names
  bool revises;             ///< what has been written may be overwritten, and is no file before it is complete
  bool waveform;            ///< it shows Signals, in detail where the window asks for that
  bool windowed;            ///< it shows what the window does; else the whole frame
  /// Of `processor`, whose simulation has not started, and which outlives it as `output` does. `run` describes scene
  /// and settings, for formats that say what was run.
  std::unique_ptr<Trace> (*make)(Processor& processor, const TraceWindow& window, const nlohmann::ordered_json& run,
                                 OutputFile& output);
};

extern const std::array<TraceFormat, 8> trace_formats;

}  // namespace pyrasim::hw
