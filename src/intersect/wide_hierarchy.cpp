// SPDX-License-Identifier: Apache-2.0
#include "intersect/wide_hierarchy.h"

#include <algorithm>
#include <cmath>

#include "intersect/hierarchy_builder.h"
#include "intersect/relative_error.h"
#include "intersect/slope_bounds.h"
#include "numeric/number_range.h"

namespace pyrasim {
namespace {

/// Roundings (2^(1-P)) of the largest coordinate by which bounds are grown, so that a ray that a surface counts as hit
/// never misses the box around it, and results do not depend on the hierarchy. A slope is exact, a bound errs by 1/2 of
/// a rounding. Of a sphere, the centre errs by 1/2, the component across the ray by 1 in each coordinate, the squares
/// by 2 of the radius; t, which is compared with the depth of boxes, by 5. Of a triangle, a sheared coordinate errs by
/// 3/2, and t, a mean of its vertices, by 3. In a narrow format the boxes so become wide, and more surfaces are tested.
/// There is an exception: where products of coordinates fall below the smallest number of a narrow
/// format, a test has nothing left to decide by, and a triangle may count as hit by rays far from it; whether it is
/// asked then depends on the boxes. What preparation may have moved a surface by is added, so that
/// a box never begins deeper than the range in which an exact hit may lie (distance_range.h).
constexpr double margin_roundings = 8;

/// How far from a surface a ray may run that the datapath counts as a hit.
class Margin {
 public:
  Margin(const NumberFormat& format, const Screen& screen, const RoundingUnits& rounding) : rounding_(rounding) {
    const double resolution = std::ldexp(1.0, -finest_fraction_bits(format));
    if (format.kind == NumberKind::fixed) {
      // Errors are absolute there; the longest view vector multiplies them twice.
      const double half_y = screen.rows * screen.dy / (2 * screen.dx);
      const double half_z = screen.columns * screen.dz / (2 * screen.dx);
      relative_ = absolute_ = margin_roundings * resolution * (1 + half_y * half_y + half_z * half_z);
    } else {
      relative_ = std::ldexp(margin_roundings, 1 - format.significand_bits);
    }
    absolute_ += square_root_margin * std::sqrt(resolution);
  }

  double of(double largest_coordinate) const {
    return relative_ * largest_coordinate + absolute_ + rounding_.written(largest_coordinate);
  }

 private:
  /// A squared distance is lost with the smallest number; a distance, with its root.
  static constexpr double square_root_margin = 2;
  RoundingUnits rounding_;
  double relative_ = 0;
  double absolute_ = 0;
};

double largest_coordinate(const glm::dvec3& point) {
  return std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)});
}

BoundingBox bounds_of(const SphereSurface<double>& sphere, const Margin& margin) {
  return slope_bounds_of_sphere(sphere.center, sphere.radius,
                                margin.of(largest_coordinate(sphere.center) + sphere.radius));
}

BoundingBox bounds_of(const TriangleSurface<double>& triangle, const Margin& margin) {
  std::array<glm::dvec3, 3> vertices;
  double largest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& [x, y, z] = triangle.vertices[k];
    vertices[k] = glm::dvec3(x, y, z);
    largest = std::max(largest, largest_coordinate(vertices[k]));
  }
  return slope_bounds_of_triangle(vertices, margin.of(largest));
}

/// Nodes of up to node_width children out of a binary hierarchy.
class Widening {
 public:
  Widening(PreparedScene<double>& scene, const Screen& screen, const Margin& margin) : scene_(scene) {
    const auto add = [&](const auto& surface) {
      bounds_.push_back(bounds_of(surface, margin));
      errors_.push_back(relative_error(surface, scene.rounding));
    };
    for (const auto& sphere : scene.spheres) add(sphere);
    for (const auto& triangle : scene.triangles) add(triangle);
    std::vector<BoundingBox> visible;
    visible.reserve(bounds_.size());
    for (const BoundingBox& bounds : bounds_) visible.push_back(on_screen(bounds, screen));
    hierarchy_ = build_hierarchy(visible);
    spheres_.swap(scene.spheres);
    triangles_.swap(scene.triangles);
    shading_.swap(scene.triangle_shading);
  }

