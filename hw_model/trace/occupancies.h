// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "hw_model/processor.h"
#include "hw_model/trace/occupancy.h"

namespace pyrasim::hw {

/// The Occupancy of every FIFO of a processor.
class Occupancies final : public EventSink {
 public:
  /// Of `processor`, whose simulation has not started.
  explicit Occupancies(Processor& processor) {
    for (const FifoBase* fifo : processor.fifos()) fifos_.emplace_back(fifo->size());
    processor.attach(*this);
  }
  Occupancies(const Occupancies&) = delete;
  Occupancies& operator=(const Occupancies&) = delete;

  bool in_order() const override { return false; }
  void take(const Event& event) override {
    if (event.kind == Event::Kind::write) fifos_[event.source].write(event.at);
    if (event.kind == Event::Kind::read) fifos_[event.source].read(event.at);
  }
  /// The frame of `cycles` is over.
  void end_frame(Cycle cycles) {
    for (Occupancy& fifo : fifos_) fifo.end_frame(cycles);
  }

  /// In the order of Processor::fifos().
  const std::vector<Occupancy>& fifos() const { return fifos_; }

 private:
  std::vector<Occupancy> fifos_;
};

}  // namespace pyrasim::hw
