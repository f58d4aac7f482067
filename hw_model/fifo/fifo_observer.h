// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hw_model/cycle.h"

namespace pyrasim::hw {

/// Told of every write and read; dates ascend for each of the two.
class FifoObserver {
 public:
  virtual ~FifoObserver() = default;
  virtual void written(Cycle at) = 0;
  virtual void read(Cycle at) = 0;
};

}  // namespace pyrasim::hw
