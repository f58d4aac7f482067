// SPDX-License-Identifier: Apache-2.0
#include "surface/instance.h"

#include <cmath>
#include <utility>

#include "numeric/vectors.h"
#include "surface/pov_writer.h"
#include "surface/slope_bounds.h"

namespace pyrasim {
namespace {

QuadrupleVector along_axis(std::size_t axis) {
  QuadrupleVector unit{};
  unit[axis] = 1;
  return unit;
}

Enclosure<double> enclosure_of(const BoundingBox& box, const AffineMap& map, const ObserverFrame& frame) {
  const glm::dvec3 half = (box.upper - box.lower) * 0.5;
  Enclosure<double> enclosure{frame.point(rounded(map.point(exactly(box.center())))), {}};
  for (std::size_t k = 0; k < 3; ++k) {
    enclosure.half[k] = frame.direction(rounded(map.direction(along_axis(k)))) * half[static_cast<int>(k)];
  }
  return enclosure;
}

double reach_of(const Enclosure<double>& enclosure) { return box_of(corners_of(enclosure)).reach(); }

}  // namespace

InstancedMesh::InstancedMesh(Mesh of) : mesh(std::move(of)), box(box_of(mesh.vertices)) {
  exponent = std::ilogb(largest(box.upper * 0.5 - box.lower * 0.5)) + 1;
}

glm::dvec3 InstancedMesh::vertex(std::uint32_t k) const {
  const glm::dvec3 from_center = mesh.vertices[k] - box.center();
  return {std::ldexp(from_center.x, -exponent), std::ldexp(from_center.y, -exponent),
          std::ldexp(from_center.z, -exponent)};
}

/// From the observer's coordinates by his axes to the world's, and by the inverse of the map to the mesh's.
Prepared<InstanceSurface> MeshInstance::prepared(const Preparation& preparation) const {
  const ObserverFrame& frame = preparation.frame;
  const std::array axes{exactly(frame.forward()), exactly(frame.up()), exactly(frame.right())};
  const QuadrupleVector place = difference(exactly(frame.position()), map.offset());
  const QuadrupleVector center = exactly(of->box.center());
  QuadrupleMatrix rows{};
  QuadrupleVector origin{};
  double longest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const QuadrupleVector inverse = map.normal(along_axis(i));
    double length = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      rows[i][j] = dot(inverse, axes[j]);
      length += std::abs(static_cast<double>(rows[i][j]));
    }
    origin[i] = dot(inverse, place) - center[i];
    longest = std::max(longest, length);
  }
  const int exponent = -std::ilogb(longest) - 1;
  const double unit = std::ldexp(1.0, exponent);
  Prepared<InstanceSurface> prepared{};
  InstanceSurface<double>& surface = prepared.surface;
  for (std::size_t i = 0; i < 3; ++i) {
    surface.rows[i] = rounded(rows[i]) * unit;
    surface.origin[static_cast<int>(i)] = static_cast<double>(origin[i]) * unit;
  }
  surface.scale = std::ldexp(1.0, exponent + of->exponent);
  InstanceBounds& within = surface.within;
  within.enclosure = enclosure_of(of->box, map, frame);
  within.reach = reach_of(within.enclosure);
  within.unevenness = map.unevenness();
  within.written = 0x1p-51 * of->box.reach() * unit;
  return prepared;
}

/// Where the mesh's box fits into the scene, the mesh does.
MeshInstance MeshInstance::transformed(const AffineMap& outer) const {
  MeshInstance mapped{of, outer.after(map)};
  BoundingBox box;
  for (unsigned k = 0; k < 8; ++k) {
    const auto side = [&](unsigned axis) {
      const int which = static_cast<int>(axis);
      return (k >> axis & 1U) == 0 ? of->box.lower[which] : of->box.upper[which];
    };
    box.include(mapped_point(mapped.map, {side(0), side(1), side(2)}));
  }
  const glm::dvec3 sides = box.upper - box.lower;
  if ((sides.x > 0 ? 1 : 0) + (sides.y > 0 ? 1 : 0) + (sides.z > 0 ? 1 : 0) < 2) fail_without_area();
  return mapped;
}

void MeshInstance::declare_pov(PovWriter& pov) const {
  if (!pov.declare(of.get())) return;
  of->mesh.write_pov(pov);
  pov.new_line();
}

void MeshInstance::write_pov(PovWriter& pov) const {
  pov.declared(of.get());
  std::array<glm::dvec3, 3> axes{};
  for (std::size_t k = 0; k < 3; ++k) axes[k] = rounded(map.direction(along_axis(k)));
  pov.matrix(axes, rounded(map.offset()));
}

double reach(const InstanceSurface<double>& instance) { return instance.within.reach; }

std::optional<BoundingBox> bounds(const InstanceSurface<double>& instance) {
  return box_of(corners_of(instance.within.enclosure));
}

std::optional<BoundingBox> slope_bounds(const InstanceSurface<double>& instance, double margin) {
  return slope_bounds_of_hull(corners_of(instance.within.enclosure), margin);
}

}  // namespace pyrasim
