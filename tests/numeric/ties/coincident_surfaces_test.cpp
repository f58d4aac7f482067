// SPDX-License-Identifier: Apache-2.0
// Different surfaces in one place, as written: the first in the scene is seen wherever both are, in every number
// format, from any angle, whichever comes first.
#include "camera/observer_frame.h"
#include "decimal_scene.h"
#include "every_hit.h"
#include "intersect/intersector.h"
#include "numeric/round_to_format.h"

namespace pyrasim {
namespace {

/// A plane through points whose decimals are given exactly: all of `point(i, j)`.
struct Lattice {
  glm::dvec3 origin, step, other_step;  ///< in thousandths, whole numbers

  glm::dvec3 point(int i, int j) const {
    const glm::dvec3 thousandths = origin + step * static_cast<double>(i) + other_step * static_cast<double>(j);
    return {read_as(thousandths.x), read_as(thousandths.y), read_as(thousandths.z)};
  }
  /// The same plane as an equation: the normal in whole numbers, the offset as written.
  Plane plane() const {
    const glm::dvec3 normal = cross(step, other_step);
    return {normal, read_as(dot(normal, origin))};
  }
};

glm::dvec3 whole(const glm::dvec3& v) { return {std::round(v.x), std::round(v.y), std::round(v.z)}; }

/// Before the camera, at any angle.
Lattice lattice_before(Random& random, const Camera& camera) {
  const glm::dvec3 forward = normalized(camera.look_at - camera.position);
  const double distance = random.uniform(3, 9);
  const glm::dvec3 middle = (camera.position + forward * distance) * decimals;
  return {whole(middle), whole(random.unit_vector() * (distance * 90)), whole(random.unit_vector() * (distance * 90))};
}

/// Triangles about the point (0, 0) of a lattice, `corners` of them round a rim.
Mesh fan(const Lattice& lattice, int corners, double turn) {
  Mesh mesh;
  mesh.vertices.push_back(lattice.point(0, 0));
  for (int k = 0; k < corners; ++k) {
    const double angle = turn + 2 * 3.141592653589793 * k / corners;
    mesh.vertices.push_back(lattice.point(static_cast<int>(std::lround(6 * std::cos(angle))),
                                          static_cast<int>(std::lround(6 * std::sin(angle)))));
    mesh.triangles.push_back({0, static_cast<std::uint32_t>(k + 1), static_cast<std::uint32_t>((k + 1) % corners + 1)});
  }
  return mesh;
}

struct Pair {
  const char* name;
  SceneSurface first, second;
};

std::vector<Pair> pairs(Random& random, const Camera& camera) {
  const Lattice lattice = lattice_before(random, camera);
  const glm::dvec3 a = lattice.point(-5, -4), b = lattice.point(6, -3), c = lattice.point(-1, 6);
  const Triangle triangle{{a, b, c}};
  const Triangle other{{lattice.point(5, -5), lattice.point(4, 5), lattice.point(-6, 1)}};
  const Sphere sphere{decimal(glm::dvec3(a)), 1.337};
  const Box box{decimal(b), decimal(b + glm::dvec3(3.125, 2.041, 1.337))};
  return {{"rotated", triangle, Triangle{{b, c, a}}},
          {"rotated twice", triangle, Triangle{{c, a, b}}},
          {"mirrored", triangle, Triangle{{b, a, c}}},
          {"mirrored and rotated", triangle, Triangle{{a, c, b}}},
          {"of one plane", triangle, other},
          {"on a plane", triangle, lattice.plane()},
          {"planes", lattice.plane(), Plane{-lattice.plane().normal, -lattice.plane().offset}},
          {"planes of other lengths", lattice.plane(), Plane{lattice.plane().normal * 3.0, lattice.plane().offset * 3}},
          {"spheres", sphere, sphere},
          {"fans", fan(lattice, 7, 0.2), fan(lattice, 12, 0.7)},
          {"a fan on a plane", fan(lattice, 9, 1), lattice.plane()},
          {"discs", Disc{c, lattice.plane().normal, 3.25}, Disc{a, -lattice.plane().normal, 6.5}},
          {"a disc on a plane", lattice.plane(), Disc{b, lattice.plane().normal, 4.125}},
          {"boxes", box, box}};
}

/// A scene of one surface.
class Alone {
 public:
  Alone(Scene scene, const SceneSurface& surface, const NumberFormat& format) {
    scene.objects = {object(surface)};
    intersector_ = make_intersector(scene, format);
  }
  bool hit(const glm::dvec3& v) const {
    Work work;
    return intersector_->intersect(v, work).seen.object != no_object;
  }

