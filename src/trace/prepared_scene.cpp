// SPDX-License-Identifier: Apache-2.0
#include "trace/prepared_scene.h"

#include <cmath>

#include "trace/hierarchy_builder.h"
#include "trace/observer_frame.h"

namespace pyrasim {
namespace {

/// Roundings by which boxes are padded; see BoundingBox::pad.
constexpr double box_roundings = 16;

template <class Scalar>
BoundingBox box_of(const SphereSurface<Scalar>& sphere) {
  const glm::dvec3 radius(1 / static_cast<double>(sphere.inverse_radius));
  const glm::dvec3 center(sphere.center);
  BoundingBox box;
  box.include(center - radius);
  box.include(center + radius);
  box.pad(static_cast<double>(epsilon<Scalar>()), box_roundings);
  return box;
}

template <class Scalar>
BoundingBox box_of(const TriangleSurface<Scalar>& triangle) {
  BoundingBox box;
  for (const auto& [x, y, z] : triangle.vertices) box.include(glm::dvec3(x, y, z));
  box.pad(static_cast<double>(epsilon<Scalar>()), box_roundings);
  return box;
}

/// Puts a scene's objects into a PreparedScene, in the order of the scene.
template <class Scalar>
class Preparation {
 public:
  explicit Preparation(const Scene& scene) : frame_(scene.camera), light_(scene.light) {
    if (light_) {
      light_direction_ = normalized(frame_.direction(light_->direction));
      prepared_.lit = true;
      prepared_.ambient = static_cast<Scalar>(light_->ambient);
      prepared_.towards_light = to_scalar<Scalar>(-light_direction_);
    }
    for (const Object& object : scene.objects) {
      std::visit([this](const auto& surface) { this->add(surface); }, object.surface);
      ++object_;
    }
  }

  PreparedScene<Scalar> take() {
    build();
    return std::move(prepared_);
  }

 private:
  SurfaceIdentity next_identity() { return {object_, order_++}; }

  void add(const Sphere& sphere) {
    const glm::dvec3 center = frame_.point(sphere.center);
    // The origin's power as a product of sum and difference does not cancel, and is rounded to the format once.
    const long double distance = std::hypot(std::hypot(static_cast<long double>(center.x), center.y), center.z);
    const long double power = (distance - sphere.radius) * (distance + sphere.radius);
    prepared_.spheres.push_back({to_scalar<Scalar>(center), static_cast<Scalar>(sphere.radius * sphere.radius),
                                 static_cast<Scalar>(power), static_cast<Scalar>(1 / sphere.radius), next_identity()});
  }

  void add(const Plane& plane) {
    const glm::dvec3 unit = normalized(plane.normal);
    const double length = dot(unit, plane.normal);
    const double offset = plane.offset / length - dot(unit, frame_.position());
    const FlatShading<Scalar> shading = flat_shading(frame_.direction(unit));
    prepared_.planes.push_back({static_cast<Scalar>(offset), next_identity(), shading});
  }

  void add(const Triangle& triangle) {
    const auto& [a, b, c] = triangle.vertices;
    add_triangle(frame_.point(a), frame_.point(b), frame_.point(c));
  }

  void add(const Mesh& mesh) {
    std::vector<glm::dvec3> observed;
    observed.reserve(mesh.vertices.size());
    for (const glm::dvec3& vertex : mesh.vertices) observed.push_back(frame_.point(vertex));
    for (const auto& [a, b, c] : mesh.triangles) add_triangle(observed[a], observed[b], observed[c]);
  }

  void add_triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    TriangleSurface<Scalar> triangle{{}, next_identity()};
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector<Scalar> vertex = to_scalar<Scalar>(k == 0 ? a : k == 1 ? b : c);
      triangle.vertices[k] = {vertex.x, vertex.y, vertex.z};
    }
    prepared_.triangles.push_back(triangle);
    prepared_.triangle_shading.push_back(flat_shading(normalized(cross(normalized(b - a), normalized(c - a)))));
  }

