// SPDX-License-Identifier: Apache-2.0
// Watertight ray-triangle test (Woop, Benthin, Wald, Journal of Computer Graphics Techniques 2013): neighbours compute
// a shared edge from the same numbers, so a ray cannot slip between them. Edges and vertices belong to the triangle.
//
// An edge function is the difference of two rounded products, so its sign is right or it is 0, and 0 counts as inside:
// a triangle that holds the ray is hit in every format, as long as it has an area left. One that does not can be hit
// too where it is smaller than a rounding of its distance from the ray, and all its edge functions come out as 0 or of
// one sign. The bounds of its vertices tell that exactly.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>

#include "surface/bounding_box.h"
#include "surface/curved_shading.h"
#include "surface/distance_range.h"
#include "surface/flat_shading.h"
#include "surface/preparation.h"
#include "surface/reading.h"
#include "surface/smooth_normal.h"
#include "surface/surface.h"
#include "surface/surface_coordinates.h"
#include "surface/view_ray.h"

namespace pyrasim {

/// What all triangles of one ray share: the axes permuted so that the direction's largest component comes last, and the
/// shear that turns the direction into that axis.
template <class Scalar>
struct TriangleShear {
  std::size_t kx, ky, kz;
  Scalar sx, sy, sz;

  explicit TriangleShear(const ViewRay<Scalar>& ray) : TriangleShear(ray.direction) {}
  explicit TriangleShear(const Vector<Scalar>& direction) {
    using std::abs;  // or that of the number format
    const Scalar x = abs(direction.x);
    const Scalar y = abs(direction.y);
    const Scalar z = abs(direction.z);
    kz = x >= y ? (x >= z ? 0 : 2) : (y >= z ? 1 : 2);
    kx = kz == 2 ? 0 : kz + 1;
    ky = kx == 2 ? 0 : kx + 1;
    const std::array<Scalar, 3> d{direction.x, direction.y, direction.z};
    sz = Scalar(1) / d[kz];
    sx = d[kx] * sz;
    sy = d[ky] * sz;
  }
};

/// A triangle's vertices as the shear moves them: the ray is at 0.
template <class Scalar>
struct ShearedVertices {
  Scalar ax, ay, bx, by, cx, cy;

  /// The edge functions: twice the areas opposite a, b and c.
  std::array<Scalar, 3> edges() const { return {cx * by - cy * bx, ax * cy - ay * cx, bx * ay - by * ax}; }
};

template <class Scalar>
struct TriangleShading {
  FlatShading<Scalar> flat;
  std::shared_ptr<const VertexNormals<Scalar>> normals{};  ///< where the surface is smooth

  template <class Other, class Number>
  TriangleShading<Other> mapped(const Number& number) const {
    TriangleShading<Other> result{flat.template mapped<Other>(number)};
    if (normals) result.normals = std::make_shared<const VertexNormals<Other>>(number(*normals, 0));
    return result;
  }
};

template <class Scalar>
struct TriangleSurface {
  static constexpr SurfaceTraits traits{.name = "triangle", .default_cost = 3, .extent = Extent::bounded};
  using Terms = TriangleShear<Scalar>;
  using Shading = TriangleShading<Scalar>;

  std::array<std::array<Scalar, 3>, 3> vertices;
  SurfaceIdentity identity{};

  Scalar intersect(const TriangleShear<Scalar>& shear) const;
  ShearedVertices<Scalar> sheared(const TriangleShear<Scalar>& shear) const;
  /// Where the ray meets the triangle, as weights of its vertices. It must meet it.
  std::array<Scalar, 3> weights(const TriangleShear<Scalar>& shear) const;

  Scalar shade(const Shading& shading, const Lighting<Scalar>& lighting, const Vector<Scalar>& direction,
               Scalar) const {
    if (!shading.normals) return shading.flat.seen_along(direction);
    if (!lighting.lit) return Scalar(1);
    return lambert_of_curved(lighting, shading_normal(shading, direction), direction, shading.flat.normal);
  }
  Vector<Scalar> outward(const Shading& shading, const Vector<Scalar>&, Scalar) const { return shading.flat.normal; }
  /// What outward() is to be taken for where light falls on a smooth surface.
  Vector<Scalar> shading_normal(const Shading& shading, const Vector<Scalar>& direction) const {
    return on_side_of(shading.flat.normal, mean_normal(*shading.normals, weights(TriangleShear<Scalar>(direction))));
  }

