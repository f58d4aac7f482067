// SPDX-License-Identifier: Apache-2.0
// Bounds of quadrics and of what their kernel errs by. All surfaces of the list that are quadrics have them.
#pragma once

#include <optional>
#include <span>

#include "surface/bounding_box.h"
#include "surface/distance_range.h"
#include "surface/quadric_shape.h"

namespace pyrasim {

/// Any QuadricShape, in double.
struct QuadricView {
  const QuadricForm<double>& form;
  std::span<const HalfSpace<double>> clip;
  bool capped;
  bool convex;
  const Enclosure<double>* enclosure;  ///< none: without bounds

  template <std::size_t planes>
  explicit QuadricView(const QuadricShape<double, planes>& shape)
      : form(shape.form),
        clip(shape.clip.data(), shape.clips),
        capped(shape.capped),
        convex(shape.convex),
        enclosure(shape.bounded ? &shape.enclosure : nullptr) {}
};

double reach(const QuadricView& quadric);
std::optional<BoundingBox> bounds(const QuadricView& quadric);
std::optional<BoundingBox> slope_bounds(const QuadricView& quadric, double margin);
DistanceRange distance_range(const QuadricView& quadric, const Vector<double>& direction, double t,
                             const RoundingUnits& rounding);

double relative_error(const QuadricView& quadric, const RoundingUnits& rounding);

/// Of how many times a length the quadric's frame may make another one that is as long in the world, at places of the
/// quadric, across it: of a cone, whose gradient has as much of the longest axis as of the others, the root of 2 at
/// most.
double unevenness(const QuadricForm<double>& form);
/// Whether there are directions along which it does not end, as a cylinder has.
bool has_generators(const QuadricForm<double>& form);

template <class Surface>
concept HasQuadricShape = requires(const Surface& surface) {
  QuadricView(surface.shape);
};

template <HasQuadricShape Surface>
double reach(const Surface& surface) {
  return reach(QuadricView(surface.shape));
}
template <HasQuadricShape Surface>
std::optional<BoundingBox> bounds(const Surface& surface) {
  return bounds(QuadricView(surface.shape));
}
template <HasQuadricShape Surface>
std::optional<BoundingBox> slope_bounds(const Surface& surface, double margin) {
  return slope_bounds(QuadricView(surface.shape), margin);
}
template <HasQuadricShape Surface>
DistanceRange distance_range(const Surface& surface, const Vector<double>& direction, double t,
                             const RoundingUnits& rounding) {
  return distance_range(QuadricView(surface.shape), direction, t, rounding);
}
template <HasQuadricShape Surface>
double unevenness(const Surface& surface) {
  return unevenness(surface.shape.form);
}
template <HasQuadricShape Surface>
bool has_generators(const Surface& surface) {
  return has_generators(surface.shape.form);
}
template <HasQuadricShape Surface>
double relative_error(const Surface& surface, const RoundingUnits& rounding) {
  return relative_error(QuadricView(surface.shape), rounding);
}

}  // namespace pyrasim
