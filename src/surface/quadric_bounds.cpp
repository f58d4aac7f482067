// SPDX-License-Identifier: Apache-2.0
#include "surface/quadric_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "numeric/vectors.h"
#include "surface/plane_distance.h"
#include "surface/quadric_range.h"
#include "surface/quadric_steps.h"
#include "surface/slope_bounds.h"

namespace pyrasim {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// By how much the numbers of a quadric err, as the datapath holds them, and its direction m as it works it out.
QuadricErrors errors_of(const QuadricForm<double>& form, const Vector<double>& direction, double size,
                        const RoundingUnits& rounding) {
  const double u = rounding.relative;
  const double a = rounding.absolute;
  const auto d = magnitudes(direction);
  QuadricErrors errors{};
  double steepness = 0;  // how fast q changes about the observer
  for (int k = 0; k < 3; ++k) {
    const auto axis = magnitudes(form.axes[static_cast<std::size_t>(k)]);
    const double length = largest(axis);
    if (length == 0 && form.origin[k] == 0) continue;
    errors.direction[k] =
        second_order(rounding) * (4 * u * dot(axis, d) + (a + 22 * 0x1p-53 * length + form.tilt) * sum(d) + 3 * a);
    errors.origin[k] = u * std::abs(form.origin[k]) + a + rounding.written(size) + form.tilt * size;
    if (form.drift > 0) errors.origin[k] += form.drift / length;
    if (form.linear != 0 && k == 2) errors.origin[k] += form.written / (2 * std::abs(form.linear));
    steepness += 2 * length * std::abs(form.signs[k] * form.origin[k] + (k == 2 ? form.linear : 0));
  }
  errors.linear = form.linear == 0 ? 0 : (u + 0x1p-51) * std::abs(form.linear) + a;
  errors.constant = form.constant == 0 ? 0 : (u + 0x1p-51) * std::abs(form.constant) + a + form.written;
  const double written = form.written + steepness * rounding.written(size);
  errors.power = form.power == 0 ? 0 : u * std::abs(form.power) + a + written;
  return errors;
}

BoundingPlane bounding_plane(const HalfSpace<double>& half_space, double size, double tilt,
                             const RoundingUnits& rounding) {
  const auto& [normal, offset] = half_space;
  return {normal, offset, 3 * largest(normal) * rounding.written(size) + 3 * tilt * size, tilt};
}

StretchRanges kept_by(std::span<const HalfSpace<double>> clip, const Vector<double>& direction, double size,
                      double tilt, const RoundingUnits& rounding) {
  StretchRanges kept;
  for (const HalfSpace<double>& half_space : clip) {
    const auto& [normal, offset] = half_space;
    const BoundingPlane plane = bounding_plane(half_space, size, tilt, rounding);
    const DistanceRange range = signed_plane_distance_range(plane, direction, rounding);
    const double approach = dot(normal, direction);
    if (range.highest == infinity && certain_side(plane, rounding)) {
      // Nearly parallel: which way it passes the plane is not known, but which side the observer is on.
      const double least = plane_distance_range(plane, direction, rounding).lowest;
      if (offset < 0) return {{least, infinity}, {-infinity, infinity}};
      kept.keep_from({-infinity, -least});
      kept.keep_to({least, infinity});
    } else if (approach > 0) {
      kept.keep_to(range);
    } else {
      kept.keep_from(range);
    }
  }
  return kept;
}

/// `box`: bounds(quadric).
double reach(const QuadricView& quadric, const std::optional<BoundingBox>& box) {
  double reach = std::max(largest(quadric.form.origin), std::sqrt(std::abs(quadric.form.constant)));
  reach = std::max(reach, std::abs(quadric.form.linear));
  for (const auto& plane : quadric.clip) reach = std::max(reach, std::abs(plane.offset));
  return box ? std::max(reach, box->reach()) : reach;
}

}  // namespace

double reach(const QuadricView& quadric) { return reach(quadric, bounds(quadric)); }

std::optional<BoundingBox> bounds(const QuadricView& quadric) {
  if (quadric.enclosure == nullptr) return std::nullopt;
  return box_of(corners_of(*quadric.enclosure));
}

std::optional<BoundingBox> slope_bounds(const QuadricView& quadric, double margin) {
  if (quadric.enclosure == nullptr) return std::nullopt;
  return slope_bounds_of_hull(corners_of(*quadric.enclosure), margin);
}

double unevenness(const QuadricForm<double>& form) {
  if (form.constant == 0 && form.linear == 0) return std::numbers::sqrt2;
  double least = 1;
  for (int k = 0; k < 3; ++k) {
    if (form.signs[k] != 0) least = std::min(least, length(form.axes[static_cast<std::size_t>(k)]));
  }
  return 1 / least;
}

bool has_generators(const QuadricForm<double>& form) {
  const auto& s = form.signs;
  return s.x == 0 || s.x != s.y || s.x != s.z;
}

/// h is the sum that both roots come from. At a root t of a t^2 + 2 b t + c one of |a| t^2 and 2 |b| t is |c| / 2 or
/// more, so that h is no less than |c| / (4 t), and no ray meets the surface further away than its furthest corner. h
/// errs by b's error and the root of the discriminant's, 40 and 400 roundings of the sizes that enter; a by 10.
double relative_error(const QuadricView& quadric, const RoundingUnits& rounding) {
  const QuadricForm<double>& form = quadric.form;
  if (!quadric.convex || quadric.enclosure == nullptr || form.power == 0) return infinity;
  const double size = reach(quadric);
  const double furthest = 2 * size;  // of a corner: at most the root of 3 times as far
  const double written = rounding.written(size);
  const double from_origin = std::max({length(form.origin), std::sqrt(std::abs(form.constant)), std::abs(form.linear)});
  const double unit =
      rounding.relative + 22 * 0x1p-53 + (written + form.tilt * size + 4 * rounding.absolute) / from_origin;
  const double power = std::abs(form.power);
  const double h = 4 * furthest * from_origin * (40 * unit + 20 * std::sqrt(unit)) / power;
  const double a = 40 * unit * furthest * furthest / power;
  const double c = (form.written + 6 * from_origin * written) / power;
  double error = if_of_use(2 * (h + a + c), rounding);
  for (const HalfSpace<double>& half_space : quadric.clip) {
    const BoundingPlane plane = bounding_plane(half_space, size, form.tilt, rounding);
    error = std::max(error, plane_error(plane, rounding).within(furthest));
  }
  return error;
}

DistanceRange distance_range(const QuadricView& quadric, const Vector<double>& direction, double t,
                             const RoundingUnits& rounding) {
  const auto box = bounds(quadric);
  const double size = reach(quadric, box);
  const StretchRanges kept = kept_by(quadric.clip, direction, size, quadric.form.tilt, rounding);
  const QuadricErrors errors = errors_of(quadric.form, direction, size, rounding);
  const QuadricRootRanges roots = QuadricSteps(quadric.form, direction, errors, rounding).roots(kept);
  const FirstHitRange first = first_hit_range(roots, kept, quadric.capped);
  DistanceRange range{t, t};
  if (first.possible()) range = {std::min(t, first.range().lowest), std::max(t, first.range().highest)};
  if (!box) return range;
  const double margin = 4 * rounding.relative * size + 2 * rounding.absolute + rounding.written(size);
  return within_bounds(range, box->lower.x - margin, box->upper.x + margin, direction);
}

}  // namespace pyrasim
