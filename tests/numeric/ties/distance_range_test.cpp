// SPDX-License-Identifier: Apache-2.0
// The range that is given for a hit holds the exact one, of the scene as it was written, in every number format; and is
// not much wider than that takes.
#include "camera/observer_frame.h"
#include "every_hit.h"
#include "exact_distance.h"
#include "numeric/round_to_format.h"

namespace pyrasim {
namespace {

/// One surface and its observer, and a point of it, in his coordinates, for a ray to be aimed at.
struct Case {
  Scene scene;
  glm::dvec3 target;
};

Scene seen_from(Random& random, double reach) {
  Scene scene = empty_scene(1, 1, 1);
  scene.camera = decimal_camera(random, reach);
  return scene;
}

/// From the observer, anywhere about the way he looks.
glm::dvec3 ahead(Random& random, const Camera& camera, double distance) {
  const glm::dvec3 forward = normalized(camera.look_at - camera.position);
  return decimal(camera.position + (forward + random.vector(-0.4, 0.4)) * distance);
}

double power(Random& random, double low, double high) { return std::exp2(random.uniform(low, high)); }

/// Small, large, and around the observer; met anywhere, and at the rim.
Case sphere(Random& random, double reach) {
  Scene scene = seen_from(random, reach);
  const glm::dvec3 center = ahead(random, scene.camera, power(random, 0, 7));
  const glm::dvec3 from_center = scene.camera.position - center;
  const double away = std::sqrt(dot(from_center, from_center));
  const double radius = std::max(decimal(away * power(random, -6, 0.3)), 0.01);
  scene.objects = {object(Sphere{center, radius})};
  const ObserverFrame frame(scene.camera);
  const glm::dvec3 c = frame.point(center);
  const glm::dvec3 across = normalized(cross(c, random.unit_vector()));
  const double rim = radius < away ? radius * std::sqrt(1 - radius * radius / (away * away)) : radius;
  const double part = random.below(3) == 0 ? 1 - power(random, -50, -4) : random.uniform(0, 1);
  return {scene, c * (radius < away ? 1 - radius * radius / (away * away) : 1) + across * (rim * part)};
}

/// From all sides, and to its horizon.
Case plane(Random& random, double reach) {
  Scene scene = seen_from(random, reach);
  const glm::dvec3 normal = decimal(random.unit_vector() * power(random, -3, 3));
  const glm::dvec3 point = ahead(random, scene.camera, power(random, -2, 6));
  scene.objects = {object(Plane{normal, decimal(dot(normal, point))})};
  const ObserverFrame frame(scene.camera);
  const glm::dvec3 along = normalized(cross(normal, random.unit_vector()));
  return {scene, frame.point(point + along * power(random, -3, random.below(2) == 0 ? 30 : 4))};
}

/// Small and large, also behind the observer in part; seen from the front, and nearly along.
Case triangle(Random& random, double reach) {
  Scene scene = seen_from(random, reach);
  const double distance = power(random, 0, 7);
  const double size = distance * power(random, -6, 1);
  const glm::dvec3 middle = ahead(random, scene.camera, distance);
  Triangle triangle;
  for (glm::dvec3& vertex : triangle.vertices) vertex = decimal(middle + random.vector(-1, 1) * size);
  if (random.below(3) == 0) {
    const glm::dvec3 to_observer = normalized(scene.camera.position - middle);
    triangle.vertices[2] = decimal(triangle.vertices[1] + to_observer * size + random.vector(-1, 1) * (size / 64));
  }
  scene.objects = {object(triangle)};
  const ObserverFrame frame(scene.camera);
  const double part = random.uniform(0, 1);
  const double other = random.uniform(0, 1 - part);
  const auto& [a, b, c] = triangle.vertices;
  return {scene, frame.point(a + (b - a) * part + (c - a) * other)};
}

/// Small and large, seen from the front, nearly along, and at the rim.
Case disc(Random& random, double reach) {
  Scene scene = seen_from(random, reach);
  const double distance = power(random, 0, 7);
  const glm::dvec3 center = ahead(random, scene.camera, distance);
  const double radius = std::max(decimal(distance * power(random, -6, 1)), 0.01);
  glm::dvec3 normal = decimal(random.unit_vector() * power(random, -1, 3));
  if (random.below(3) == 0) {
    const glm::dvec3 view = center - scene.camera.position;
    normal = decimal(cross(view, random.unit_vector()) * power(random, -4, 0)) + decimal(random.vector(-1, 1) * 0.01);
  }
  if (!(dot(normal, normal) > 0)) normal = {1, 0, 0};
  scene.objects = {object(Disc{center, normal, radius})};
  const ObserverFrame frame(scene.camera);
  const glm::dvec3 along = normalized(cross(normal, random.unit_vector()));
  const double part = random.below(3) == 0 ? 1 - power(random, -50, -4) : random.uniform(0, 1);
  return {scene, frame.point(center + along * (radius * part))};
}

/// Small and large, flat and long, and around the observer; met anywhere, and at edges.
Case box(Random& random, double reach) {
  Scene scene = seen_from(random, reach);
  const double distance = power(random, 0, 7);
  const glm::dvec3 middle = ahead(random, scene.camera, distance);
  glm::dvec3 half;
  for (int axis = 0; axis < 3; ++axis) half[axis] = std::max(decimal(distance * power(random, -6, 0.6)), 0.002);
  const Box box{decimal(middle - half), decimal(middle + half)};
  scene.objects = {object(box)};
  glm::dvec3 target = middle + random.vector(-1, 1) * half;
  if (random.below(3) == 0) target[0] = middle[0] + half[0] * (1 - power(random, -50, -4));
  return {scene, ObserverFrame(scene.camera).point(target)};
}

/// A sphere's case, its axes stretched by up to 16.
Case ellipsoid(Random& random, double reach) {
  auto [scene, target] = sphere(random, reach);
  const Sphere ball = std::get<Sphere>(scene.objects[0].surface);
  glm::dvec3 radii;
  for (int axis = 0; axis < 3; ++axis) radii[axis] = std::max(decimal(ball.radius * power(random, -3, 1)), 0.01);
  scene.objects = {object(Ellipsoid{ball.center, radii})};
  const ObserverFrame frame(scene.camera);
  const glm::dvec3 to_observer = scene.camera.position - ball.center;
  // About the middle of what is seen, or anywhere on the surface, or nearly where rays touch it.
  const glm::dvec3 unit = random.unit_vector();
  const double part = random.below(3) == 0 ? 1 - power(random, -50, -4) : 1;
  const glm::dvec3 across = normalized(cross(to_observer, unit) / radii);
  target = frame.point(ball.center + (random.below(2) == 0 ? across : unit) * radii * part);
  return {scene, target};
}

/// Small and large, flat and long, closed and open, and around the observer; met anywhere, at an end's rim, and where
/// rays touch it.
std::pair<Case, Cone> round(Random& random, double reach, bool tapered) {
  Scene scene = seen_from(random, reach);
  const double distance = power(random, 0, 7);
  const glm::dvec3 base = ahead(random, scene.camera, distance);
  const glm::dvec3 along = random.unit_vector() * (distance * power(random, -5, 0.3));
  glm::dvec3 cap = decimal(base + along);
  if (cap == base) cap.y += 0.5;
  Cone cone{{base, cap}, std::max(decimal(distance * power(random, -6, 0.3)), 0.01), 0, random.below(2) == 0};
  cone.cap_radius = tapered ? decimal(cone.base_radius * random.uniform(0, 2)) : cone.base_radius;
  if (tapered && random.below(4) == 0) cone.cap_radius = 0;
  const ObserverFrame frame(scene.camera);
  const double height = random.below(4) == 0 ? power(random, -50, -4) : random.uniform(0, 1);
  const glm::dvec3 axis = cap - base;
  const glm::dvec3 place = base + axis * height;
  glm::dvec3 across = cross(axis, random.unit_vector());
  if (random.below(2) == 0) across = cross(axis, place - scene.camera.position);
  const double part = random.below(3) == 0 ? 1 - power(random, -50, -4) : random.uniform(0, 1);
  const double radius = cone.base_radius + (cone.cap_radius - cone.base_radius) * height;
  return {{scene, frame.point(place + normalized(across) * (radius * part))}, cone};
}

Case cylinder(Random& random, double reach) {
  auto [made, cone] = round(random, reach, false);
  made.scene.objects = {object(Cylinder{cone.axis, cone.base_radius, cone.capped})};
  return made;
}

Case cone(Random& random, double reach) {
  auto [made, cone] = round(random, reach, true);
  made.scene.objects = {object(cone)};
  return made;
}

/// The quadrics that there are, about a point, turned askew where `askew` is not 0.
Quadric::Coefficients coefficients(const glm::dvec3& signs, double linear, double constant, double askew,
                                   const glm::dvec3& center) {
  Quadric::Coefficients q{signs.x, signs.y, signs.z, askew, 0, 0, 0, 0, linear, constant};
  // q(p - center)
  q.x = -2 * q.xx * center.x - q.xy * center.y;
  q.y = -2 * q.yy * center.y - q.xy * center.x;
  q.z -= 2 * q.zz * center.z;
  q.constant += q.xx * center.x * center.x + q.yy * center.y * center.y + q.zz * center.z * center.z +
                q.xy * center.x * center.y - linear * center.z;
  return {decimal(q.xx), decimal(q.yy), decimal(q.zz), decimal(q.xy),      0, 0,
          decimal(q.x),  decimal(q.y),  decimal(q.z),  decimal(q.constant)};
}

/// Of every kind, clipped by a box and by planes at odd angles, open and closed; aimed anywhere within the clip.
Case quadric(Random& random, double reach) {
  Scene scene = seen_from(random, std::min(reach, 64.0));
  const double distance = power(random, 1, 5);
  const glm::dvec3 center = ahead(random, scene.camera, distance);
  const double size = std::max(decimal(distance * power(random, -3, 0)), 0.25);
  const std::array<glm::dvec3, 6> signs{{{1, 1, 1}, {1, 2, -1}, {1, 1, 0}, {1, -1, 0}, {-1, 1, 0.5}, {1, 0, 0}}};
  const std::size_t which = random.below(signs.size());
  const double constant = random.below(4) == 0 ? 0.0 : size * size / 4 * (random.below(2) == 0 ? 1 : -1);
  const double linear = signs[which].z == 0 ? size : 0;
  Quadric quadric{coefficients(signs[which], linear, constant, random.below(2) == 0 ? 0.5 : 0, center)};
  quadric.capped = random.below(2) == 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double outward : {-1.0, 1.0}) {
      glm::dvec3 normal(0);
      normal[axis] = outward;
      quadric.clip.push_back({normal, decimal(dot(normal, center) + size)});
    }
  }
  const glm::dvec3 normal = decimal(random.unit_vector());
  quadric.clip.push_back({normal, decimal(dot(normal, center) + size / 3)});
  scene.objects = {object(quadric)};
  const ObserverFrame frame(scene.camera);
  return {scene, frame.point(center + random.vector(-1, 1) * size)};
}

