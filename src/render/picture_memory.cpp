// SPDX-License-Identifier: Apache-2.0
#include "render/picture_memory.h"

#include <fmt/format.h>
#include <unistd.h>

#include <glm/vec3.hpp>

#include "error.h"

namespace pyrasim {

std::uint64_t physical_memory() {
  return static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

void check_picture_fits(const PixelWindow& window, std::uint64_t memory) {
  const std::uint64_t pixels = static_cast<std::uint64_t>(window.columns) * static_cast<std::uint64_t>(window.rows);
  const std::uint64_t needed = 2 * pixels * sizeof(glm::vec3);
  if (needed <= memory) return;
  constexpr double gib = 1U << 30U;
  throw LimitError(
      fmt::format("a picture of {}x{} pixels takes {:.1f} GiB of memory, and this machine has {:.1f} GiB; render and "
                  "simulate make a part of the picture with --window X,Y,COLUMNS,ROWS",
                  window.columns, window.rows, static_cast<double>(needed) / gib, static_cast<double>(memory) / gib));
}

}  // namespace pyrasim
