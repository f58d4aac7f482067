// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "hw_model/stage/stage.h"

namespace pyrasim::hw {

/// The stages that have been woken, in the decoupled engine.
class WorkList {
 public:
  /// Of stages alone.
  WokenEnds& stages() { return stages_; }
  /// Lets stages fire until none that is awake has a known next firing.
  void run() {
    for (std::size_t next = 0; next < stages_.size();) {  // more may come
      auto& stage = static_cast<Stage&>(*stages_[next++]);
      if (stage.awake()) stage.drain();
    }
    stages_.clear();
  }

 private:
  WokenEnds stages_;
};

}  // namespace pyrasim::hw
