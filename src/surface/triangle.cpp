// SPDX-License-Identifier: Apache-2.0
#include "surface/triangle.h"

#include <cmath>

#include "mesh/degenerate.h"
#include "numeric/vectors.h"
#include "surface/affine_map.h"
#include "surface/error_bounds.h"
#include "surface/pov_writer.h"
#include "surface/slope_bounds.h"

namespace pyrasim {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A triangle's vertices as the shear moves them, and the edge functions of these.
class ShearedTriangle {
 public:
  ShearedTriangle(const TriangleSurface<double>& triangle, const Vector<double>& direction, double written,
                  const RoundingUnits& rounding)
      : shear_(direction),
        u_(rounding.relative),
        a_(rounding.absolute),
        scale_(direction[static_cast<int>(shear_.kz)]),
        written_(written) {
    // Slopes are those of the view vector unless another component than x is its largest.
    slope_error_ = scale_ == 1 ? 0 : 2 * u_ + a_ * (1 + std::abs(scale_));
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& vertex = triangle.vertices[k];
      depth_[k] = vertex[shear_.kz];
      move(k, 0, vertex[shear_.kx], shear_.sx);
      move(k, 1, vertex[shear_.ky], shear_.sy);
    }
  }

  /// By how much t errs. The depth is the mean of the vertices' depths weighted by the edge functions, which have one
  /// sign where the triangle counts as hit: an error of a weight pulls it towards that vertex, and whatever the weights
  /// are, it lies between the vertices. To that come the errors of depths, products, sums and the quotient.
  double error(double t) const {
    const double depth = t * scale_;
    const double scale = std::abs(scale_);
    double determinant = 0, determinant_error = 0, weighted = 0, spread = 0, furthest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [edge, edge_error] = edge_function((k + 1) % 3, (k + 2) % 3);
      const double away = std::abs(depth_[k] - depth);
      determinant += edge;
      determinant_error += edge_error;
      weighted += edge_error * away;
      spread = std::max(spread, away);
      furthest = std::max(furthest, std::abs(depth_[k]));
    }
    const double certain = std::abs(determinant) - determinant_error;
    const double mean = certain > 0 ? std::min(weighted / certain, spread) : spread;
    const double own = 4 * u_ * (furthest + std::abs(depth)) + slope_error_ * std::abs(depth) + written_ +
                       a_ * (1 + scale) + a_ * (3 + scale) / std::max(certain, 2 * a_);
    return (mean + own) / scale;
  }

 private:
  /// The rounding of coordinates, of the product and of the difference.
  void move(std::size_t vertex, std::size_t axis, double coordinate, double slope) {
    const double product = slope * depth_[vertex];
    const double moved = coordinate - product;
    moved_[vertex][axis] = moved;
    error_[vertex][axis] = u_ * (std::abs(coordinate) + 2 * std::abs(product) + std::abs(moved)) +
                           std::abs(depth_[vertex]) * slope_error_ + (a_ + written_) * (1 + std::abs(slope)) + a_;
  }

  Bounded edge_function(std::size_t p, std::size_t q) const {
    double error = 2 * a_;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double size_q = std::abs(moved_[q][axis]);
      const double size_p = std::abs(moved_[p][1 - axis]);
      error +=
          size_q * error_[p][1 - axis] + error_[q][axis] * (size_p + error_[p][1 - axis]) + 2 * u_ * size_q * size_p;
    }
    return {moved_[q][0] * moved_[p][1] - moved_[q][1] * moved_[p][0], error};
  }

  TriangleShear<double> shear_;
  double u_;
  double a_;
  double scale_;  ///< the view vector's component along which depths are
  double written_;
  double slope_error_ = 0;
  std::array<double, 3> depth_{};
  std::array<std::array<double, 2>, 3> moved_{}, error_{};
};

std::array<glm::dvec3, 3> vertices_of(const TriangleSurface<double>& triangle) {
  std::array<glm::dvec3, 3> vertices;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& [x, y, z] = triangle.vertices[k];
    vertices[k] = {x, y, z};
  }
  return vertices;
}

}  // namespace

Triangle Triangle::read(const JsonReader& reader, const SceneReading&) {
  const JsonReader vertices = reader.member("vertices");
  const auto elements = vertices.elements(3, 3);
  Triangle triangle{};
  std::transform(elements.begin(), elements.end(), triangle.vertices.begin(),
                 [](const JsonReader& vertex) { return vertex.vec3(coordinates); });
  const auto& [a, b, c] = triangle.vertices;
  if (is_degenerate(a, b, c)) vertices.fail("the triangle has no area", "three points not on one line are needed");
  return triangle;
}