/// Thick and thin, small and large, and around the observer; met anywhere, and where rays touch the tube.
Case torus(Random& random, double reach) {
  Scene scene = seen_from(random, reach);
  const double distance = power(random, 0, 7);
  const glm::dvec3 center = ahead(random, scene.camera, distance);
  const glm::dvec3 axis = decimal(random.unit_vector() * power(random, 0, 3));
  const double major = std::max(decimal(distance * power(random, -6, 0.3)), 0.02);
  const double minor = std::max(decimal(major * power(random, -4, 0)), 0.01);
  scene.objects = {object(Torus{center, axis, major, minor})};
  const ObserverFrame frame(scene.camera);
  // Across the axis to the middle of the tube, and from there anywhere within it, or across the way to there.
  const glm::dvec3 middle = center + normalized(cross(axis, random.unit_vector())) * major;
  const double part = random.below(3) == 0 ? 1 - power(random, -50, -4) : random.uniform(0, 1);
  glm::dvec3 aside = random.unit_vector();
  if (random.below(2) == 0) aside = normalized(cross(middle - scene.camera.position, aside));
  return {scene, frame.point(middle + aside * (minor * part))};
}

/// A triangle's case, the triangle alone in a mesh of its own, stretched by up to 8 times as much one way as another,
/// and turned.
Case instance(Random& random, double reach) {
  Scene scene = seen_from(random, reach);
  Mesh mesh;
  const glm::dvec3 beside = decimal(random.vector(-1, 1) * power(random, -3, 6));
  for (int k = 0; k < 3; ++k) mesh.vertices.push_back(decimal(beside + random.vector(-1, 1)));
  mesh.triangles = {{0, 1, 2}};
  const auto of = std::make_shared<const InstancedMesh>(mesh);
  const double distance = power(random, 0, 7);
  const double size = distance * power(random, -4, 1);
  const auto factor = [&] { return size * power(random, -3, 0) * (random.below(2) == 0 ? 1 : -1); };
  const AffineMap stretched = AffineMap::scaling({factor(), factor(), factor()}).after(AffineMap::translation(-beside));
  const AffineMap turned = AffineMap::rotation(random.unit_vector(), random.uniform(0, 360)).after(stretched);
  const MeshInstance instance{of, AffineMap::translation(ahead(random, scene.camera, distance)).after(turned)};
  scene.objects = {object(instance)};
  const double part = random.uniform(0, 1);
  const double other = random.uniform(0, 1 - part);
  const auto& v = mesh.vertices;
  const glm::dvec3 target = v[0] + (v[1] - v[0]) * part + (v[2] - v[0]) * other;
  return {scene, ObserverFrame(scene.camera).point(rounded(instance.map.point(exactly(target))))};
}

