// SPDX-License-Identifier: Apache-2.0
#include "surface/clip_box.h"

#include <cmath>
#include <vector>

namespace pyrasim {
namespace {

ExactHalfSpace of_length_one(const ExactHalfSpace& half_space) {
  return {unit(half_space.normal), half_space.offset / length(half_space.normal)};
}

/// Where three planes meet; none where they do not, or nearly do not.
std::optional<QuadrupleVector> corner(const ExactHalfSpace& a, const ExactHalfSpace& b, const ExactHalfSpace& c) {
  const QuadrupleVector bc = cross(b.normal, c.normal);
  const QuadrupleVector ca = cross(c.normal, a.normal);
  const QuadrupleVector ab = cross(a.normal, b.normal);
  const Quadruple volume = dot(a.normal, bc);
  if (volume * volume < 0x1p-120) return std::nullopt;
  QuadrupleVector point{};
  for (std::size_t k = 0; k < 3; ++k) point[k] = (a.offset * bc[k] + b.offset * ca[k] + c.offset * ab[k]) / volume;
  return point;
}

/// Rounding a corner must not lose it.
bool holds(const std::vector<ExactHalfSpace>& planes, const QuadrupleVector& point) {
  for (const auto& [normal, offset] : planes) {
    Quadruple size = magnitude(offset);
    for (const Quadruple coordinate : point) size += magnitude(coordinate);
    if (dot(normal, point) - offset > 0x1p-48 * size) return false;
  }
  return true;
}

}  // namespace

std::optional<BoundingBox> clip_box(std::span<const ExactHalfSpace> clip, const std::optional<BoundingBox>& box) {
  const BoundingBox space = box.value_or(BoundingBox{glm::dvec3(-2 * beyond_all), glm::dvec3(2 * beyond_all)});
  std::vector<ExactHalfSpace> planes;
  for (const ExactHalfSpace& half_space : clip) planes.push_back(of_length_one(half_space));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    QuadrupleVector normal{};
    normal[axis] = 1;
    planes.push_back({normal, space.upper[static_cast<int>(axis)]});
    normal[axis] = -1;
    planes.push_back({normal, -space.lower[static_cast<int>(axis)]});
  }
  BoundingBox left;
  for (std::size_t a = 0; a < planes.size(); ++a) {
    for (std::size_t b = a + 1; b < planes.size(); ++b) {
      for (std::size_t c = b + 1; c < planes.size(); ++c) {
        const auto point = corner(planes[a], planes[b], planes[c]);
        if (point && holds(planes, *point)) left.include(rounded(*point));
      }
    }
  }
  if (!(left.lower.x <= left.upper.x)) return std::nullopt;
  return left;
}

}  // namespace pyrasim