  /// The same surface for rays that start at `place` instead of the origin.
  TriangleSurface seen_from(const Vector<Scalar>& place) const {
    TriangleSurface moved = *this;
    for (auto& [x, y, z] : moved.vertices) {
      x = x - place.x;
      y = y - place.y;
      z = z - place.z;
    }
    return moved;
  }

  template <class Other, class Number>
  TriangleSurface<Other> mapped(const Number& number) const {
    return {number(vertices, 1), identity};
  }
};

double reach(const TriangleSurface<double>& triangle);
double relative_error(const TriangleSurface<double>& triangle, const RoundingUnits& rounding);
DistanceRange distance_range(const TriangleSurface<double>& triangle, const Vector<double>& direction, double t,
                             const RoundingUnits& rounding);
/// By how much t errs at most, if no coordinate of the triangle, before it is rounded to the format, lies further than
/// `displaced` from what the scene says.
double distance_error(const TriangleSurface<double>& triangle, const Vector<double>& direction, double t,
                      double displaced, const RoundingUnits& rounding);
std::optional<BoundingBox> slope_bounds(const TriangleSurface<double>& triangle, double margin);
std::optional<BoundingBox> bounds(const TriangleSurface<double>& triangle);

/// Of the points `a`, `b` and `c` in observer's coordinates, which do not lie on one line.
Prepared<TriangleSurface> prepared_triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                                            const Lighting<double>& lighting);

class AffineMap;

struct Triangle {
  static constexpr std::string_view type = "triangle";
  static constexpr std::array<std::string_view, 1> keys{"vertices"};

  std::array<glm::dvec3, 3> vertices;

  static Triangle read(const JsonReader& reader, const SceneReading& reading);
  Prepared<TriangleSurface> prepared(const Preparation& preparation) const;
  Triangle transformed(const AffineMap& map) const;
  SurfaceCoordinates coordinates_at(const glm::dvec3& point) const;
  void write_pov(PovWriter& pov) const;
};

/// Whether the ray, which is at 0, passes a triangle whose vertices are at `a`, `b` and `c`.
template <class Scalar>
bool beside(Scalar a, Scalar b, Scalar c) {
  return std::min(std::min(a, b), c) > Scalar(0) || std::max(std::max(a, b), c) < Scalar(0);
}

template <class Scalar>
ShearedVertices<Scalar> TriangleSurface<Scalar>::sheared(const TriangleShear<Scalar>& shear) const {
  const auto& [a, b, c] = vertices;
  return {a[shear.kx] - shear.sx * a[shear.kz], a[shear.ky] - shear.sy * a[shear.kz],
          b[shear.kx] - shear.sx * b[shear.kz], b[shear.ky] - shear.sy * b[shear.kz],
          c[shear.kx] - shear.sx * c[shear.kz], c[shear.ky] - shear.sy * c[shear.kz]};
}

template <class Scalar>
std::array<Scalar, 3> TriangleSurface<Scalar>::weights(const TriangleShear<Scalar>& shear) const {
  const auto [u, v, w] = sheared(shear).edges();
  const Scalar determinant = u + v + w;
  return {u / determinant, v / determinant, w / determinant};
}

/// The t > 0 at which the view ray meets the triangle from either side, or 0 where there is none.
template <class Scalar>
Scalar TriangleSurface<Scalar>::intersect(const TriangleShear<Scalar>& shear) const {
  const ShearedVertices<Scalar> at = sheared(shear);
  if (beside(at.ax, at.bx, at.cx) || beside(at.ay, at.by, at.cy)) return Scalar(0);
  const auto [u, v, w] = at.edges();
  const bool negative = u < Scalar(0) || v < Scalar(0) || w < Scalar(0);
  const bool positive = u > Scalar(0) || v > Scalar(0) || w > Scalar(0);
  if (negative && positive) return Scalar(0);
  const Scalar determinant = u + v + w;
  if (determinant == Scalar(0)) return Scalar(0);
  const auto& [a, b, c] = vertices;
  const Scalar depth = u * a[shear.kz] + v * b[shear.kz] + w * c[shear.kz];
  const Scalar t = depth * shear.sz / determinant;
  return t > Scalar(0) ? t : Scalar(0);
}

}  // namespace pyrasim
