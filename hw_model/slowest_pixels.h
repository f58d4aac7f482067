// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "hw_model/cycle.h"

namespace pyrasim::hw {

/// A pixel that has been finished.
struct FinishedPixel {
  std::uint32_t pixel = 0;    ///< row * columns + column, inside the window
  std::uint32_t deepest = 0;  ///< level in its trace tree
  Cycle latency = 0;
  friend bool operator==(const FinishedPixel&, const FinishedPixel&) = default;
};

/// The few pixels that took longest, the slowest first; of those that took equally long, the ones finished first.
class SlowestPixels {
 public:
  static constexpr std::size_t most = 5;

  void add(const FinishedPixel& pixel) {
    if (pixel.latency > pixels_.back().latency) insert(pixel);
  }
  std::span<const FinishedPixel> list() const { return std::span(pixels_).first(count_); }

 private:
  [[gnu::noinline]] void insert(const FinishedPixel& pixel) {
    count_ = std::min(count_ + 1, most);
    std::size_t place = count_ - 1;
    for (; place > 0 && pixel.latency > pixels_[place - 1].latency; --place) pixels_[place] = pixels_[place - 1];
    pixels_[place] = pixel;
  }

  std::array<FinishedPixel, most> pixels_;  ///< of latency 0 where there is none: no pixel takes so little
  std::size_t count_ = 0;
};

}  // namespace pyrasim::hw
