// SPDX-License-Identifier: Apache-2.0
// Extremes: surfaces of second order far from the world's origin and seen from far, and rays along their generators.
#include "far_hits.h"
#include "numeric/round_to_format.h"
#include "surface/transformed.h"

namespace pyrasim {
namespace {

struct Kind {
  const char* name;
  double gate;  ///< of the 99th percentile of errors, ulp
  /// The same of the mapped ones, more of whose rays run near outlines: as many ulp in float as in double, so that they
  /// are those of the kernel.
  double askew_gate;
  SceneSurface (*about)(const glm::dvec3& center);
};

/// (p - center)^T diag(squares) (p - center) + linear (z - center.z) + constant within a cube of half side 2.
SceneSurface clipped(const glm::dvec3& squares, double linear, double constant, const glm::dvec3& center) {
  Quadric quadric;
  quadric.coefficients = {.xx = squares.x, .yy = squares.y, .zz = squares.z};
  auto& of = quadric.coefficients;
  of.x = -2 * squares.x * center.x;
  of.y = -2 * squares.y * center.y;
  of.z = linear - 2 * squares.z * center.z;
  of.constant = constant - linear * center.z + dot(squares * center, center);
  for (int axis = 0; axis < 3; ++axis) {
    for (const double outward : {-1.0, 1.0}) {
      glm::dvec3 normal(0);
      normal[axis] = outward;
      quadric.clip.push_back({normal, outward * center[axis] + 2});
    }
  }
  return quadric;
}

/// All numbers have few digits in binary, so that even coefficients at the world's origin are what they should be.
const std::array<Kind, 7> kinds{{{"ellipsoid", 8, 8,
                                  [](const glm::dvec3& c) -> SceneSurface {
                                    return Ellipsoid{c, {1, 2, 0.5}};
                                  }},
                                 {"cylinder", 8, 8,
                                  [](const glm::dvec3& c) -> SceneSurface {
                                    return Cylinder{{c - glm::dvec3(1, 0.5, 1), c + glm::dvec3(1, 0.5, 1)}, 0.75};
                                  }},
                                 {"cone", 8, 8,
                                  [](const glm::dvec3& c) -> SceneSurface {
                                    return Cone{{c - glm::dvec3(1, 0.5, 1), c + glm::dvec3(1, 0.5, 1)}, 1, 0.25};
                                  }},
                                 {"paraboloid", 8, 8,
                                  [](const glm::dvec3& c) -> SceneSurface {
                                    return clipped({1, 1, 0}, 1, -1, c);
                                  }},
                                 {"hyperboloid of one sheet", 8, 16,
                                  [](const glm::dvec3& c) -> SceneSurface {
                                    return clipped({1, 1, -1}, 0, -0.25, c);
                                  }},
                                 {"hyperboloid of two sheets", 8, 16,
                                  [](const glm::dvec3& c) -> SceneSurface {
                                    return clipped({1, 1, -1}, 0, 0.25, c);
                                  }},
                                 {"saddle", 32, 64, [](const glm::dvec3& c) -> SceneSurface {
                                    return clipped({1, -1, 0}, 1, 0, c);
                                  }}}};

/// Of few digits; the inverse, too, in numbers that hold it.
const std::array<glm::dvec3, 3> askew_rows{{{1, 0.5, 0}, {0.25, 1, -0.5}, {0, 0.125, -1.5}}};

AffineMap askew_about(const glm::dvec3& center) {
  return {{exactly(askew_rows[0]), exactly(askew_rows[1]), exactly(askew_rows[2])}, exactly(center)};
}

/// By cross products of rows.
RealVector mapped_back(const RealVector& v) {
  const auto& [a, b, c] = askew_rows;
  const double volume = dot(a, cross(b, c));  // exact
  const auto column = [&](const glm::dvec3& p, const glm::dvec3& q, const Real& x) {
    const RealVector n = real(cross(p, q));
    return RealVector{n.x * x / Real(volume), n.y * x / Real(volume), n.z * x / Real(volume)};
  };
  const RealVector x = column(b, c, v.x), y = column(c, a, v.y), z = column(a, b, v.z);
  return {x.x + y.x + z.x, x.y + y.y + z.y, x.z + y.z + z.z};
}

/// Along a view vector; of a mapped surface by mapping the ray back to where the surface was written.
std::optional<Real> exact_along(const Scene& scene, const Kind& kind, bool askew, const glm::dvec3& v) {
  WorldRay ray(scene.camera, v);
  if (!askew) return exact_distance(scene.objects[0].surface, ray);
  const RealVector center = real(scene.camera.look_at);
  ray.origin = mapped_back({ray.origin.x - center.x, ray.origin.y - center.y, ray.origin.z - center.z});
  ray.direction = mapped_back(ray.direction);
  return exact_distance(kind.about(glm::dvec3(0)), ray);
}

/// A surface about a point far out, and a camera `distance` from it.
Scene far_out(Random& random, const Kind& kind, bool askew, double distance) {
  const glm::dvec3 center = whole(random.unit_vector() * 1e5);
  Scene scene = empty_scene(1, 1, 1);
  scene.camera = decimal_camera(random, 0);
  scene.camera.position = center + whole(random.unit_vector() * distance);
  scene.camera.look_at = center;
  scene.objects = {object(askew ? transformed(kind.about(glm::dvec3(0)), askew_about(center)) : kind.about(center))};
  return scene;
}

template <class Scalar>
FarHits far_hits(const Kind& kind, bool askew, double distance) {
  Random random(17);
  FarHits found;
  for (int k = 0; k < 40; ++k) {
    const Scene scene = far_out(random, kind, askew, distance);
    const auto along = [&](const glm::dvec3& v) { return exact_along(scene, kind, askew, v); };
    const auto tester = make_every_hit(scene, format_of<Scalar>());
    const glm::dvec3 center(
        std::sqrt(dot(scene.camera.position - scene.camera.look_at, scene.camera.position - scene.camera.look_at)), 0,
        0);
    for (int ray = 0; ray < 40; ++ray) found.add<Scalar>(*tester, along, center + random.vector(-1.5, 1.5));
  }
  return found;
}

template <class Scalar>
void expect_few_units(bool askew = false) {
  for (const Kind& kind : kinds) {
    for (const double distance : {8.0, 128.0}) {
      const FarHits found = far_hits<Scalar>(kind, askew, distance);
      ASSERT_GT(found.of_t.size(), 100U) << kind.name;
      const double most = found.p99();
      print_figure(fmt::format("{}{}, 1e5 from the origin, {} away: p99", askew ? "askew " : "", kind.name, distance),
                   format_of<Scalar>(),
                   fmt::format("{:.1f} ulp of {} hits, {} wrong", most, found.of_t.size(), found.wrong));
      EXPECT_LE(most, askew ? kind.askew_gate : kind.gate) << kind.name;
      EXPECT_EQ(found.wrong, 0) << kind.name;
    }
  }
}

TEST(ExtremesQuadrics, FarFromTheOriginInDouble) { expect_few_units<double>(); }
TEST(ExtremesQuadrics, FarFromTheOriginInFloat) { expect_few_units<float>(); }
TEST(ExtremesQuadrics, MappedFarFromTheOriginInDouble) { expect_few_units<double>(true); }
TEST(ExtremesQuadrics, MappedFarFromTheOriginInFloat) { expect_few_units<float>(true); }

struct Along {
  SceneSurface surface;
  glm::dvec3 direction;
};

/// The surface seen along the direction, from somewhere before it.
Scene seen_along(Random& random, const Along& along) {
  Scene scene = empty_scene(1, 1, 1);
  scene.camera = decimal_camera(random, 0);
  const glm::dvec3 back = normalized(along.direction) * 6.0;
  scene.camera.position = decimal(glm::dvec3(9, 0, 0) - back + random.vector(-1, 1));
  scene.camera.look_at = scene.camera.position + along.direction;
  scene.objects = {object(along.surface)};
  return scene;
}

/// The square's coefficient of t vanishes there: rays along a cone's side, a cylinder's axis, a hyperboloid's lines and
/// a paraboloid's axis, and next to them.
TEST(ExtremesQuadrics, RaysAlongGenerators) {
  const std::array<Along, 5> all{{{Cone{{{8, 0, 0}, {12, 0, 0}}, 0, 4}, {4, 4, 0}},
                                  {Cone{{{8, 0, 0}, {12, 0, 0}}, 3, 0, false}, {4, 3, 0}},
                                  {Cylinder{{{8, 0, 0}, {12, 0, 0}}, 1}, {1, 0, 0}},
                                  {clipped({1, 1, -1}, 0, -0.25, {8, 0, 0}), {0, 1, 1}},
                                  {clipped({1, 1, 0}, 1, -1, {8, 0, 0}), {0, 0, 1}}}};
  for (const NumberFormat& format : number_formats()) {
    SCOPED_TRACE(format.name());
    const RoundToFormat round(format);
    Random random(5);
    int hits_met = 0;
    for (const Along& along : all) {
      for (int k = 0; k < 200; ++k) {
        const Scene scene = seen_along(random, along);
        const double aside = k % 4 == 0 ? 0 : std::exp2(random.uniform(-60, -8));
        glm::dvec3 v(1, aside, random.uniform(-1, 1) * aside);
        v = {1, round(v.y), round(v.z)};
        const auto tester = make_every_hit(scene, format);
        const auto hits = tester->of(v);
        const auto exact = exact_distance(along.surface, WorldRay(scene.camera, v));
        if (hits.empty() || !exact || hits[0].saturated) continue;
        const Real scaled = *exact * Real(std::ldexp(1.0, tester->exponent()));
        ASSERT_LE(Real(hits[0].range.lowest), scaled) << hits[0].t;
        ASSERT_GE(Real(hits[0].range.highest), scaled) << hits[0].t;
        if (format == NumberFormat() || format.name() == "float") {
          EXPECT_LE(abs(scaled - Real(hits[0].t)), scaled * Real(std::ldexp(16.0, -format.significand_bits / 2)));
        }
        ++hits_met;
      }
    }
    EXPECT_GT(hits_met, 200);
  }
}

}  // namespace
}  // namespace pyrasim
