// SPDX-License-Identifier: Apache-2.0
#include "intersect/prepared_scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "intersect/observer_frame.h"
#include "intersect/relative_error.h"
#include "intersect/wide_hierarchy.h"
#include "numeric/number_range.h"

namespace pyrasim {
namespace {

/// 113 bits: a sum of products of doubles and what is left when such sums cancel come out exact to double's rounding.
__extension__ using Quadruple = __float128;

/// By what power of two the largest coordinate may exceed 1, so that products of three coordinates, which a triangle's
/// depth takes, stay within the format. Fixed point so uses the bits that it has.
int largest_exponent(const NumberFormat& format) {
  constexpr int enough = 16;
  return std::min((integer_bits(format) - 4) / 3, enough);
}

double largest_component(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// Puts a scene's objects into a PreparedScene, in the order of the scene.
class Preparation {
 public:
  Preparation(const Scene& scene, const NumberFormat& format)
      : frame_(scene.camera), screen_(scene.camera.screen), format_(format), light_(scene.light) {
    if (light_) {
      light_direction_ = normalized(frame_.direction(light_->direction));
      prepared_.lit = true;
      prepared_.ambient = light_->ambient;
      prepared_.towards_light = -light_direction_;
    }
    for (const Object& object : scene.objects) {
      std::visit([this](const auto& surface) { this->add(surface); }, object.surface);
      ++object_;
    }
  }

  PreparedScene<double> take() {
    scale();
    for (auto& plane : prepared_.planes) {
      const auto [relative, squared_length] = relative_error(plane, prepared_.rounding);
      plane.relative_error = relative;
      plane.squared_length = squared_length;
    }
    build_wide_hierarchy(prepared_, screen_, format_);
    return std::move(prepared_);
  }

 private:
  SurfaceIdentity next_identity() { return {object_, order_++}; }

  void add(const Sphere& sphere) {
    const glm::dvec3 center = frame_.point(sphere.center);
    prepared_.spheres.push_back({center, sphere.radius * sphere.radius, power(sphere), sphere.radius, next_identity()});
    include(largest_component(center) + sphere.radius);
  }

  /// The power of the observer's place, |centre - place|^2 - radius^2. It cancels just above a sphere, by a factor of
  /// 2 height / radius; exact to double's rounding down to heights of 2^-60 radii. What is less than the rounding of
  /// the coordinates given is on the surface.
  double power(const Sphere& sphere) const {
    Quadruple power = -static_cast<Quadruple>(sphere.radius) * sphere.radius;
    for (int axis = 0; axis < 3; ++axis) {
      const Quadruple away = static_cast<Quadruple>(sphere.center[axis]) - frame_.position()[axis];
      power += away * away;
    }
    const double reach = sphere.radius + largest_component(sphere.center) + largest_component(frame_.position());
    const double rounding = 4 * epsilon<double>() * sphere.radius * reach;
    return std::abs(static_cast<double>(power)) > rounding ? static_cast<double>(power) : 0;
  }

  /// The offset from the observer's place cancels where that is near the plane and far from the world's origin; it is
  /// worked out exactly and rounded once. The normal keeps the length that it has, but for a power of two: at length 1
  /// its components would be rounded, by as much as the rest of t's computation errs.
  void add(const Plane& plane) {
    const int exponent = -std::ilogb(largest_component(plane.normal));
    const glm::dvec3 normal(std::ldexp(plane.normal.x, exponent), std::ldexp(plane.normal.y, exponent),
                            std::ldexp(plane.normal.z, exponent));
    Quadruple offset = plane.offset;
    for (int axis = 0; axis < 3; ++axis) {
      offset -= static_cast<Quadruple>(plane.normal[axis]) * frame_.position()[axis];
    }
    FlatShading<double> shading = flat_shading(frame_.direction(normalized(plane.normal)));
    shading.normal = frame_.direction(normal);
    prepared_.planes.push_back({std::ldexp(static_cast<double>(offset), exponent), next_identity(), shading});
    include(std::abs(prepared_.planes.back().offset));
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
    prepared_.triangles.push_back({{{{a.x, a.y, a.z}, {b.x, b.y, b.z}, {c.x, c.y, c.z}}}, next_identity()});
    prepared_.triangle_shading.push_back(flat_shading(normalized(cross(normalized(b - a), normalized(c - a)))));
    for (const glm::dvec3& vertex : {a, b, c}) include(largest_component(vertex));
  }

  /// Lambert's cosine law on either side of a flat surface: ambient + (1 - ambient) max(0, -n . l).
  FlatShading<double> flat_shading(const glm::dvec3& normal) const {
    if (!light_) return {normal, 1, 1};
    const double cosine = -dot(normal, light_direction_);
    const auto shading = [this](double c) { return light_->ambient + (1 - light_->ambient) * std::max(c, 0.0); };
    return {normal, shading(cosine), shading(-cosine)};
  }

  void include(double coordinate) { largest_ = std::max(largest_, coordinate); }

  /// Multiplies all lengths by the power of two that brings the largest to the exponent that suits the format: a scene
  /// 2^k times as large is the same to the datapath, bit for bit, and its squares neither over- nor underflow.
  void scale() {
    prepared_.rounding = rounding_units_of(format_);
    if (!(largest_ > 0)) return;
    const int exponent = largest_exponent(format_) - std::ilogb(largest_);
    const auto scaled = [exponent](double length) { return std::ldexp(length, exponent); };
    for (auto& sphere : prepared_.spheres) {
      sphere.center = {scaled(sphere.center.x), scaled(sphere.center.y), scaled(sphere.center.z)};
      sphere.radius_squared = std::ldexp(sphere.radius_squared, 2 * exponent);
      sphere.power = std::ldexp(sphere.power, 2 * exponent);
      sphere.radius = scaled(sphere.radius);
    }
    for (auto& plane : prepared_.planes) plane.offset = scaled(plane.offset);
    for (auto& triangle : prepared_.triangles) {
      for (auto& vertex : triangle.vertices) {
        for (double& coordinate : vertex) coordinate = scaled(coordinate);
      }
    }
    prepared_.exponent = exponent;
    prepared_.rounding.place = std::min(scaled(largest_component(frame_.position())), 0x1p500);
  }

  ObserverFrame frame_;
  Screen screen_;
  NumberFormat format_;
  std::optional<Light> light_;
  glm::dvec3 light_direction_{0, 0, 0};
  std::uint32_t object_ = 0;
  std::uint32_t order_ = 0;
  double largest_ = 0;  ///< coordinate in observer's coordinates
  PreparedScene<double> prepared_;
};

}  // namespace

PreparedScene<double> prepare_scene(const Scene& scene, const NumberFormat& format) {
  return Preparation(scene, format).take();
}

}  // namespace pyrasim
