// SPDX-License-Identifier: Apache-2.0
// What a scene's transforms are: p -> matrix p + offset, in 113 bits, so that a chain of them is rounded once, where a
// surface's numbers become double again.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "numeric/quadruple.h"

namespace pyrasim {

using QuadrupleMatrix = std::array<QuadrupleVector, 3>;  ///< rows

/// A map, or a surface under one, that cannot be had; in the two parts of an input error.
struct MapError : std::runtime_error {
  MapError(const std::string& wrong, std::string what) : std::runtime_error(wrong), allowed(std::move(what)) {}
  std::string allowed;
};

/// Some direction may be stretched so much more than another.
inline constexpr double max_unevenness = 1e6;

class AffineMap {
 public:
  AffineMap() = default;
  /// Throws MapError where `matrix` is singular, or stretches a direction more than max_unevenness times as much as
  /// another.
  AffineMap(const QuadrupleMatrix& matrix, const QuadrupleVector& offset);

  static AffineMap translation(const glm::dvec3& by);
  static AffineMap scaling(const glm::dvec3& by);
  /// Right-handed about an axis through the origin, of any length but zero. Quarter turns are exact.
  static AffineMap rotation(const glm::dvec3& axis, double degrees);

  QuadrupleVector point(const QuadrupleVector& p) const;
  /// Of a difference of points.
  QuadrupleVector direction(const QuadrupleVector& v) const;
  /// Of a plane's normal: by the inverse matrix, transposed.
  QuadrupleVector normal(const QuadrupleVector& n) const;
  const QuadrupleVector& offset() const { return offset_; }
  /// Rows of the inverse matrix.
  const QuadrupleMatrix& inverse() const { return inverse_; }

  /// How many times as long lengths become, where that is the same in all directions to what rounding the matrix to
  /// double may leave.
  std::optional<Quadruple> similarity() const;
  /// Whether lines along the axes stay that.
  bool keeps_axes() const;
  /// How many times as much as another a direction is stretched, at most.
  double unevenness() const { return unevenness_; }

  /// First `inner`, then this.
  AffineMap after(const AffineMap& inner) const;

 private:
  QuadrupleMatrix matrix_{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  QuadrupleMatrix inverse_{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  QuadrupleVector offset_{0, 0, 0};
  double unevenness_ = 1;
};

/// Rounded, where it is within the coordinates and lengths that scenes may have. These throw MapError.
glm::dvec3 mapped_point(const AffineMap& map, const glm::dvec3& point);
double mapped_length(Quadruple length);
/// Of triangles that rounding leaves without an area.
[[noreturn]] void fail_without_area();
/// Of a shape that only a similarity keeps: its factor.
Quadruple required_similarity(const AffineMap& map, const std::string& shape, const std::string& becomes);

}  // namespace pyrasim
