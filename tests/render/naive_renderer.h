// SPDX-License-Identifier: Apache-2.0
// The method once more, as short as it can be said, to check the renderer against: doubles throughout, textbook
// intersections, every ray traced whenever it is asked for, colours summed on the way back from the recursion.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "image/image.h"
#include "scene/scene.h"

namespace pyrasim {

/// Only for cameras in the observer's own frame, without a light: spheres, planes and triangles.
class NaiveRenderer {
 public:
  NaiveRenderer(const Scene& scene, int max_level, bool drop) : scene_(scene), max_level_(max_level), drop_(drop) {}

  using Points = std::set<std::pair<std::uint32_t, std::uint32_t>>;
  Image image;
  std::uint64_t rays = 0;  ///< corners once, and five for each subdivision
  std::uint64_t subdivisions = 0;
  std::uint64_t terminal_nodes = 0;
  std::uint64_t points_by_pixel = 0;  ///< points of subdivisions that differ, summed over pixels
  Points points;                      ///< points of subdivisions that differ, over the frame

  void render() {
    const Screen& screen = scene_.camera.screen;
    image = Image(screen.columns, screen.rows);
    rays = static_cast<std::uint64_t>(screen.rows + 1) * static_cast<std::uint64_t>(screen.columns + 1);
    for (int mu = 0; mu < screen.rows; ++mu) {
      for (int nu = 0; nu < screen.columns; ++nu) {
        pixel_points_.clear();
        image.at(mu, nu) = glm::vec3(pyramid(mu, nu, 1, 0));
        points_by_pixel += pixel_points_.size();
        points.insert(pixel_points_.begin(), pixel_points_.end());
      }
    }
  }

 private:
  /// The colour of the pyramid whose upper left corner lies at (mu, nu) in pixels, with sides of `d` pixels.
  glm::dvec3 pyramid(double mu, double nu, double d, int level) {
    const std::array<int, 4> corner{hit(mu, nu), hit(mu, nu + d), hit(mu + d, nu), hit(mu + d, nu + d)};
    const bool equal = corner[0] == corner[1] && corner[0] == corner[2] && corner[0] == corner[3];
    if (!equal && level < max_level_) {
      const double h = d / 2;
      ++subdivisions;
      rays += 5;
      for (const auto& [i, j] : {std::pair{0.0, h}, {h, 0.0}, {h, h}, {h, d}, {d, h}}) add_point(mu + i, nu + j);
      return (pyramid(mu, nu, h, level + 1) + pyramid(mu, nu + h, h, level + 1) + pyramid(mu + h, nu, h, level + 1) +
              pyramid(mu + h, nu + h, h, level + 1)) /
             4.0;
    }
    ++terminal_nodes;
    if (!equal && drop_) return scene_.background;
    return (color(corner[0]) + color(corner[1]) + color(corner[2]) + color(corner[3])) / 4.0;
  }

  void add_point(double mu, double nu) {
    const double steps = std::ldexp(1, max_level_);
    pixel_points_.emplace(static_cast<std::uint32_t>(mu * steps), static_cast<std::uint32_t>(nu * steps));
  }

  glm::dvec3 color(int object) const {
    return object < 0 ? scene_.background : scene_.objects[static_cast<std::size_t>(object)].color;
  }

  /// What these intersections may err by in scenes as tests have them, of t: nearer by less is in the same place.
  static constexpr double one_place = 1e-12;

  /// The object that formula (2)'s view vector meets first; -1 for none.
  int hit(double mu, double nu) const {
    const Screen& screen = scene_.camera.screen;
    const glm::dvec3 v(screen.dx, (screen.rows / 2.0 - mu) * screen.dy, (nu - screen.columns / 2.0) * screen.dz);
    double nearest = std::numeric_limits<double>::infinity();
    int best = -1;
    for (std::size_t k = 0; k < scene_.objects.size(); ++k) {
      const double t = std::visit([&](const auto& surface) { return distance(surface, v); }, scene_.objects[k].surface);
      if (t > 0 && t < nearest * (1 - one_place)) {
        nearest = t;
        best = static_cast<int>(k);
      }
    }
    return best;
  }

