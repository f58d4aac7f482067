// SPDX-License-Identifier: Apache-2.0
#include "exact_distance.h"

#include <vector>

#include "../torus_oracle.h"

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

/// `vertex`: from the ray's origin.
std::optional<Real> triangle_distance(const std::array<RealVector, 3>& vertex, const WorldRay& ray) {
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

std::optional<Real> distance(const Triangle& triangle, const WorldRay& ray) {
  std::array<RealVector, 3> vertex;
  for (std::size_t k = 0; k < 3; ++k) vertex[k] = written(triangle.vertices[k]) - ray.origin;
  return triangle_distance(vertex, ray);
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

/// The roots of a t^2 + 2 b t + c, of which a may be nearly 0.
std::vector<Real> roots(const Real& a, const Real& b, const Real& c) {
  const Real discriminant = b * b - a * c;
  if (discriminant < Real(0)) return {};
  const Real root = sqrt(discriminant);
  const Real h = b < Real(0) ? root - b : -(b + root);
  std::vector<Real> found;
  if (!(h == Real(0))) found.push_back(c / h);
  if (!(a == Real(0))) found.push_back(h / a);
  return found;
}

std::optional<Real> distance(const Ellipsoid& ellipsoid, const WorldRay& ray) {
  const RealVector from_center = ray.origin - written(ellipsoid.center);
  const RealVector r = written(ellipsoid.radii);
  const RealVector o{from_center.x / r.x, from_center.y / r.y, from_center.z / r.z};
  const RealVector d{ray.direction.x / r.x, ray.direction.y / r.y, ray.direction.z / r.z};
  std::optional<Real> nearest;
  for (const Real& t : roots(dot(d, d), dot(o, d), dot(o, o) - Real(1))) {
    if (t > Real(0) && (!nearest || t < *nearest)) nearest = t;
  }
  return nearest;
}

/// Of x^2 + y^2 = w^2 about an axis, where w = radius + slope * height above its base: the first of its own hits
/// between the ends and, of a solid, of those of its ends within their radius.
std::optional<Real> round_distance(const AxisSegment& axis, const Real& base_radius, const Real& cap_radius,
                                   bool capped, const WorldRay& ray) {
  const RealVector along = written(axis.cap) - written(axis.base);
  const Real length = sqrt(dot(along, along));
  const RealVector unit = along * (Real(1) / length);
  const RealVector o = ray.origin - written(axis.base);
  const Real slope = (cap_radius - base_radius) / length;
  const Real oz = dot(unit, o), dz = dot(unit, ray.direction);
  const RealVector across = o - unit * oz, moving = ray.direction - unit * dz;
  const Real w = base_radius + slope * oz, dw = slope * dz;
  const Real a = dot(moving, moving) - dw * dw, b = dot(across, moving) - w * dw, c = dot(across, across) - w * w;
  std::optional<Real> nearest;
  const auto offer = [&](const Real& t) {
    if (t > Real(0) && (!nearest || t < *nearest)) nearest = t;
  };
  for (const Real& t : roots(a, b, c)) {
    const Real height = oz + t * dz;
    if (!(height < Real(0)) && !(height > length)) offer(t);
  }
  if (!capped || dz == Real(0)) return nearest;
  for (const auto& [height, radius] : {std::pair(Real(0), base_radius), std::pair(length, cap_radius)}) {
    const Real t = (height - oz) / dz;
    const RealVector place = across + moving * t;
    if (!(dot(place, place) > radius * radius)) offer(t);
  }
  return nearest;
}

std::optional<Real> distance(const Cylinder& cylinder, const WorldRay& ray) {
  const Real radius = written(cylinder.radius);
  return round_distance(cylinder.axis, radius, radius, cylinder.capped, ray);
}

std::optional<Real> distance(const Cone& cone, const WorldRay& ray) {
  return round_distance(cone.axis, written(cone.base_radius), written(cone.cap_radius), cone.capped, ray);
}

/// The nearest of its own hits that all half-spaces have and, of a solid, of those of the planes that all others have
/// and that lie inside.
std::optional<Real> distance(const Quadric& quadric, const WorldRay& ray) {
  const auto& of = quadric.coefficients;
  const auto squares = [&](const RealVector& p, const RealVector& q) {
    const Real twice =
        Real(2) * (written(of.xx) * p.x * q.x + written(of.yy) * p.y * q.y + written(of.zz) * p.z * q.z) +
        written(of.xy) * (p.x * q.y + p.y * q.x) + written(of.xz) * (p.x * q.z + p.z * q.x) +
        written(of.yz) * (p.y * q.z + p.z * q.y);
    return twice / Real(2);
  };
  const RealVector linear = written(glm::dvec3(of.x, of.y, of.z));
  const Real a = squares(ray.direction, ray.direction);
  const Real b = squares(ray.direction, ray.origin) + dot(linear, ray.direction) / Real(2);
  const Real c = squares(ray.origin, ray.origin) + dot(linear, ray.origin) + written(of.constant);
  std::optional<Real> nearest;
  const auto offer = [&](const Real& t, const HalfSpace<double>* but) {
    if (!(t > Real(0)) || (nearest && !(t < *nearest))) return;
    for (const HalfSpace<double>& other : quadric.clip) {
      if (&other == but) continue;
      const RealVector normal = written(other.normal);
      if (dot(normal, ray.origin) + t * dot(normal, ray.direction) > written(other.offset)) return;
    }
    nearest = t;
  };
  for (const Real& t : roots(a, b, c)) offer(t, nullptr);
  for (const HalfSpace<double>& plane : quadric.clip) {
    const RealVector normal = written(plane.normal);
    const Real approach = dot(normal, ray.direction);
    if (!quadric.capped || approach == Real(0)) continue;
    const Real t = (written(plane.offset) - dot(normal, ray.origin)) / approach;
    if (!((a * t + Real(2) * b) * t + c > Real(0))) offer(t, &plane);
  }
  return nearest;
}

/// Of the triangles that fan out from its first vertex.
std::optional<Real> distance(const Polygon& polygon, const WorldRay& ray) {
  const auto& v = polygon.vertices;
  std::optional<Real> nearest;
  for (std::size_t k = 2; k < v.size() && !nearest; ++k) nearest = distance(Triangle{{v[0], v[k - 1], v[k]}}, ray);
  return nearest;
}

std::optional<Real> distance(const Torus& torus, const WorldRay& ray) {
  const auto triple = [](const RealVector& v) { return std::array<Real, 3>{v.x, v.y, v.z}; };
  const TorusOracle<Real> oracle{triple(written(torus.center) - ray.origin), triple(written(torus.axis)),
                                 written(torus.major_radius), written(torus.minor_radius)};
  return oracle.first_hit(triple(ray.direction));
}

std::optional<Real> distance(const Mesh&, const WorldRay&) { return std::nullopt; }

/// A number of 113 bits, as two of double's.
Real real(Quadruple x) {
  const auto high = static_cast<double>(x);
  return Real(high) + Real(static_cast<double>(x - high));
}
RealVector real(const QuadrupleVector& v) { return {real(v[0]), real(v[1]), real(v[2])}; }

/// The map is exact as 113 bits have it.
std::optional<Real> distance(const MeshInstance& instance, const WorldRay& ray) {
  const RealVector x = real(instance.map.direction({1, 0, 0})), y = real(instance.map.direction({0, 1, 0})),
                   z = real(instance.map.direction({0, 0, 1}));
  std::optional<Real> nearest;
  for (const auto& triangle : instance.of->mesh.triangles) {
    std::array<RealVector, 3> vertex;
    for (std::size_t k = 0; k < 3; ++k) {
      const RealVector v = written(instance.of->mesh.vertices[triangle[k]]);
      vertex[k] = x * v.x + y * v.y + z * v.z + real(instance.map.offset()) - ray.origin;
    }
    const auto t = triangle_distance(vertex, ray);
    if (t && (!nearest || *t < *nearest)) nearest = t;
  }
  return nearest;
}

/// What transforms make of surfaces is compared with the surfaces themselves, met by rays that are mapped back.
std::optional<Real> distance(const Parallelepiped&, const WorldRay&) { return std::nullopt; }
std::optional<Real> distance(const FramedQuadric&, const WorldRay&) { return std::nullopt; }

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
