// SPDX-License-Identifier: Apache-2.0
// Raw integers that make a fixed-point format show its corners.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <random>

namespace pyrasim {

/// Raw values within [smallest, largest] of a format with `fraction_bits`. Seeds are fixed.
class FixOperands {
 public:
  FixOperands(std::int64_t smallest, std::int64_t largest, int fraction_bits, std::uint64_t seed)
      : smallest_(smallest), largest_(largest), fraction_bits_(fraction_bits), random_(seed) {}

  std::int64_t operator()() {
    switch (draw(0, 7)) {
      case 0: {
        const std::int64_t one = std::int64_t{1} << std::min(fraction_bits_, 61);  // 3/2 of it fits, and -1 of it
        const std::array corners{smallest_,
                                 smallest_ + 1,
                                 largest_,
                                 largest_ - 1,
                                 std::int64_t{0},
                                 std::int64_t{1},
                                 std::int64_t{-1},
                                 std::min(one, largest_),
                                 std::max(-one, smallest_),
                                 std::min(3 * (one / 2), largest_),
                                 largest_ / 2 + 1,
                                 std::max(-one / 2, smallest_)};
        return corners.at(static_cast<std::size_t>(draw(0, std::ssize(corners) - 1)));
      }
      case 1:  // few bits: exact results and ties
        return draw(-8, 8) << draw(0, std::max(bits() - 4, 0));
      case 2:
        return draw(smallest_, largest_);
      default:  // any size, sums and products within the range mostly
        return draw(smallest_, largest_) >> draw(0, bits());
    }
  }

  std::int64_t draw(std::int64_t first, std::int64_t last) {
    return std::uniform_int_distribution<std::int64_t>(first, last)(random_);
  }

 private:
  int bits() const { return static_cast<int>(std::bit_width(static_cast<std::uint64_t>(largest_))); }

  std::int64_t smallest_, largest_;
  int fraction_bits_;
  std::mt19937_64 random_;
};

}  // namespace pyrasim
