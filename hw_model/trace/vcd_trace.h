// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "hw_model/processor.h"

namespace pyrasim::hw {

/// Records the state of every stage and the fill of every FIFO of a processor, for a VCD file (IEEE 1364-2005, clause
/// 18). Attach before the simulation starts. Without one, the processor does no work for it.
///
/// A stage's signal has two bits: 0 idle, 1 busy, 2 starved, 3 blocked. A FIFO's is the number of tokens, where a token
/// counts from the cycle of its write to that of its read. One time step is one cycle.
class VcdTrace {
 public:
  explicit VcdTrace(Processor& processor);
  ~VcdTrace();
  VcdTrace(const VcdTrace&) = delete;
  VcdTrace& operator=(const VcdTrace&) = delete;

  /// The whole file, of a frame that is over.
  std::string text() const;

 private:
  class StageSignal;
  class FifoSignal;
  struct Change;

  std::string header() const;

  Processor& processor_;
  std::vector<std::unique_ptr<StageSignal>> stages_;
  std::vector<std::unique_ptr<FifoSignal>> fifos_;
};

}  // namespace pyrasim::hw
