// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hw_model/cycle.h"

namespace pyrasim::hw {

class FifoBase;

/// What a stage can wait for in a FIFO.
struct WaitCounter {
  const FifoBase& fifo;
  bool starved;      ///< a token; else room
  Cycle cycles = 0;  ///< spent waiting for it
};

}  // namespace pyrasim::hw