Prepared<TriangleSurface> prepared_triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                                            const Lighting<double>& lighting) {
  const glm::dvec3 normal = normalized(cross(normalized(b - a), normalized(c - a)));
  return {{{{{a.x, a.y, a.z}, {b.x, b.y, b.z}, {c.x, c.y, c.z}}}}, {flat_shading(normal, lighting)}};
}

Prepared<TriangleSurface> Triangle::prepared(const Preparation& preparation) const {
  const auto& [a, b, c] = vertices;
  const ObserverFrame& frame = preparation.frame;
  return prepared_triangle(frame.point(a), frame.point(b), frame.point(c), preparation.lighting);
}

Triangle Triangle::transformed(const AffineMap& map) const {
  Triangle mapped = *this;
  for (glm::dvec3& vertex : mapped.vertices) vertex = mapped_point(map, vertex);
  const auto& [a, b, c] = mapped.vertices;
  if (is_degenerate(a, b, c)) fail_without_area();
  return mapped;
}

void Triangle::write_pov(PovWriter& pov) const { pov.object("triangle", vertices[0], vertices[1], vertices[2]); }

double reach(const TriangleSurface<double>& triangle) {
  double reach = 0;
  for (const auto& vertex : triangle.vertices) {
    for (const double coordinate : vertex) reach = std::max(reach, std::abs(coordinate));
  }
  return reach;
}

std::optional<BoundingBox> bounds(const TriangleSurface<double>& triangle) { return box_of(vertices_of(triangle)); }

std::optional<BoundingBox> slope_bounds(const TriangleSurface<double>& triangle, double margin) {
  return slope_bounds_of_hull(vertices_of(triangle), margin);
}

/// t is N . a / N . d with N the normal, twice the area long. The product of t and the determinant is the same for all
/// rays; and no hit is nearer than the triangle's plane.
double relative_error(const TriangleSurface<double>& surface, const RoundingUnits& rounding) {
  const double u = rounding.relative;
  const double a = rounding.absolute;
  const auto vertices = vertices_of(surface);
  const auto side = vertices[1] - vertices[0];
  const auto other_side = vertices[2] - vertices[0];
  const auto normal = cross(side, other_side);
  const double size = reach(surface);
  const double extent = 2 * std::max(largest(side), largest(other_side));  // of the triangle, whichever its sides
  const double written = rounding.written(size);
  // Of a sheared vertex, whose size is twice the extent at most; and of the three edge functions.
  const double moved_error = 8 * u * size + 2 * written + 4 * a;
  const double edges_error =
      3 * (8 * extent * moved_error + 2 * moved_error * moved_error + 16 * u * extent * extent + 4 * a);
  const double volume = std::abs(dot(normal, vertices[0])) - 16 * 0x1p-53 * extent * extent * size;
  const double left = volume - edges_error * size;
  if (!(left > 0)) return infinity;
  const double nearest = volume / (2 * std::sqrt(dot(normal, normal)));
  const double own = 12 * u * size + written + 4 * a;
  return if_of_use(2 * ((extent * edges_error + 8 * a) / left + own / nearest), rounding);
}

double distance_error(const TriangleSurface<double>& surface, const Vector<double>& direction, double t,
                      double displaced, const RoundingUnits& rounding) {
  return ShearedTriangle(surface, direction, displaced, rounding).error(t) * second_order(rounding);
}

DistanceRange distance_range(const TriangleSurface<double>& surface, const Vector<double>& direction, double t,
                             const RoundingUnits& rounding) {
  const double size = reach(surface);
  const double written = rounding.written(size);
  const double error = distance_error(surface, direction, t, written, rounding);
  const auto& [a, b, c] = surface.vertices;
  const double margin = rounding.relative * size + rounding.absolute + written;
  return within_bounds({t - error, t + error}, std::min({a[0], b[0], c[0]}) - margin,
                       std::max({a[0], b[0], c[0]}) + margin, direction);
}

SurfaceCoordinates Triangle::coordinates_at(const glm::dvec3& point) const {
  const auto& [a, b, c] = vertices;
  return on_plane(cross(b - a, c - a), a, point);
}

}  // namespace pyrasim
