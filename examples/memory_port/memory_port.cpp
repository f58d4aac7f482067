// SPDX-License-Identifier: Apache-2.0
#include "memory_port.h"

pyrasim::hw::Cycle MemoryPort::fire(Ends& ends, pyrasim::hw::Cycle now) {
  const StoredPixel pixel = ends.pixels.read(now);
  return interval_ + (pixel.number % refresh_interval == 0 ? refresh_cycles : 0);
}
