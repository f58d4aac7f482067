// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hw_model/fifo/fifo_base.h"
#include "hw_model/stage/stage.h"

namespace pyrasim::hw {

/// A FIFO and the stages at its ends.
struct Wire {
  FifoBase* fifo;
  Stage* writer;
  Stage* reader;
};

}  // namespace pyrasim::hw
