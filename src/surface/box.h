// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <variant>

#include "numeric/compensated.h"
#include "surface/bounding_box.h"
#include "surface/distance_range.h"
#include "surface/flat_shading.h"
#include "surface/preparation.h"
#include "surface/reading.h"
#include "surface/surface.h"
#include "surface/surface_coordinates.h"
#include "surface/view_ray.h"

namespace pyrasim {

/// The space between two parallel planes, lower <= normal . p <= upper.
template <class Scalar>
struct Slab {
  Vector<Scalar> normal;
  Scalar lower;
  Scalar upper;

  template <class Other, class Number>
  Slab<Other> mapped(const Number& number) const {
    return {number(normal, 0), number(lower, 1), number(upper, 1)};
  }
};

/// Of the faces of each slab.
template <class Scalar>
struct BoxShading {
  std::array<FlatShading<Scalar>, 3> faces;

  template <class Other, class Number>
  BoxShading<Other> mapped(const Number& number) const {
    return {{faces[0].template mapped<Other>(number), faces[1].template mapped<Other>(number),
             faces[2].template mapped<Other>(number)}};
  }
};

/// The surface of what three slabs have in common.
template <class Scalar>
struct BoxSurface {
  static constexpr SurfaceTraits traits{.name = "box", .default_cost = 3, .extent = Extent::bounded};
  using Terms = const ViewRay<Scalar>&;
  using Shading = BoxShading<Scalar>;

  std::array<Slab<Scalar>, 3> slabs;
  SurfaceIdentity identity{};

  Scalar intersect(const ViewRay<Scalar>& ray) const;
  Scalar shade(const Shading& shading, const Lighting<Scalar>&, const Vector<Scalar>& direction, Scalar t) const;
  Vector<Scalar> outward(const Shading& shading, const Vector<Scalar>& direction, Scalar t) const;

  /// The same surface for rays that start at `place` instead of the origin.
  BoxSurface seen_from(const Vector<Scalar>& place) const {
    BoxSurface moved = *this;
    for (Slab<Scalar>& slab : moved.slabs) {
      const Scalar away = compensated_dot(slab.normal, place);
      slab.lower = slab.lower - away;
      slab.upper = slab.upper - away;
    }
    return moved;
  }

  template <class Other, class Number>
  BoxSurface<Other> mapped(const Number& number) const {
    return {{slabs[0].template mapped<Other>(number), slabs[1].template mapped<Other>(number),
             slabs[2].template mapped<Other>(number)},
            identity};
  }
};

double reach(const BoxSurface<double>& box);
double relative_error(const BoxSurface<double>& box, const RoundingUnits& rounding);
DistanceRange distance_range(const BoxSurface<double>& box, const Vector<double>& direction, double t,
                             const RoundingUnits& rounding);
std::optional<BoundingBox> slope_bounds(const BoxSurface<double>& box, double margin);
std::optional<BoundingBox> bounds(const BoxSurface<double>& box);

class AffineMap;
struct Parallelepiped;

/// A box along the world's axes, seen from outside and inside.
struct Box {
  static constexpr std::string_view type = "box";
  static constexpr std::array<std::string_view, 2> keys{"min", "max"};

  glm::dvec3 min;
  glm::dvec3 max;  ///< each component larger than that of min

  static Box read(const JsonReader& reader, const SceneReading& reading);
  Prepared<BoxSurface> prepared(const Preparation& preparation) const;
  std::variant<Box, Parallelepiped> transformed(const AffineMap& map) const;
  SurfaceCoordinates coordinates_at(const glm::dvec3& point) const;
  void write_pov(PovWriter& pov) const;
};

/// Between which t a view ray is in the slab; lower > upper where it never is.
template <class Scalar>
struct SlabPassage {
  Scalar enter;
  Scalar leave;
  bool parallel;  ///< the ray is in it for ever, or never

  SlabPassage(const Slab<Scalar>& slab, const Vector<Scalar>& direction) {
    const Scalar approach = compensated_dot(slab.normal, direction);
    parallel = approach == Scalar(0);
    const Scalar to_lower = parallel ? Scalar(0) : slab.lower / approach;
    const Scalar to_upper = parallel ? Scalar(0) : slab.upper / approach;
    enter = std::min(to_lower, to_upper);
    leave = std::max(to_lower, to_upper);
  }
};

/// The smallest t > 0 at which the view ray meets a face, or 0 where there is none: it enters the box once it is in all
/// slabs (Kay, Kajiya, Ray Tracing Complex Scenes, SIGGRAPH 1986), edges included. From inside, and from a face, it is
/// where the ray leaves.
template <class Scalar>
Scalar BoxSurface<Scalar>::intersect(const ViewRay<Scalar>& ray) const {
  bool any = false;
  Scalar enter{0};
  Scalar leave{0};
  for (const Slab<Scalar>& slab : slabs) {
    const SlabPassage<Scalar> passage(slab, ray.direction);
    if (passage.parallel) {
      if (slab.lower > Scalar(0) || slab.upper < Scalar(0)) return Scalar(0);
      continue;
    }
    enter = any ? std::max(enter, passage.enter) : passage.enter;
    leave = any ? std::min(leave, passage.leave) : passage.leave;
    any = true;
  }
  if (!(enter <= leave)) return Scalar(0);
  if (enter > Scalar(0)) return enter;
  return leave > Scalar(0) ? leave : Scalar(0);
}

/// visit(number, passage) for each slab by whose face the ray meets the box at t: several on an edge.
template <class Scalar>
void for_each_slab_met(const BoxSurface<Scalar>& box, const Vector<Scalar>& direction, Scalar t, const auto& visit) {
  for (std::size_t k = 0; k < box.slabs.size(); ++k) {
    const SlabPassage<Scalar> passage(box.slabs[k], direction);
    if (!passage.parallel && (passage.enter == t || passage.leave == t)) visit(k, passage);
  }
}

/// That of the face whose plane the ray meets at t; on an edge the brighter one, whichever way the axes are named.
template <class Scalar>
Scalar BoxSurface<Scalar>::shade(const Shading& shading, const Lighting<Scalar>&, const Vector<Scalar>& direction,
                                 Scalar t) const {
  Scalar brightest{0};
  for_each_slab_met(*this, direction, t, [&](std::size_t k, const SlabPassage<Scalar>&) {
    brightest = std::max(brightest, shading.faces[k].seen_along(direction));
  });
  return brightest;
}

/// That of the face whose plane the ray meets at t; on an edge the one that the ray meets at the steeper angle.
template <class Scalar>
Vector<Scalar> BoxSurface<Scalar>::outward(const Shading& shading, const Vector<Scalar>& direction, Scalar t) const {
  Scalar steepest{-1};
  Vector<Scalar> normal{0, 0, 0};
  for_each_slab_met(*this, direction, t, [&](std::size_t k, const SlabPassage<Scalar>& passage) {
    const Vector<Scalar>& upper = shading.faces[k].normal;
    const Scalar along = dot(upper, direction);
    const Scalar steep = along < Scalar(0) ? -along : along;
    if (!(steep > steepest)) return;
    steepest = steep;
    normal = (along > Scalar(0)) == (t == passage.leave) ? upper : -upper;
  });
  return normal;
}

}  // namespace pyrasim
