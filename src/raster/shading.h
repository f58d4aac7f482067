// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>

namespace pyrasim {

/// What light makes of an object's colour at one place, in one word, so that a sample is two. The scene says which of
/// two it is: under a single `light` a factor, under a list of `lights` red, green and blue.
///
/// Those are whole numbers below 2^20 that share the unit 2^(e - 23), e from 0 to 15. Each component so errs by at most
/// 2^-21 of the largest, or by 2^-24 where that is more: a hundredth of a step of 16-bit sRGB. 0 and 1 are exact.
class Shading {
 public:
  /// Colours as they are.
  constexpr Shading() : Shading(1) {}
  /// 0 to 1.
  constexpr Shading(double factor) : word_(std::bit_cast<std::uint64_t>(factor)) {}
  /// Components of 0 and more; those above `largest_light` become that.
  explicit Shading(const glm::dvec3& light) : word_(0) {
    const double most = std::clamp(std::max({light.x, light.y, light.z}), 0x1p-23, largest_light);
    int exponent = std::max(0, std::ilogb(most) + 1 + unit_bits - static_cast<int>(component_bits));
    const auto whole = [&](double component) {
      return static_cast<std::uint64_t>(
          std::llrint(std::ldexp(std::clamp(component, 0.0, largest_light), unit_bits - exponent)));
    };
    if (whole(most) == component_values) ++exponent;  // it was rounded up
    word_ = static_cast<std::uint64_t>(exponent);
    for (unsigned k = 0; k < 3; ++k) word_ |= whole(light[static_cast<int>(k)]) << (exponent_bits + k * component_bits);
  }

  constexpr double factor() const { return std::bit_cast<double>(word_); }
  glm::dvec3 light() const {
    const double unit = std::ldexp(1.0, static_cast<int>(word_ & ((1U << exponent_bits) - 1)) - unit_bits);
    const auto component = [&](unsigned k) {
      const std::uint64_t whole = (word_ >> (exponent_bits + k * component_bits)) & (component_values - 1);
      return static_cast<double>(whole) * unit;
    };
    return {component(0), component(1), component(2)};
  }

  friend bool operator==(const Shading&, const Shading&) = default;

  /// What three components of their bits can say.
  static constexpr double largest_light = 4096 - 0x1p-8;

 private:
  static constexpr unsigned exponent_bits = 4;
  static constexpr unsigned component_bits = 20;
  static constexpr std::uint64_t component_values = 1U << component_bits;
  static constexpr int unit_bits = 23;  ///< the finest unit is 2^-23

  std::uint64_t word_;
};

}  // namespace pyrasim
