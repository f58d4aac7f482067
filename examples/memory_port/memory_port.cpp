// SPDX-License-Identifier: Apache-2.0
#include "memory_port.h"

pyrasim::hw::Cycle MemoryPort::fire(Ends& ends, const Plan& plan) {
  const StoredPixel pixel = ends.pixels.read(plan.start.at());
  return interval_ + (pixel.number % refresh_interval == 0 ? refresh_cycles : 0);
}
