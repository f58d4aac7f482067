// SPDX-License-Identifier: Apache-2.0
#include "intersect/instanced_triangle.h"

#include "numeric/vectors.h"
#include "surface/error_bounds.h"

namespace pyrasim {
namespace {

/// How far the ray, as the datapath has it, lies at the exact hit from where it is exactly, in each coordinate of the
/// instance: a component of its direction errs by the rounding of three numbers, of their products and of two sums. Up
/// to the hit it runs no further than the instance reaches.
double ray_error(const InstancedHit& hit, const Vector<double>& direction, const RoundingUnits& rounding) {
  const double u = rounding.relative;
  const double a = rounding.absolute;
  const double component = 4 * u * largest(hit.terms) + a * (sum(magnitudes(direction)) + 3);
  return component * hit.within.reach / largest(direction);
}

/// What its numbers say of the instance: those of the mesh, of the map, and of the observer's frame.
double written_error(const InstancedHit& hit, const RoundingUnits& rounding) {
  return 2 * rounding.written(hit.within.reach) + hit.within.written;
}

}  // namespace

DistanceRange distance_range(const InstancedHit& hit, const Vector<double>& direction, double t,
                             const RoundingUnits& rounding) {
  const double u = rounding.relative;
  const double a = rounding.absolute;
  const double written = written_error(hit, rounding);
  const double displaced =
      (u * hit.vertex + 2 * a) + (u * hit.origin + a) + ray_error(hit, direction, rounding) + written;
  const double error = distance_error(hit.placed, hit.direction, t, displaced * second_order(rounding), rounding);
  const auto box = bounds(hit.placed);
  const BoxHierarchy::Query query(glm::dvec3(0), hit.direction, hit.within.margin / 2);
  DistanceRange range{std::max(t - error, std::min(t, BoxHierarchy::entered(*box, query))), t + error};
  const BoundingBox whole = box_of(corners_of(hit.within.enclosure));
  return within_bounds(range, whole.lower.x - written, whole.upper.x + written, direction);
}

}  // namespace pyrasim
