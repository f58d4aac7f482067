// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hw_model/fifo/fifo_port.h"
#include "hw_model/fifo/fifo_reader.h"
#include "hw_model/stage/stage_of.h"

/// A finished pixel on its way to the memory.
struct StoredPixel {
  std::uint64_t number;  ///< in the order of storing, from 0
};

/// A stage of one's own: writes pixels to a memory that takes some cycles for each, and now and then is refreshed.
class MemoryPort final : public pyrasim::hw::StageOf<MemoryPort> {
 public:
  pyrasim::hw::FifoPort<StoredPixel> pixels{"pixels"};

  /// `interval`: cycles that a pixel takes, at least 1.
  MemoryPort(const sc_core::sc_module_name& name, pyrasim::hw::Cycle interval) : StageOf(name), interval_(interval) {}

 private:
  static constexpr std::uint64_t refresh_interval = 256;  ///< pixels
  static constexpr pyrasim::hw::Cycle refresh_cycles = 16;

  // What a stage is: what it plans, its ends, when it can fire next, and what it does then.
  friend StageOf;
  struct Plan {
    pyrasim::hw::Start start;
  };
  struct Ends {
    pyrasim::hw::FifoReader<StoredPixel> pixels;
  };
  Ends ends() const { return {pyrasim::hw::FifoReader(*pixels)}; }
  static Plan next(const Ends& ends, pyrasim::hw::Cycle ready) {
    return {pyrasim::hw::Start(ready).needs_token(ends.pixels)};
  }
  pyrasim::hw::Cycle fire(Ends& ends, const Plan& plan);

  pyrasim::hw::Cycle interval_;
};