 private:
  std::unique_ptr<Intersector> intersector_;
};

/// Rays on which both are hit.
int expect_first_seen(const Pair& pair, Scene scene, const NumberFormat& format, Random& random) {
  const RoundToFormat round(format);
  const Alone first(scene, pair.first, format);
  const Alone second(scene, pair.second, format);
  scene.objects = {object(pair.first), object(pair.second)};
  const auto intersector = make_intersector(scene, format);
  std::swap(scene.objects[0], scene.objects[1]);
  const auto swapped = make_intersector(scene, format);
  int both = 0;
  for (int k = 0; k < 150; ++k) {
    glm::dvec3 v(1, random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5));
    v = {1, round(v.y), round(v.z)};
    if (!first.hit(v) || !second.hit(v)) continue;
    ++both;
    Work work;
    EXPECT_EQ(intersector->intersect(v, work).seen.object, 0U)
        << pair.name << " " << format.name() << " " << v.y << " " << v.z;
    EXPECT_EQ(swapped->intersect(v, work).seen.object, 0U)
        << pair.name << " " << format.name() << " " << v.y << " " << v.z;
  }
  return both;
}

TEST(CoincidentSurfaces, TheFirstIsSeenWhereverBothAre) {
  for (const NumberFormat& format : number_formats()) {
    Random random(5);
    int both = 0;
    for (const double reach : {0.0, 2.0, 5.0, 300.0}) {
      Scene scene = empty_scene(1, 1, 1);
      scene.camera = decimal_camera(random, reach);
      for (const Pair& pair : pairs(random, scene.camera)) both += expect_first_seen(pair, scene, format, random);
      if (testing::Test::HasFailure()) return;
    }
    EXPECT_GT(both, 1000) << format.name();
  }
}

/// Stacks of surfaces, some nearer to each other than a rounding, some farther: chains in which neighbours are at one
/// place but the ends are not. Decision D7 by its definition says what is seen; neither the hierarchy nor the order of
/// tests do.
class Stack {
 public:
  Stack(Random& random, const NumberFormat& format) {
    scene_ = empty_scene(1, 1, 1);
    const double unit = format.kind == NumberKind::fixed ? std::ldexp(16, -format.fraction_bits)
                                                         : std::ldexp(32, -format.significand_bits);
    // Far from the world's origin double rounds more than the format does.
    const double place = random.below(3) == 0 ? 4096 : 0;
    const double spacing = (unit + 0x1p-53 * place) * std::exp2(random.uniform(-1, 3));
    scene_.camera.position.x = -place;
    scene_.camera.look_at.x = 1 - place;
    for (int k = 0; k < 24; ++k) {
      const double depth = 5 * (1 + spacing * random.uniform(-2, 2)) - place;
      const auto kind = random.below(4);
      if (kind == 0) {
        scene_.objects.push_back(object(Plane{{1, 0, 0}, depth}));
      } else if (kind == 1) {
        scene_.objects.push_back(object(Sphere{{depth + 20, 0, 0}, 20}));
      } else {
        scene_.objects.push_back(object(Triangle{{{{depth, -3, -3}, {depth, 3, -3}, {depth, 0, 3}}}}));
      }
    }
  }
  const Scene& scene() const { return scene_; }