  static double distance(const Sphere& sphere, const glm::dvec3& v) {
    const double a = glm::dot(v, v);
    const double b = glm::dot(v, sphere.center);
    const double c = glm::dot(sphere.center, sphere.center) - sphere.radius * sphere.radius;
    const double root = std::sqrt(b * b - a * c);  // NaN where the ray misses, and no comparison holds
    const double near = (b - root) / a;
    return near > 0 ? near : (b + root) / a;
  }
  static double distance(const Plane& plane, const glm::dvec3& v) { return plane.offset / glm::dot(plane.normal, v); }
  /// Cramer's rule (Möller, Trumbore 1997).
  static double distance(const Triangle& triangle, const glm::dvec3& v) {
    const glm::dvec3 a = triangle.vertices[0];
    const glm::dvec3 e = triangle.vertices[1] - a;
    const glm::dvec3 f = triangle.vertices[2] - a;
    const glm::dvec3 p = glm::cross(v, f);
    const double determinant = glm::dot(e, p);
    const glm::dvec3 q = glm::cross(-a, e);
    const double s = glm::dot(-a, p) / determinant;
    const double r = glm::dot(v, q) / determinant;
    return s >= 0 && r >= 0 && s + r <= 1 ? glm::dot(f, q) / determinant : 0;
  }
  static double distance(const Disc& disc, const glm::dvec3& v) {
    const double t = glm::dot(disc.normal, disc.center) / glm::dot(disc.normal, v);
    return glm::length(v * t - disc.center) <= disc.radius ? t : 0;
  }
  static double distance(const Box& box, const glm::dvec3& v) {
    const glm::dvec3 a = box.min / v;
    const glm::dvec3 b = box.max / v;
    const glm::dvec3 enter = glm::min(a, b);
    const glm::dvec3 leave = glm::max(a, b);
    const double first = std::max({enter.x, enter.y, enter.z});
    const double last = std::min({leave.x, leave.y, leave.z});
    return first <= last ? (first > 0 ? first : last) : 0;
  }
  static double distance(const Ellipsoid& ellipsoid, const glm::dvec3& v) {
    return distance(Sphere{ellipsoid.center / ellipsoid.radii, 1}, v / ellipsoid.radii);
  }
  static double distance(const Cylinder& cylinder, const glm::dvec3& v) {
    return distance(Cone{cylinder.axis, cylinder.radius, cylinder.radius, cylinder.capped}, v);
  }
  /// All places of the skin and of the ends, and the nearest that is there.
  static double distance(const Cone& cone, const glm::dvec3& v) {
    const double length = glm::distance(cone.axis.base, cone.axis.cap);
    const glm::dvec3 unit = (cone.axis.cap - cone.axis.base) / length;
    const double slope = (cone.cap_radius - cone.base_radius) / length;
    const double oz = -glm::dot(unit, cone.axis.base);
    const double dz = glm::dot(unit, v);
    const glm::dvec3 across = -cone.axis.base - unit * oz;
    const glm::dvec3 moving = v - unit * dz;
    const double w = cone.base_radius + slope * oz;
    const double a = glm::dot(moving, moving) - slope * dz * slope * dz;
    const double b = glm::dot(across, moving) - w * slope * dz;
    const double c = glm::dot(across, across) - w * w;
    const double root = std::sqrt(b * b - a * c);  // NaN where the ray misses, and no comparison holds
    double nearest = std::numeric_limits<double>::infinity();
    for (const double t : {(-b - root) / a, (-b + root) / a}) {
      const double height = oz + t * dz;
      if (t > 0 && height >= 0 && height <= length) nearest = std::min(nearest, t);
    }
    for (const auto& [height, radius] : {std::pair(0.0, cone.base_radius), {length, cone.cap_radius}}) {
      const double t = (height - oz) / dz;
      if (cone.capped && t > 0 && glm::length(across + moving * t) <= radius) nearest = std::min(nearest, t);
    }
    return nearest < std::numeric_limits<double>::infinity() ? nearest : 0;
  }
  static double distance(const Quadric& quadric, const glm::dvec3& v) {
    const auto& of = quadric.coefficients;
    const double a = of.xx * v.x * v.x + of.yy * v.y * v.y + of.zz * v.z * v.z + of.xy * v.x * v.y + of.xz * v.x * v.z +
                     of.yz * v.y * v.z;
    const double b = (of.x * v.x + of.y * v.y + of.z * v.z) / 2;
    const double root = std::sqrt(b * b - a * of.constant);
    double nearest = std::numeric_limits<double>::infinity();
    const auto offer = [&](double t, const HalfSpace<double>* but) {
      const auto holds = [&](const auto& other) {
        return &other == but || t * glm::dot(other.normal, v) <= other.offset;
      };
      if (t > 0 && std::all_of(quadric.clip.begin(), quadric.clip.end(), holds)) nearest = std::min(nearest, t);
    };
    for (const double t : {(-b - root) / a, (-b + root) / a}) offer(t, nullptr);
    for (const HalfSpace<double>& plane : quadric.clip) {
      const double t = plane.offset / glm::dot(plane.normal, v);
      if (quadric.capped && (a * t + 2 * b) * t + of.constant <= 0) offer(t, &plane);
    }
    return nearest < std::numeric_limits<double>::infinity() ? nearest : 0;
  }
  static double distance(const Polygon& polygon, const glm::dvec3& v) {
    for (std::size_t k = 2; k < polygon.vertices.size(); ++k) {
      const double t = distance(Triangle{{polygon.vertices[0], polygon.vertices[k - 1], polygon.vertices[k]}}, v);
      if (t > 0) return t;
    }
    return 0;
  }
  /// As far at a time as nothing can be (Hart, Sphere Tracing, The Visual Computer 1996).
  static double distance(const Torus& torus, const glm::dvec3& v) {
    const glm::dvec3 axis = glm::normalize(torus.axis);
    const double end = glm::length(torus.center) + torus.major_radius + torus.minor_radius;
    for (double t = 0; t < end;) {
      const glm::dvec3 place = t * v - torus.center;
      const double height = glm::dot(axis, place);
      const double from_axis = glm::length(place - axis * height);
      const double free = std::abs(std::hypot(from_axis - torus.major_radius, height) - torus.minor_radius);
      if (free < 1e-10) return t;
      t += free / glm::length(v);
    }
    return 0;
  }
  static double distance(const Mesh&, const glm::dvec3&) { return 0; }
  static double distance(const MeshInstance& instance, const glm::dvec3& v) {
    const Mesh& mesh = instance.of->mesh;
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& triangle : mesh.triangles) {
      Triangle placed;
      for (std::size_t k = 0; k < 3; ++k) {
        placed.vertices[k] = rounded(instance.map.point(exactly(mesh.vertices[triangle[k]])));
      }
      const double t = distance(placed, v);
      if (t > 0) nearest = std::min(nearest, t);
    }
    return nearest < std::numeric_limits<double>::infinity() ? nearest : 0;
  }
  /// Random scenes have no transforms.
  static double distance(const Parallelepiped&, const glm::dvec3&) { return 0; }
  static double distance(const FramedQuadric&, const glm::dvec3&) { return 0; }

  const Scene& scene_;
  int max_level_;
  bool drop_;
  Points pixel_points_;
};

}  // namespace pyrasim