  /// Lambert's cosine law on either side of a flat surface: ambient + (1 - ambient) max(0, -n . l).
  FlatShading<Scalar> flat_shading(const glm::dvec3& normal) const {
    if (!light_) return {to_scalar<Scalar>(normal), Scalar(1), Scalar(1)};
    const double cosine = -dot(normal, light_direction_);
    const auto shading = [this](double c) {
      return static_cast<Scalar>(light_->ambient + (1 - light_->ambient) * std::max(c, 0.0));
    };
    return {to_scalar<Scalar>(normal), shading(cosine), shading(-cosine)};
  }

  void build() {
    std::vector<BoundingBox> boxes;
    boxes.reserve(prepared_.spheres.size() + prepared_.triangles.size());
    for (const auto& sphere : prepared_.spheres) boxes.push_back(box_of(sphere));
    for (const auto& triangle : prepared_.triangles) boxes.push_back(box_of(triangle));
    if (boxes.empty()) return;
    spheres_.swap(prepared_.spheres);
    triangles_.swap(prepared_.triangles);
    shading_.swap(prepared_.triangle_shading);
    hierarchy_ = build_hierarchy(boxes);
    prepared_.root = convert(hierarchy_.nodes.front());
  }

  std::int32_t convert(const HierarchyNode& node) {
    if (node.count > 0) return convert_leaf(node);
    const std::size_t index = prepared_.nodes.size();
    prepared_.nodes.emplace_back();
    const std::vector<const HierarchyNode*> children = widened(node);
    prepared_.nodes[index].children = static_cast<std::uint32_t>(children.size());
    for (std::size_t k = 0; k < node_width; ++k) {
      const BoundingBox box = k < children.size() ? children[k]->box : BoundingBox{};
      for (int axis = 0; axis < 3; ++axis) {
        auto& bounds = prepared_.nodes[index].bounds[static_cast<std::size_t>(axis)];
        bounds[0][k] = static_cast<Scalar>(box.lower[axis]);
        bounds[1][k] = static_cast<Scalar>(box.upper[axis]);
      }
      const std::int32_t reference = k < children.size() ? convert(*children[k]) : 0;
      prepared_.nodes[index].child[k] = reference;
    }
    return static_cast<std::int32_t>(index);
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
        if (largest == nullptr || child->box.half_area() > (*largest)->box.half_area()) largest = &child;
      }
      if (largest == nullptr) break;
      const std::uint32_t first = (*largest)->first;
      *largest = nodes + first;
      children.push_back(nodes + first + 1);
    }
    return children;
  }

  /// Surfaces end up in the order of the leaves, each leaf's of one kind side by side.
  std::int32_t convert_leaf(const HierarchyNode& node) {
    typename PreparedScene<Scalar>::Leaf leaf{static_cast<std::uint32_t>(prepared_.spheres.size()), 0,
                                              static_cast<std::uint32_t>(prepared_.triangles.size()), 0};
    for (std::uint32_t k = node.first; k < node.first + node.count; ++k) {
      const std::uint32_t reference = hierarchy_.references[k];
      if (reference < spheres_.size()) {
        prepared_.spheres.push_back(spheres_[reference]);
        ++leaf.spheres;
      } else {
        prepared_.triangles.push_back(triangles_[reference - spheres_.size()]);
        prepared_.triangle_shading.push_back(shading_[reference - spheres_.size()]);
        ++leaf.triangles;
      }
    }
    prepared_.leaves.push_back(leaf);
    return ~static_cast<std::int32_t>(prepared_.leaves.size() - 1);
  }

  ObserverFrame frame_;
  std::optional<Light> light_;
  glm::dvec3 light_direction_{0, 0, 0};
  std::uint32_t object_ = 0;
  std::uint32_t order_ = 0;
  PreparedScene<Scalar> prepared_;
  Hierarchy hierarchy_;
  std::vector<SphereSurface<Scalar>> spheres_;  // in the order of the scene
  std::vector<TriangleSurface<Scalar>> triangles_;
  std::vector<FlatShading<Scalar>> shading_;
};

}  // namespace

template <class Scalar>
PreparedScene<Scalar> prepare_scene(const Scene& scene) {
  return Preparation<Scalar>(scene).take();
}

template PreparedScene<double> prepare_scene<double>(const Scene& scene);
template PreparedScene<float> prepare_scene<float>(const Scene& scene);

}  // namespace pyrasim
