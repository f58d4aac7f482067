// SPDX-License-Identifier: Apache-2.0
#include "trace/prepared_scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "trace/observer_frame.h"
#include "trace/wide_hierarchy.h"

namespace pyrasim {
namespace {

/// Puts a scene's objects into a PreparedScene, in the order of the scene.
template <class Scalar>
class Preparation {
 public:
  explicit Preparation(const Scene& scene) : frame_(scene.camera), screen_(scene.camera.screen), light_(scene.light) {
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
    build_wide_hierarchy(prepared_, screen_);
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

  ObserverFrame frame_;
  Screen screen_;
  std::optional<Light> light_;
  glm::dvec3 light_direction_{0, 0, 0};
  std::uint32_t object_ = 0;
  std::uint32_t order_ = 0;
  PreparedScene<Scalar> prepared_;
};

}  // namespace

template <class Scalar>
PreparedScene<Scalar> prepare_scene(const Scene& scene) {
  return Preparation<Scalar>(scene).take();
}

template PreparedScene<double> prepare_scene<double>(const Scene& scene);
template PreparedScene<float> prepare_scene<float>(const Scene& scene);

}  // namespace pyrasim
