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

void check_picture_fits(const PixelWindow& window, std::uint64_t memory, std::size_t pictures) {
  const std::uint64_t pixels = static_cast<std::uint64_t>(window.columns) * static_cast<std::uint64_t>(window.rows);
  const std::uint64_t needed = (pictures + 1) * pixels * sizeof(glm::vec3);
  if (needed <= memory) return;
  constexpr double gib = 1U << 30U;
  const std::string size = fmt::format("{}x{} pixels", window.columns, window.rows);
  const std::string taken = fmt::format("{:.1f} GiB of memory, and this machine has {:.1f} GiB",
                                        static_cast<double>(needed) / gib, static_cast<double>(memory) / gib);
  if (pictures > 1) {
    throw LimitError(
        fmt::format("{} pictures of {} take {}; fewer of them or a smaller --size is allowed", pictures, size, taken));
  }
  throw LimitError(
      fmt::format("a picture of {} takes {}; render and simulate make a part of the picture with --window "
                  "X,Y,COLUMNS,ROWS",
                  size, taken));
}

}  // namespace pyrasim
