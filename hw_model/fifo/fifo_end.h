// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace pyrasim::hw {

class FifoEnd;

/// Ends that have been woken, in the order in which they were.
using WokenEnds = std::vector<FifoEnd*>;

/// One end of a FIFO: told when what it may be waiting for has happened. It is told once, until it falls asleep again.
class FifoEnd {
 public:
  virtual ~FifoEnd() = default;
  void wake() {
    if (awake_) return;
    awake_ = true;
    if (list_ != nullptr) {
      list_->push_back(this);
    } else {
      woken();
    }
  }
  /// When it is woken, it is put on `list` instead of being told.
  void enlist(WokenEnds& list) { list_ = &list; }
  void sleep() { awake_ = false; }
  bool awake() const { return awake_; }

 protected:
  virtual void woken() = 0;

 private:
  bool awake_ = false;
  WokenEnds* list_ = nullptr;
};

}  // namespace pyrasim::hw
