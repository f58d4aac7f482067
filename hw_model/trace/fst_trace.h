// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "files/output_file.h"
#include "hw_model/processor.h"
#include "hw_model/trace/trace.h"
#include "hw_model/trace/vcd_trace.h"

namespace pyrasim::hw {

/// Writes GTKWave's fast signal trace (FST): the signals of VcdTrace, compressed, the states of units with their names.
///
/// FST takes changes in the order of time alone, but what a unit waited for is known only when it fires again. So a VCD
/// of the frame is kept in a nameless file, and converted in the end.
class FstTrace final : public Trace {
 public:
  /// Of `processor`, whose simulation has not started; both outlive it.
  FstTrace(Processor& processor, const TraceWindow& window, OutputFile& output);

  void finish(Cycle cycles) override;
  /// The limit is one of the VCD: what is left of it is known in the end.
  std::optional<Cycle> full() const override { return vcd_.full(); }

 private:
  const Processor& processor_;
  TraceWindow window_;
  OutputFile& output_;
  OutputFile vcd_file_;
  VcdTrace vcd_;
};

}  // namespace pyrasim::hw
