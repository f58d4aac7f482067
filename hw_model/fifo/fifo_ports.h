// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <systemc>
#include <vector>

#include "hw_model/fifo/fifo_port.h"

namespace pyrasim::hw {

/// A stage's ports to FIFOs of one kind, numbered. The FIFOs bound to them are at hand in an array of their own: a
/// sc_vector leads to each by way of its port, which costs a stage that has a choice of many more than the rest.
template <class Message>
class FifoPorts {
 public:
  using Token = Message;

  FifoPorts(const char* name, std::size_t size) : ports_(name, size), fifos_(size) {}

  std::size_t size() const { return fifos_.size(); }
  /// The FIFO at port `number`, which has to be bound.
  Fifo<Message>& operator[](std::size_t number) const { return *fifos_[number]; }
  /// To be called with the FIFO that is bound to port `number`; once.
  auto port(std::size_t number) {
    return [this, number](Fifo<Message>& fifo) {
      ports_[number](fifo);
      fifos_[number] = &fifo;
    };
  }

 private:
  sc_core::sc_vector<FifoPort<Message>> ports_;
  std::vector<Fifo<Message>*> fifos_;
};

}  // namespace pyrasim::hw