  void build() {
    const auto spheres = static_cast<std::uint32_t>(spheres_.size());
    const auto triangles = static_cast<std::uint32_t>(triangles_.size());
    double error = 0;
    for (const double of_surface : errors_) error = std::max(error, of_surface);
    scene_.everything = scene_.root = add_leaf({0, spheres, 0, triangles, error});
    if (!hierarchy_.nodes.empty()) scene_.root = convert(hierarchy_.nodes.front()).reference;
  }

 private:
  using Node = PreparedScene<double>::Node;
  using Leaf = PreparedScene<double>::Leaf;

  struct Converted {
    BoundingBox bounds;          ///< of all surfaces in it, those off the screen too
    std::int32_t reference = 0;  ///< as Node::child
  };

  Converted convert(const HierarchyNode& node) {
    if (node.count > 0) return convert_leaf(node);
    const std::size_t index = scene_.nodes.size();
    scene_.nodes.emplace_back();
    const std::vector<const HierarchyNode*> sources = widened(node);
    std::array<Converted, node_width> children;
    BoundingBox bounds;
    for (std::size_t k = 0; k < sources.size(); ++k) {
      children[k] = convert(*sources[k]);
      bounds.include(children[k].bounds);
    }
    // Children without a surface before the observer, and those that there are not, begin at infinity.
    std::stable_sort(children.begin(), children.end(),
                     [](const Converted& a, const Converted& b) { return a.bounds.lower.x < b.bounds.lower.x; });
    Node& wide = scene_.nodes[index];
    wide.children = static_cast<std::uint32_t>(sources.size());
    for (std::size_t k = 0; k < node_width; ++k) {
      wide.boxes.set(k, children[k].bounds);
      wide.child[k] = children[k].reference;
    }
    return {bounds, static_cast<std::int32_t>(index)};
  }

  /// The children of a wide node: those of the binary one, the largest inner one replaced by its own while there is
  /// room.
  std::vector<const HierarchyNode*> widened(const HierarchyNode& node) const {
    const auto* const nodes = hierarchy_.nodes.data();
    std::vector<const HierarchyNode*> children{nodes + node.first, nodes + node.first + 1};
    while (children.size() < node_width) {
      const HierarchyNode** largest = nullptr;
      for (const HierarchyNode*& child : children) {
        if (child->count > 0) continue;
        if (largest == nullptr || child->box.frontal_area() > (*largest)->box.frontal_area()) largest = &child;
      }
      if (largest == nullptr) break;
      const std::uint32_t first = (*largest)->first;
      *largest = nodes + first;
      children.push_back(nodes + first + 1);
    }
    return children;
  }

  Converted convert_leaf(const HierarchyNode& node) {
    Leaf leaf{static_cast<std::uint32_t>(scene_.spheres.size()), 0, static_cast<std::uint32_t>(scene_.triangles.size()),
              0, 0};
    BoundingBox bounds;
    for (std::uint32_t k = node.first; k < node.first + node.count; ++k) {
      const std::uint32_t reference = hierarchy_.references[k];
      bounds.include(bounds_[reference]);
      leaf.relative_error = std::max(leaf.relative_error, errors_[reference]);
      if (reference < spheres_.size()) {
        scene_.spheres.push_back(spheres_[reference]);
        ++leaf.spheres;
      } else {
        scene_.triangles.push_back(triangles_[reference - spheres_.size()]);
        scene_.triangle_shading.push_back(shading_[reference - spheres_.size()]);
        ++leaf.triangles;
      }
    }
    return {bounds, add_leaf(leaf)};
  }

  std::int32_t add_leaf(const Leaf& leaf) {
    scene_.leaves.push_back(leaf);
    return ~static_cast<std::int32_t>(scene_.leaves.size() - 1);
  }

  PreparedScene<double>& scene_;
  std::vector<BoundingBox> bounds_;  // in slope space; spheres, then triangles, as the hierarchy's references
  std::vector<double> errors_;       // relative, of the same
  Hierarchy hierarchy_;
  std::vector<SphereSurface<double>> spheres_;  // in the order of the scene
  std::vector<TriangleSurface<double>> triangles_;
  std::vector<FlatShading<double>> shading_;
};

}  // namespace

void build_wide_hierarchy(PreparedScene<double>& scene, const Screen& screen, const NumberFormat& format) {
  Widening(scene, screen, Margin(format, screen, scene.rounding)).build();
}

}  // namespace pyrasim
