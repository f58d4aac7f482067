// SPDX-License-Identifier: Apache-2.0
// Instances of meshes: all of one mesh share its triangles. A ray is brought into the mesh's own coordinates, by a map
// that leaves its t as it is, and meets them there.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "surface/affine_map.h"
#include "surface/bounding_box.h"
#include "surface/enclosure.h"
#include "surface/mesh.h"
#include "surface/preparation.h"
#include "surface/surface.h"
#include "surface/triangle.h"
#include "surface/view_ray.h"

namespace pyrasim {

/// What error bounds ask about an instance, in double whatever the datapath's format; lengths are the prepared scene's.
struct InstanceBounds {
  Enclosure<double> enclosure;  ///< in observer's coordinates
  double reach = 0;             ///< the largest coordinate of its corners
  double unevenness = 1;        ///< of the map
  double written = 0;           ///< by how much the mesh's own numbers may lie from what its file says
  double margin = 0;            ///< by which boxes about triangles are grown for view rays

  template <class Number>
  InstanceBounds mapped(const Number& number) const {
    return {enclosure.mapped<double>(number), number(reach, 1), unevenness, number(written, 1), number(margin, 1)};
  }
};

/// A point p of the observer's coordinates is rows p + origin in the instance's, which are the mesh's, turned by
/// nothing and stretched by a power of two: so that no length becomes longer, and one along some direction hardly
/// shorter. What fits the format in the observer's coordinates then fits there.
template <class Scalar>
struct InstanceSurface {
  static constexpr SurfaceTraits traits{.name = "instance", .default_cost = 2, .extent = Extent::bounded};
  using Terms = const ViewRay<Scalar>&;
  using Shading = NoShading<Scalar>;

  std::array<Vector<Scalar>, 3> rows;
  Vector<Scalar> origin;  ///< the observer's place
  Scalar scale;           ///< of the mesh's triangles, a power of two
  InstanceBounds within;
  std::uint32_t mesh = 0;   ///< among the prepared scene's
  std::uint32_t first = 0;  ///< number of its first triangle among those of all instances
  SurfaceIdentity identity{};

  Vector<Scalar> direction(const Vector<Scalar>& v) const {
    return {dot(rows[0], v), dot(rows[1], v), dot(rows[2], v)};
  }
  /// Of a plane there, as the observer's coordinates have it; of another length.
  Vector<Scalar> normal(const Vector<Scalar>& n) const {
    const auto component = [&](int k) { return rows[0][k] * n.x + (rows[1][k] * n.y + rows[2][k] * n.z); };
    return {component(0), component(1), component(2)};
  }
  /// What its triangles ask of a ray along `mapped`, a direction in its coordinates; nothing where a narrow format
  /// leaves nothing of that.
  std::optional<TriangleShear<Scalar>> shear(const Vector<Scalar>& mapped) const {
    const bool none = mapped.x == Scalar(0) && mapped.y == Scalar(0) && mapped.z == Scalar(0);
    if (none || scale == Scalar(0)) return std::nullopt;
    return TriangleShear<Scalar>(mapped);
  }
  /// A triangle of the mesh, for rays from where these start. Neighbours compute a shared vertex from the same numbers.
  TriangleSurface<Scalar> placed(TriangleSurface<Scalar> triangle) const {
    for (auto& [x, y, z] : triangle.vertices) {
      x = x * scale - origin.x;
      y = y * scale - origin.y;
      z = z * scale - origin.z;
    }
    return triangle;
  }

  /// The same surface for rays that start at `place` instead of the origin.
  InstanceSurface seen_from(const Vector<Scalar>& place) const {
    InstanceSurface moved = *this;
    moved.origin = origin + direction(place);
    return moved;
  }

  template <class Other, class Number>
  InstanceSurface<Other> mapped(const Number& number) const {
    InstanceSurface<Other> result{number(rows, 0), number(origin, 1), number(scale, 1), within, mesh, first, identity};
    if constexpr (std::is_same_v<Other, double>) result.within = within.mapped(number);
    return result;
  }
};

/// Surfaces whose places are not theirs alone.
template <class Surface>
concept SharesMesh = requires(const Surface& surface) {
  surface.mesh;
};

/// By how many times as much as without the map what the datapath computes may lie from the surface: rows that are
/// rounded turn a ray, and what is so displaced in the mesh's coordinates is further off in the observer's where those
/// are the longer ones; by the root of 3 more where all three of them are, and twice for how the map is scaled.
inline double unevenness(const InstanceSurface<double>& instance) { return 4 * instance.within.unevenness; }
double reach(const InstanceSurface<double>& instance);
std::optional<BoundingBox> slope_bounds(const InstanceSurface<double>& instance, double margin);
std::optional<BoundingBox> bounds(const InstanceSurface<double>& instance);

/// A mesh that instances share.
struct InstancedMesh {
  Mesh mesh;
  BoundingBox box;
  int exponent;  ///< of the power of two above its box's half sides

  explicit InstancedMesh(Mesh of);
  /// Vertex `k` about the box's centre, in units of 2^exponent.
  glm::dvec3 vertex(std::uint32_t k) const;
};

/// An instance of a mesh; of other surfaces a transform makes surfaces.
struct MeshInstance {
  std::shared_ptr<const InstancedMesh> of;
  AffineMap map;

  Prepared<InstanceSurface> prepared(const Preparation& preparation) const;
  MeshInstance transformed(const AffineMap& outer) const;
  /// What all instances of its mesh refer to, unless it is there.
  void declare_pov(PovWriter& pov) const;
  void write_pov(PovWriter& pov) const;
};

}  // namespace pyrasim
