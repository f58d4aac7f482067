// SPDX-License-Identifier: Apache-2.0
#include "intersect/instanced_triangle.h"

#include "numeric/vectors.h"
#include "surface/error_bounds.h"

namespace pyrasim {
namespace {

/// How far the ray, as the datapath has it, lies at `t` from where it is exactly, in each coordinate of the instance: a
/// component of its direction errs by the rounding of three numbers, of their products and of two sums.
double ray_error(const InstancedHit& hit, const Vector<double>& direction, double t, const RoundingUnits& rounding) {
  const double u = rounding.relative;
  const double a = rounding.absolute;
  const double component = 4 * u * largest(hit.terms) + a * (sum(magnitudes(direction)) + 3);
  return component * t;
}

/// What its numbers say of the instance: those of the mesh; of the observer's place, whose way to the mesh is exact to
/// 113 bits; and of his axes, of which each number errs by 4 roundings of double at most. No length is longer in the
/// instance's coordinates.
double written_error(const InstancedHit& hit, const RoundingUnits& rounding) {
  return 0x1p-53 * (13 * hit.within.reach + rounding.place) + hit.within.written;
}

}  // namespace

DistanceRange distance_range(const InstancedHit& hit, const Vector<double>& direction, double t,
                             const RoundingUnits& rounding) {
  const double u = rounding.relative;
  const double a = rounding.absolute;
  const double written = written_error(hit, rounding);
  const double displaced =
      (u * hit.vertex + 2 * a) + (u * hit.origin + a) + ray_error(hit, direction, t, rounding) + written;
  const double error = distance_error(hit.placed, hit.direction, t, displaced * second_order(rounding), rounding);
  const auto box = bounds(hit.placed);
  const BoxHierarchy::Query query(glm::dvec3(0), hit.direction, hit.within.margin / 2);
  DistanceRange range{std::max(t - error, std::min(t, BoxHierarchy::entered(*box, query))), t + error};
  const BoundingBox whole = box_of(corners_of(hit.within.enclosure));
  return within_bounds(range, whole.lower.x - written, whole.upper.x + written, direction);
}

}  // namespace pyrasim
