// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <systemc>

#include "hw_model/fifo/fifo.h"

namespace pyrasim::hw {

/// A stage's port to one of its FIFOs; `Policy` as for sc_port. It is bound to the channel itself, once.
template <class Message, sc_core::sc_port_policy Policy = sc_core::SC_ONE_OR_MORE_BOUND>
class FifoPort : public sc_core::sc_port<Fifo<Message>, 1, Policy> {
 public:
  using Token = Message;
  using sc_core::sc_port<Fifo<Message>, 1, Policy>::sc_port;

  void operator()(Fifo<Message>& fifo) {
    sc_core::sc_port<Fifo<Message>, 1, Policy>::operator()(fifo);
    fifo_ = &fifo;
  }
  bool bound() const { return fifo_ != nullptr; }
  Fifo<Message>& operator*() const { return *fifo_; }
  Fifo<Message>* operator->() const { return fifo_; }

 private:
  Fifo<Message>* fifo_ = nullptr;
};

/// A port that stays unbound where the stage at its other end is not built.
template <class Message>
using OptionalFifoPort = FifoPort<Message, sc_core::SC_ZERO_OR_MORE_BOUND>;

}  // namespace pyrasim::hw