 private:
  Scene scene_;
};

TEST(CoincidentSurfaces, OfAChainTheFirstThatIsNotBehindIsSeen) {
  for (const NumberFormat& format : number_formats()) {
    Random random(9);
    const RoundToFormat round(format);
    int not_the_nearest = 0;
    int not_the_first = 0;
    for (int k = 0; k < 150; ++k) {
      const Stack stack(random, format);
      const auto every_hit = make_every_hit(stack.scene(), format);
      const auto intersector = make_intersector(stack.scene(), format);
      const auto exhaustive = make_intersector(stack.scene(), format, Search::exhaustive);
      for (int ray = 0; ray < 4; ++ray) {
        glm::dvec3 v(1, random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.05));
        v = {1, round(v.y), round(v.z)};
        const auto hits = every_hit->of(v);
        const std::uint32_t expected = object_seen(hits);
        Work work;
        ASSERT_EQ(intersector->intersect(v, work).seen.object, expected) << format.name() << " " << k;
        ASSERT_EQ(exhaustive->intersect(v, work).seen.object, expected) << format.name() << " " << k;
        const auto nearest =
            std::min_element(hits.begin(), hits.end(), [](const KnownHit& p, const KnownHit& q) { return p.t < q.t; });
        not_the_nearest += nearest->identity.object == expected ? 0 : 1;
        not_the_first += expected == 0 ? 0 : 1;
      }
    }
    EXPECT_GT(not_the_nearest, 25) << format.name();
    EXPECT_GT(not_the_first, 50) << format.name();
  }
}

double error_of(const KnownHit& hit) { return std::max(hit.range.highest - hit.t, hit.t - hit.range.lowest); }

/// A triangle about the view vector, all of it at one depth.
Triangle across(const Camera& camera, const glm::dvec3& v, double depth) {
  const glm::dvec3 forward = normalized(camera.look_at - camera.position);
  const glm::dvec3 right = normalized(cross(forward, normalized(camera.up)));
  const glm::dvec3 up = cross(right, forward);
  const auto at = [&](double y, double z) {
    return camera.position + (forward + up * (v.y + y) + right * (v.z + z)) * depth;
  };
  return {{{at(-0.05, -0.05), at(0.05, -0.05), at(0, 0.05)}}};
}

/// Puts a triangle before the only surface of the scene, nearer by a few errors; whether the ray's hits on both are
/// farther apart than what they may err by.
bool put_before(Scene& scene, const NumberFormat& format, const glm::dvec3& v) {
  const auto every_hit = make_every_hit(scene, format);
  const auto alone = every_hit->of(v);
  if (alone.empty() || alone[0].saturated) return false;
  const int bits = format.kind == NumberKind::fixed ? format.fraction_bits : format.significand_bits;
  const double gap = 4 * error_of(alone[0]) + std::ldexp(64 * alone[0].t, -bits);
  const double depth = std::ldexp(alone[0].t - gap, -every_hit->exponent());
  if (!(depth > 0)) return false;
  scene.objects.push_back(object(across(scene.camera, v, depth)));
  const auto hits = make_every_hit(scene, format)->of(v);
  return hits.size() == 2 && std::abs(hits[0].t - hits[1].t) > error_of(hits[0]) + error_of(hits[1]);
}

TEST(CoincidentSurfaces, WhatIsNearerByMoreThanTheErrorsIsSeenThoughItComesLast) {
  for (const NumberFormat& format : number_formats()) {
    Random random(21);
    const RoundToFormat round(format);
    int apart = 0;
    for (int k = 0; k < 200; ++k) {
      Scene scene = empty_scene(1, 1, 1);
      scene.camera = decimal_camera(random, k % 2 == 0 ? 0 : 5);
      const auto pair = pairs(random, scene.camera)[random.below(9)];
      scene.objects = {object(pair.second)};
      glm::dvec3 v(1, random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4));
      v = {1, round(v.y), round(v.z)};
      if (!put_before(scene, format, v)) continue;
      ++apart;
      Work work;
      ASSERT_EQ(make_intersector(scene, format)->intersect(v, work).seen.object, 1U)
          << format.name() << " " << pair.name;
    }
    EXPECT_GT(apart, 20) << format.name();
  }
}

}  // namespace
}  // namespace pyrasim
