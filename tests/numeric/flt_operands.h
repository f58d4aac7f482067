// SPDX-License-Identifier: Apache-2.0
// Operands that make a floating-point format show its corners.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace pyrasim {

/// Values of the format with `exponent_bits` and `significand_bits`, as doubles. Seeds are fixed.
class FltOperands {
 public:
  FltOperands(int exponent_bits, int significand_bits, std::uint64_t seed)
      : largest_exponent_((1 << (exponent_bits - 1)) - 1), bits_(significand_bits), random_(seed) {
    const double spacing = value(1, smallest());
    const double normal = std::ldexp(1.0, smallest());
    const double largest = value((std::int64_t{1} << bits_) - 1, largest_exponent_);
    const double unit = std::ldexp(1.0, 1 - bits_);
    for (const double x :
         {0.0, spacing, 2 * spacing, 3 * spacing, normal - spacing, normal, normal + spacing, normal / 2, 1.0, 1 + unit,
          1 - unit / 2, 2 - unit, 1.5, 0.5, 3.0, largest, std::ldexp(1.0, largest_exponent_),
          std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
      if (std::isfinite(x) && std::remainder(x, spacing) != 0) continue;  // with 2 bits of exponent 1 - unit / 2
      corners_.push_back(x);
      corners_.push_back(-x);
    }
  }

  const std::vector<double>& corners() const { return corners_; }

  /// Every value of the format but NaN; for formats of a few bits.
  std::vector<double> all() const {
    std::vector<double> values;
    for (std::int64_t n = 0; n < std::int64_t{1} << bits_; ++n) {
      for (int exponent = smallest(); exponent <= largest_exponent_; ++exponent) {
        if (n < std::int64_t{1} << (bits_ - 1) && exponent > smallest()) continue;
        values.push_back(value(n, exponent));
        values.push_back(-value(n, exponent));
      }
    }
    values.push_back(std::numeric_limits<double>::infinity());
    values.push_back(-std::numeric_limits<double>::infinity());
    return values;
  }

  /// Any value, corners often.
  double any() {
    if (draw(0, 15) == 0) return corners_[static_cast<std::size_t>(draw(0, std::ssize(corners_) - 1))];
    return of_exponent(exponent());
  }

  /// A second operand: half of them such that sums, products or quotients of the two meet an edge or each other.
  double partner(double a) {
    if (!std::isfinite(a) || a == 0) return any();
    const int same = std::ilogb(a);
    switch (draw(0, 7)) {
      case 0:
      case 1:  // sums that overlap, cancel, or are a tie
        return of_exponent(same + static_cast<int>(draw(-bits_ - 2, bits_ + 2)));
      case 2:  // products about the smallest normal number and below
        return of_exponent(smallest() - same + static_cast<int>(draw(-bits_ - 2, 2)));
      case 3:  // quotients there
        return of_exponent(same - smallest() + static_cast<int>(draw(-2, bits_ + 2)));
      case 4:  // overflow
        return of_exponent((draw(0, 1) == 0 ? largest_exponent_ - same : same - largest_exponent_) +
                           static_cast<int>(draw(-1, 1)));
      default:
        return any();
    }
  }

  /// A double to convert: 53 bits near the format's range, or the midpoint of two neighbours and doubles next to it.
  double to_convert() {
    const double near = any();
    if (draw(0, 3) == 0 || !std::isfinite(near) || near == 0) return near;
    const int place = std::max(std::ilogb(near), smallest()) - bits_;
    if (draw(0, 1) == 0) {
      const double tie = near + std::ldexp(1.0, place);
      const auto which = draw(-1, 1);
      return which == 0 ? tie : std::nextafter(tie, which < 0 ? -1e308 : 1e308);
    }
    return near * (1 + std::ldexp(static_cast<double>(draw(0, (std::int64_t{1} << 52) - 1)), -52));
  }

 private:
  int smallest() const { return 1 - largest_exponent_; }
  std::int64_t draw(std::int64_t first, std::int64_t last) {
    return std::uniform_int_distribution<std::int64_t>(first, last)(random_);
  }
  double value(std::int64_t n, int exponent) const { return std::ldexp(static_cast<double>(n), exponent - bits_ + 1); }

  int exponent() {
    const int range = draw(0, 1) == 0 ? largest_exponent_ : std::min(largest_exponent_, bits_);
    return static_cast<int>(draw(-range - (range == largest_exponent_ ? bits_ : 0), range));
  }

  /// Random sign and significand; one in four has few bits, so that results are exact or ties.
  double of_exponent(int exponent) {
    std::int64_t n = draw(std::int64_t{1} << (bits_ - 1), (std::int64_t{1} << bits_) - 1);
    if (draw(0, 3) == 0) n &= ~((std::int64_t{1} << draw(0, bits_ - 1)) - 1);
    exponent = std::min(exponent, largest_exponent_);
    const int below = smallest() - exponent;
    if (below > 0) {
      n >>= std::min(below, bits_ - 1);
      exponent = smallest();
    }
    return (draw(0, 1) == 0 ? 1 : -1) * value(n, exponent);
  }

  int largest_exponent_;
  int bits_;
  std::mt19937_64 random_;
  std::vector<double> corners_;
};

}  // namespace pyrasim
