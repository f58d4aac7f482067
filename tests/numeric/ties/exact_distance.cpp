// SPDX-License-Identifier: Apache-2.0
#include "exact_distance.h"

namespace pyrasim {
namespace {

RealVector operator-(const RealVector& a, const RealVector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
RealVector operator+(const RealVector& a, const RealVector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
RealVector operator*(const RealVector& v, const Real& factor) { return {v.x * factor, v.y * factor, v.z * factor}; }

RealVector cross(const RealVector& a, const RealVector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
RealVector normalized(const RealVector& v) { return v * (Real(1) / sqrt(dot(v, v))); }

std::optional<Real> ahead(const Real& t) { return t > Real(0) ? std::optional(t) : std::nullopt; }

std::optional<Real> distance(const Sphere& sphere, const WorldRay& ray) {
  const RealVector center = written(sphere.center) - ray.origin;
  const Real radius = written(sphere.radius);
  const Real a = dot(ray.direction, ray.direction);
  const Real b = dot(ray.direction, center);
  const Real discriminant = b * b - a * (dot(center, center) - radius * radius);
  if (discriminant < Real(0)) return std::nullopt;
  const Real root = sqrt(discriminant);
  const auto near = ahead((b - root) / a);
  return near ? near : ahead((b + root) / a);
}

std::optional<Real> distance(const Plane& plane, const WorldRay& ray) {
  const RealVector normal = written(plane.normal);
  const Real approach = dot(normal, ray.direction);
  if (approach == Real(0)) return std::nullopt;
  return ahead((written(plane.offset) - dot(normal, ray.origin)) / approach);
}

std::optional<Real> distance(const Triangle& triangle, const WorldRay& ray) {
  std::array<RealVector, 3> vertex;
  for (std::size_t k = 0; k < 3; ++k) vertex[k] = written(triangle.vertices[k]) - ray.origin;
  bool negative = false;
  bool positive = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const Real side = dot(cross(vertex[k], vertex[(k + 1) % 3]), ray.direction);
    negative |= side < Real(0);
    positive |= side > Real(0);
  }
  const RealVector normal = cross(vertex[1] - vertex[0], vertex[2] - vertex[0]);
  const Real approach = dot(normal, ray.direction);
  if ((negative && positive) || approach == Real(0)) return std::nullopt;
  return ahead(dot(normal, vertex[0]) / approach);
}

std::optional<Real> distance(const Disc& disc, const WorldRay& ray) {
  const RealVector normal = written(disc.normal);
  const RealVector center = written(disc.center) - ray.origin;
  const Real approach = dot(normal, ray.direction);
  if (approach == Real(0)) return std::nullopt;
  const Real t = dot(normal, center) / approach;
  const RealVector from_center = ray.direction * t - center;
  const Real radius = written(disc.radius);
  return dot(from_center, from_center) <= radius * radius ? ahead(t) : std::nullopt;
}

/// The nearest of the six faces' hits ahead that lie between the other two pairs.
std::optional<Real> distance(const Box& box, const WorldRay& ray) {
  const RealVector lower = written(box.min) - ray.origin;
  const RealVector upper = written(box.max) - ray.origin;
  const std::array<Real, 3> d{ray.direction.x, ray.direction.y, ray.direction.z};
  const std::array<Real, 3> low{lower.x, lower.y, lower.z};
  const std::array<Real, 3> high{upper.x, upper.y, upper.z};
  std::optional<Real> nearest;
  for (std::size_t k = 0; k < 3; ++k) {
    if (d[k] == Real(0)) continue;
    for (const Real& face : {low[k], high[k]}) {
      const Real t = face / d[k];
      bool inside = t > Real(0);
      for (std::size_t other = 0; other < 3; ++other) {
        if (other == k) continue;
        const Real at = d[other] * t;
        inside &= !(at < low[other]) && !(at > high[other]);
      }
      if (inside && (!nearest || t < *nearest)) nearest = t;
    }
  }
  return nearest;
}

std::optional<Real> distance(const Mesh&, const WorldRay&) { return std::nullopt; }

}  // namespace

WorldRay::WorldRay(const Camera& camera, const glm::dvec3& view_vector) : origin(written(camera.position)) {
  const RealVector forward = normalized(real(camera.look_at - camera.position));
  const RealVector right = normalized(cross(forward, real(camera.up)));
  const RealVector up = cross(right, forward);
  direction = forward * Real(view_vector.x) + up * Real(view_vector.y) + right * Real(view_vector.z);
}

std::optional<Real> exact_distance(const SceneSurface& surface, const WorldRay& ray) {
  return std::visit([&](const auto& alternative) { return distance(alternative, ray); }, surface);
}

}  // namespace pyrasim
