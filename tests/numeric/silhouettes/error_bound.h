// SPDX-License-Identifier: Apache-2.0
// How far the datapath's numbers may lie from the exact ones: forward error bounds of the kernels in src/surface,
// term by term, for rays along (1, y, z) and scenes as ExactScene takes them.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "ray.h"
#include "rounding.h"
#include "surface/instance.h"
#include "surface/quadric_bounds.h"
#include "surface/quadric_range.h"
#include "surface/surface.h"
#include "surface/torus.h"

namespace pyrasim::silhouettes {

/// Of SphereSurface::intersect().
struct SphereBound {
  double discriminant;  ///< a ray hits where it is not negative
  double along;         ///< and where the centre's component along the ray is positive
  double t;             ///< of the hit
};
SphereBound error_bound(const SphereSurface<double>& sphere, const Ray& ray, const Rounding& rounding);

/// Of PlaneSurface::intersect(): of n . d, whose sign decides, and the range of t.
struct PlaneBound {
  double approach;
  double lowest_t, highest_t;
};
PlaneBound error_bound(const PlaneSurface<double>& plane, const Ray& ray, const Rounding& rounding);

/// Of DiscSurface::intersect(): of its plane, and of the radius' square less that of the distance from the centre.
struct DiscBound {
  PlaneBound plane;
  double room;
};
/// `t` is exact, that of its plane.
DiscBound error_bound(const DiscSurface<double>& disc, double t, const Ray& ray, const Rounding& rounding);

/// Of BoxSurface::intersect(): of t where the ray enters, and where it leaves.
struct BoxBound {
  double enter, leave;
};
BoxBound error_bound(const BoxSurface<double>& box, const Ray& ray, const Rounding& rounding);

/// Of QuadricShape::intersect(): where it may be hit first. The quadric is in the datapath's unit, and `discriminant`,
/// likewise, is exact.
FirstHitRange quadric_bound(const QuadricView& quadric, double discriminant, const Ray& ray, const Rounding& rounding);

/// Of TorusSurface::intersect(): where it may be hit first. The torus is in the datapath's unit, and so is `least`, the
/// ray's least distance from the middle of its tube less the tube's radius, which is exact.
FirstHitRange torus_bound(const TorusSurface<double>& torus, double least, const Ray& ray, const Rounding& rounding);

/// Of TriangleSurface::intersect(): of the three edge functions, whose signs decide, and the range of t, where it
/// counts as hit.
struct TriangleBound {
  std::array<double, 3> edges;
  bool beside;              ///< the ray certainly passes the bounds of the vertices
  double below_t, above_t;  ///< by how much less or more t may be than the exact one, that of the triangle's plane
};
/// `edges` and `t` are exact.
TriangleBound error_bound(const TriangleSurface<double>& triangle, const std::array<double, 3>& edges, double t,
                          const Ray& ray, const Rounding& rounding);

/// Of the same for a triangle of an instance, with the shear along the instance's axis `axis`; none where the datapath
/// may make anything of it. `edges` are m . (q x p) for the vertices p and q in the instance's coordinates and the
/// ray's direction m there.
std::optional<TriangleBound> error_bound(const InstanceSurface<double>& instance,
                                         const TriangleSurface<double>& triangle, std::size_t axis,
                                         const std::array<double, 3>& edges, double t, const Ray& ray,
                                         const Rounding& rounding);
/// Along which of the instance's axes the datapath may shear a ray's direction there: its largest component is.
std::vector<std::size_t> shear_axes(const InstanceSurface<double>& instance, const Ray& ray, const Rounding& rounding);

}  // namespace pyrasim::silhouettes
