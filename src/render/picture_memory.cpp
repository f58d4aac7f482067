// SPDX-License-Identifier: Apache-2.0
#include "render/picture_memory.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <functional>
#include <glm/vec3.hpp>
#include <numeric>

#include "error.h"

namespace pyrasim {
namespace {

std::uint64_t bytes_of(const PixelWindow& window) {
  const std::uint64_t pixels = static_cast<std::uint64_t>(window.columns) * static_cast<std::uint64_t>(window.rows);
  return pixels * sizeof(glm::vec3);
}

/// What the largest `count` of them take.
std::uint64_t bytes_of_largest(const std::vector<PixelWindow>& windows, std::size_t count) {
  std::vector<std::uint64_t> bytes(windows.size());
  std::transform(windows.begin(), windows.end(), bytes.begin(), bytes_of);
  std::sort(bytes.begin(), bytes.end(), std::greater());
  bytes.resize(std::min(count, bytes.size()));
  return std::accumulate(bytes.begin(), bytes.end(), std::uint64_t{0});
}

double gib(std::uint64_t bytes) { return static_cast<double>(bytes) / (1U << 30U); }

}  // namespace

std::uint64_t physical_memory() {
  return static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

void check_picture_fits(const PixelWindow& window, std::uint64_t memory, std::uint64_t maps) {
  const std::uint64_t needed = 2 * bytes_of(window) + maps;
  if (needed <= memory) return;
  throw LimitError(
      fmt::format("a picture of {}x{} pixels{} takes {:.1f} GiB of memory, and this machine has {:.1f} GiB; render and "
                  "simulate make a part of the picture with --window X,Y,COLUMNS,ROWS",
                  window.columns, window.rows, maps > 0 ? " with its maps" : "", gib(needed), gib(memory)));
}

void check_pictures_fit(const std::vector<PixelWindow>& pictures, const std::vector<PixelWindow>& references,
                        int at_once, std::uint64_t memory) {
  for (const PixelWindow& picture : pictures) check_picture_fits(picture, memory);
  const auto count = static_cast<std::size_t>(at_once);
  const std::uint64_t needed = bytes_of_largest(pictures, count) + bytes_of_largest(references, count);
  if (needed <= memory) return;
  throw LimitError(
      fmt::format("{} pictures at the same time take {:.1f} GiB of memory with their references, and this machine has "
                  "{:.1f} GiB; a smaller --jobs takes less memory",
                  at_once, gib(needed), gib(memory)));
}

}  // namespace pyrasim