struct Tightness {
  int hits = 0;
  int coarsely_known = 0;
  double worst = 0;  ///< error, as a part of what the range grants
};

void expect_in_range(const KnownHit& hit, const Real& exact, Tightness& tightness) {
  const Real error = exact - Real(hit.t);
  ASSERT_LE(hit.range.lowest, hit.range.highest);
  ASSERT_LE(Real(hit.range.lowest), exact)
      << hit.t << " errs by " << static_cast<double>(error) << ", granted " << hit.t - hit.range.lowest;
  ASSERT_GE(Real(hit.range.highest), exact)
      << hit.t << " errs by " << static_cast<double>(error) << ", granted " << hit.range.highest - hit.t;
  if (hit.relative_error < 1) {
    ASSERT_GE(hit.range.lowest, hit.t * (1 - hit.relative_error));
    ASSERT_LE(hit.range.highest, hit.t * (1 + hit.relative_error));
    ++tightness.coarsely_known;
  }
  const double granted = error > Real(0) ? hit.range.highest - hit.t : hit.t - hit.range.lowest;
  if (granted > 0) tightness.worst = std::max(tightness.worst, static_cast<double>(abs(error)) / granted);
  ++tightness.hits;
}

template <class Make>
void expect_ranges(const char* what, const Make& make, bool known_coarsely = true) {
  for (const NumberFormat& format : number_formats()) {
    SCOPED_TRACE(format.name());
    const RoundToFormat round(format);
    Random random(77);
    Tightness tightness;
    for (int k = 0; k < 1500; ++k) {
      const double reach = k % 3 == 0 ? 0 : k % 3 == 1 ? 4 : 4000;
      const auto [scene, target] = make(random, reach);
      if (!(target.x > 0.05 * std::sqrt(dot(target, target)))) continue;
      glm::dvec3 v(1, target.y / target.x, target.z / target.x);
      v = {1, round(v.y), round(v.z)};
      const auto tester = make_every_hit(scene, format);
      const auto hits = tester->of(v);
      const auto exact = exact_distance(scene.objects[0].surface, WorldRay(scene.camera, v));
      if (hits.empty() || hits[0].saturated || !exact) continue;
      expect_in_range(hits[0], *exact * Real(std::ldexp(1.0, tester->exponent())), tightness);
      if (testing::Test::HasFatalFailure()) FAIL() << what << " " << k;
    }
    print_figure(
        fmt::format("{}: largest error, of the range", what), format,
        fmt::format("{:.3f} of {} hits, {} known coarsely", tightness.worst, tightness.hits, tightness.coarsely_known));
    EXPECT_GT(tightness.hits, 300);
    EXPECT_GT(tightness.worst, 1.0 / 16) << "the range is needlessly wide";
    if (format == NumberFormat() && known_coarsely) {
      EXPECT_GT(tightness.coarsely_known, tightness.hits * 8 / 10);
    }
  }
}

