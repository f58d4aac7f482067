// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "polynomial_roots.h"

namespace pyrasim {

/// A torus seen from the ray's origin, by the roots of (|p|^2 + R^2 - r^2)^2 = 4 R^2 (|p|^2 - z^2).
template <class Number>
struct TorusOracle {
  using Triple = std::array<Number, 3>;

  Triple center;
  Triple axis;  ///< of any length
  Number major;
  Number minor;

  static Number dot(const Triple& a, const Triple& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

  /// The ray's parameter where it comes nearest to the centre.
  Number nearest(const Triple& direction) const { return dot(center, direction) / dot(direction, direction); }

  /// The smallest t > 0 of a place on the torus.
  std::optional<Number> first_hit(const Triple& direction) const {
    const auto [start, reach, from_center, from_axis] = along(direction);
    Polynomial<Number> sum = from_center;
    sum[0] = sum[0] + major * major - minor * minor;
    Polynomial<Number> quartic = product(sum, sum);
    for (std::size_t k = 0; k < 3; ++k) quartic[k] = quartic[k] - Number(4) * major * major * from_axis[k];
    for (const Number& s : roots_between(quartic, -reach, reach)) {
      if (start + s > Number(0)) return start + s;
    }
    return std::nullopt;
  }

  /// The ray's least distance from the middle of the tube, less its radius: where the change of |p|^2 is that of
  /// 2 R rho, or minus that, which does no harm.
  Number least_distance(const Triple& direction) const {
    using std::sqrt;
    const auto [start, reach, from_center, from_axis] = along(direction);
    const Polynomial<Number> slope = derivative(from_center);
    const Polynomial<Number> across = derivative(from_axis);
    Polynomial<Number> changes = product(product(slope, slope), from_axis);
    const Polynomial<Number> square = product(across, across);
    for (std::size_t k = 0; k < 3; ++k) changes[k] = changes[k] - major * major * square[k];
    const auto distance = [&, &of_center = from_center, &of_axis = from_axis](const Number& s) {
      const Number rho_squared = value_at(of_axis, s);
      const Number rho = rho_squared > Number(0) ? Number(sqrt(rho_squared)) : Number(0);
      const Number height_squared = value_at(of_center, s) - rho_squared;
      const Number squared = (rho - major) * (rho - major) + height_squared;
      return (squared > Number(0) ? Number(sqrt(squared)) : Number(0)) - minor;
    };
    Number least = distance(Number(0));
    for (const Number& s : roots_between(changes, -reach, reach)) {
      const Number there = distance(s);
      if (there < least) least = there;
    }
    return least;
  }

 private:
  /// |p|^2 and rho^2, the squares of the distances from the centre and from the axis, about `start`.
  struct Along {
    Number start, reach;  ///< further from it there is nothing
    Polynomial<Number> from_center, from_axis;
  };
  Along along(const Triple& direction) const {
    using std::sqrt;
    const Number start = nearest(direction);
    Triple place;
    for (std::size_t k = 0; k < 3; ++k) place[k] = direction[k] * start - center[k];
    const Number length = sqrt(dot(axis, axis));
    const Number height = dot(axis, place) / length;
    const Number rise = dot(axis, direction) / length;
    const Number squared = dot(direction, direction);
    const Polynomial<Number> from_center{dot(place, place), Number(2) * dot(place, direction), squared};
    const Polynomial<Number> from_axis{from_center[0] - height * height, from_center[1] - Number(2) * height * rise,
                                       from_center[2] - rise * rise};
    return {start, Number(2) * (major + minor) / sqrt(squared), from_center, from_axis};
  }
};

}  // namespace pyrasim
