// SPDX-License-Identifier: Apache-2.0
#include "surface/polygon.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "camera/observer_frame.h"
#include "numeric/vectors.h"
#include "surface/affine_map.h"
#include "surface/pov_writer.h"

namespace pyrasim {
namespace {

/// Of the polygon's size and its coordinates, what decimal numbers and their rounding may leave of a flat polygon.
constexpr double flat = 1e-9;

/// Twice the area, along the normal (Newell's sum over the vertices), about the first vertex.
glm::dvec3 area_vector(const std::vector<glm::dvec3>& vertices) {
  glm::dvec3 sum(0);
  for (std::size_t k = 2; k < vertices.size(); ++k) {
    sum += cross(vertices[k - 1] - vertices[0], vertices[k] - vertices[0]);
  }
  return sum;
}

double size_of(const std::vector<glm::dvec3>& vertices) {
  double size = 0;
  for (const glm::dvec3& vertex : vertices) size = std::max(size, length(vertex - vertices[0]));
  return size;
}

}  // namespace

std::optional<Polygon::Fault> Polygon::fault() const {
  const double size = size_of(vertices);
  double reach = 0;
  for (const glm::dvec3& vertex : vertices) reach = std::max(reach, largest(vertex));
  const double rounding = flat * size + 8 * epsilon<double>() * reach;
  const glm::dvec3 area = area_vector(vertices);
  if (!(length(area) > rounding * size)) {
    return Fault{"the polygon has no area", "vertices that are not on one line, once around, are needed"};
  }
  const glm::dvec3 normal = normalized(area);
  double turned = 0;
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    const glm::dvec3& here = vertices[k];
    const glm::dvec3 in = here - vertices[(k + vertices.size() - 1) % vertices.size()];
    const glm::dvec3 out = vertices[(k + 1) % vertices.size()] - here;
    if (std::abs(dot(normal, here - vertices[0])) > rounding) {
      return Fault{fmt::format("vertex {} is not in the plane of the others", k), "a flat polygon is needed"};
    }
    if (length(out) < min_length) {
      return Fault{fmt::format("vertex {} is repeated", k), "vertices have to lie apart"};
    }
    const double sine = dot(normal, cross(in, out));
    if (sine < -rounding * std::max(length(in), length(out))) {
      return Fault{fmt::format("the polygon is bent inwards at vertex {}", k), "a convex polygon is needed"};
    }
    turned += std::atan2(sine, dot(in, out));
  }
  if (turned > 9) {  // once around is 2 pi
    return Fault{"the polygon goes around more than once", "a convex polygon is needed"};
  }
  return std::nullopt;
}

Polygon Polygon::read(const JsonReader& reader, const SceneReading&) {
  const JsonReader list = reader.member("vertices");
  Polygon polygon;
  for (const JsonReader& vertex : list.elements(3, max_vertices)) polygon.vertices.push_back(vertex.vec3(coordinates));
  if (const auto fault = polygon.fault()) list.fail(fault->wrong, fault->allowed);
  return polygon;
}

Polygon Polygon::transformed(const AffineMap& map) const {
  Polygon mapped;
  for (const glm::dvec3& vertex : vertices) mapped.vertices.push_back(mapped_point(map, vertex));
  bool degenerate = true;
  for (std::size_t k = 2; k < vertices.size(); ++k) {
    degenerate &= is_degenerate(mapped.vertices[0], mapped.vertices[k - 1], mapped.vertices[k]);
  }
  if (degenerate) fail_without_area();
  return mapped;
}

/// The triangles that the datapath holds.
void Polygon::write_pov(PovWriter& pov) const {
  pov.begin(vertices.size() > 3 ? "union" : "object");
  for (std::size_t k = 2; k < vertices.size(); ++k) {
    if (is_degenerate(vertices[0], vertices[k - 1], vertices[k])) continue;
    pov.object("triangle", vertices[0], vertices[k - 1], vertices[k]);
  }
  pov.end();
}

SurfaceCoordinates Polygon::coordinates_at(const glm::dvec3& point) const {
  return on_plane(area_vector(vertices), vertices[0], point);
}

}  // namespace pyrasim