TEST(DistanceRange, HoldsTheExactHitOfASphere) { expect_ranges("sphere", sphere); }
TEST(DistanceRange, HoldsTheExactHitOfAPlane) { expect_ranges("plane", plane); }
TEST(DistanceRange, HoldsTheExactHitOfATriangle) { expect_ranges("triangle", triangle); }
TEST(DistanceRange, HoldsTheExactHitOfADisc) { expect_ranges("disc", disc); }
TEST(DistanceRange, HoldsTheExactHitOfABox) { expect_ranges("box", box); }
TEST(DistanceRange, HoldsTheExactHitOfAnEllipsoid) { expect_ranges("ellipsoid", ellipsoid); }
TEST(DistanceRange, HoldsTheExactHitOfACylinder) { expect_ranges("cylinder", cylinder, false); }
TEST(DistanceRange, HoldsTheExactHitOfACone) { expect_ranges("cone", cone, false); }
TEST(DistanceRange, HoldsTheExactHitOfAQuadric) { expect_ranges("quadric", quadric, false); }
TEST(DistanceRange, HoldsTheExactHitOfATorus) { expect_ranges("torus", torus, false); }
TEST(DistanceRange, HoldsTheExactHitOfAnInstance) { expect_ranges("instance", instance, false); }

}  // namespace
}  // namespace pyrasim
