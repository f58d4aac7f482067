// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "files/output_file.h"
#include "hw_model/processor.h"
#include "hw_model/trace/trace.h"

namespace pyrasim::hw {

/// Writes a save file of GTKWave, which shows the signals of a `.vcd` or `.fst` trace in the order of the data's flow:
/// units with their states as names and colours, FIFOs as curves. It says nothing of what happens in the machine.
///
/// What a state's number is called stands in a file of its own: GTKWave wants it so.
class GtkwSave final : public Trace {
 public:
  /// The file of the states' names that belongs to a save file.
  static std::filesystem::path states_file(std::filesystem::path save_file) {
    return save_file.replace_extension(".states");
  }

  /// Of `processor`, elaborated; writes all at once.
  GtkwSave(const Processor& processor, const TraceWindow& window, OutputFile& output);
  void finish(Cycle /*cycles*/) override {}
};

}  // namespace pyrasim::hw
