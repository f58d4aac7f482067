// SPDX-License-Identifier: Apache-2.0
#include "texture/textured_object.h"

#include <gtest/gtest.h>

#include "../numeric/extremes/formats.h"
#include "surface/transformed.h"

namespace pyrasim {
namespace {

constexpr glm::dvec3 white(1), black(0);

glm::dvec3 color_at(const TexturedObject& object, const glm::dvec3& ray) {
  TextureWork work;
  return object.color_at(ray, work);
}
glm::dvec3 color_over(const TexturedObject& object, const std::array<glm::dvec3, 4>& corners, TextureFilter filter) {
  TextureWork work;
  return object.color_over(corners, filter, work);
}

Texture checker(double scale) { return {.colors = {white, black}, .scale = {scale, scale}}; }

Scene textured(const SceneSurface& written, const Texture& texture, const AffineMap& map = {}) {
  Scene scene = empty_scene(64, 48, 1.0 / 64);
  scene.objects = {object(transformed(written, map))};
  scene.objects[0].texture =
      std::make_shared<const ObjectTexture>(ObjectTexture{texture, std::make_shared<const SceneSurface>(written), map});
  return scene;
}

/// Squares of 1 on the level floor, whose u runs along x and v along z.
TEST(TexturedObject, APlaneIsLaidOutInItsOwnLengths) {
  const Scene scene = textured(Plane{{0, 1, 0}, -2}, checker(1));
  const TexturedObject floor(scene, 0);
  EXPECT_EQ(color_at(floor, {1, -2 / 4.5, 0.5 / 4.5}), white) << "u 4.5, v 0.5";
  EXPECT_EQ(color_at(floor, {1, -2 / 5.5, 0.5 / 5.5}), black) << "u 5.5, v 0.5";
  EXPECT_EQ(color_at(floor, {1, -2 / 5.5, 1.5 / 5.5}), white) << "u 5.5, v 1.5";
  EXPECT_EQ(color_at(floor, {1, -2 / 4.5, -0.5 / 4.5}), black) << "u 4.5, v -0.5";
}

TEST(TexturedObject, ScaleShiftAndTurn) {
  Texture stripes{.pattern = Pattern::stripes, .colors = {white, black}, .scale = {2, 1}, .shift = {1, 0}};
  EXPECT_EQ(stripes.at(stripes.cell(1.1, 0)), white);
  EXPECT_EQ(stripes.at(stripes.cell(2.9, 0)), white);
  EXPECT_EQ(stripes.at(stripes.cell(3.1, 0)), black);
  EXPECT_EQ(stripes.at(stripes.cell(0.9, 0)), black);
  stripes.turn = 90;  // u of the stripes now runs along v of the surface
  EXPECT_EQ(stripes.at(stripes.cell(50, 1.9)), white);
  EXPECT_EQ(stripes.at(stripes.cell(50, 2.1)), black);
}

/// The pyramid's four rays meet a plane in a quadrilateral, and it covers that.
TEST(TexturedObject, OnAPlaneTheMeanIsThatOfSamplesSpreadOverTheFootprint) {
  const Scene scene = textured(Plane{{0.2, 1, -0.1}, -2}, checker(0.7));
  const TexturedObject floor(scene, 0);
  const std::array<glm::dvec3, 4> corners{glm::dvec3{1, -0.3, 0.1}, {1, -0.3, 0.16}, {1, -0.4, 0.1}, {1, -0.4, 0.16}};
  std::array<glm::dvec3, 4> places{};
  for (std::size_t k = 0; k < 4; ++k) places[k] = corners[k] * (-2 / dot(glm::dvec3(0.2, 1, -0.1), corners[k]));
  // Of two triangles, each as often as it is large.
  constexpr int steps = 700;
  double sum = 0, all = 0;
  for (const auto& [a, b, c] : {std::array{0, 1, 3}, std::array{0, 3, 2}}) {
    const auto place = [&](int k) { return places[static_cast<std::size_t>(k)]; };
    const glm::dvec3 one = place(b) - place(a), other = place(c) - place(a);
    const glm::dvec3 normal = cross(one, other);
    const double area = std::sqrt(dot(normal, normal));
    double here = 0;
    int count = 0;
    for (int i = 0; i < steps; ++i) {
      for (int j = 0; i + j < steps; ++j, ++count) {
        const glm::dvec3 p = place(a) + one * ((i + 1.0 / 3) / steps) + other * ((j + 1.0 / 3) / steps);
        here += color_at(floor, p / p.x).x;
      }
    }
    sum += area * here / count;
    all += area;
  }
  EXPECT_NEAR(color_over(floor, corners, TextureFilter::integral).x, sum / all, 1e-3);
  EXPECT_GT(sum / all, 0.1);
  EXPECT_LT(sum / all, 0.9);
}

TEST(TexturedObject, TransformsMoveTheTextureToo) {
  const AffineMap map = AffineMap::translation({7, 0.3, -0.4})
                            .after(AffineMap::rotation({1, 2, 0.5}, 35).after(AffineMap::scaling({1.5, 0.7, -2})));
  const SceneSurface ball = Sphere{{0.1, 0.2, 0}, 1};
  const Texture texture{.colors = {white, black}, .scale = {0.125, 0.25}};
  const TexturedObject object(textured(ball, texture, map), 0);
  Random random(3);
  int seen = 0;
  for (int k = 0; k < 500; ++k) {
    const glm::dvec3 written = glm::dvec3(0.1, 0.2, 0) + random.unit_vector();
    const glm::dvec3 there = rounded(map.point(exactly(written)));
    const glm::dvec3 ray = there / there.x;
    const auto at = std::get<Sphere>(ball).coordinates_at(written);
    const TexturePoint cell = texture.cell(at.u, at.v);
    const double from_line = std::min(std::abs(cell.u - std::round(cell.u)), std::abs(cell.v - std::round(cell.v)));
    if (from_line < 1e-6) continue;
    // On the far side another place is seen.
    const glm::dvec3 center = rounded(map.point(exactly({0.1, 0.2, 0})));
    const glm::dvec3 normal = rounded(map.normal(exactly(written - glm::dvec3(0.1, 0.2, 0))));
    if (dot(normal, there) >= 0 || center.x < 1) continue;
    EXPECT_EQ(color_at(object, ray), texture.at(cell)) << k;
    ++seen;
  }
  EXPECT_GT(seen, 150);
}

/// Across the seam of longitude u goes on.
TEST(TexturedObject, ASeamIsNoEndOfTheTexture) {
  const Texture texture{.pattern = Pattern::stripes, .colors = {white, black}, .scale = {0.125, 1}};
  const AffineMap about = AffineMap::translation({5, 0, 0});  // u = 1/2 and -1/2 towards the observer
  const TexturedObject ball(textured(Sphere{{0, 0, 0}, 1}, texture, about), 0);
  const double half = 0.01;
  const std::array<glm::dvec3, 4> corners{
      glm::dvec3{1, half, -half}, {1, half, half}, {1, -half, -half}, {1, -half, half}};
  EXPECT_NEAR(color_over(ball, corners, TextureFilter::integral).x, 0.5, 0.01)
      << "an odd and an even stripe meet there";
  EXPECT_NEAR(color_over(ball, corners, TextureFilter::point).x, 0.5, 1e-12);
}

/// Corners on two faces of a box have no quadrilateral in common.
TEST(TexturedObject, AcrossABoxsEdgeTheCornersCount) {
  const TexturedObject box(textured(Box{{4, -1, -1}, {6, 1, 1}}, checker(0.5)), 0);
  const std::array<glm::dvec3, 4> corners{glm::dvec3{1, 0.21, 0.01}, {1, 0.21, 0.02}, {1, 0.3, 0.01}, {1, 0.3, 0.02}};
  EXPECT_EQ(color_over(box, corners, TextureFilter::integral), color_over(box, corners, TextureFilter::point));
}

/// A parallelogram of a plane as two triangles, with the plane's own coordinates; of one of them `off` in u.
Mesh parallelogram(const Plane& plane, double off) {
  const glm::dvec3 a = plane.normal * (plane.offset / dot(plane.normal, plane.normal));
  const glm::dvec3 one = glm::cross(plane.normal, glm::dvec3(0.3, 0.1, 1)) * 400.0;
  const glm::dvec3 other = glm::cross(plane.normal, one) * 0.7;
  Mesh mesh;
  mesh.vertices = {a - one - other, a + one - other, a + one + other, a - one + other};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  for (const auto& [moved, triangle] : {std::pair(0.0, mesh.triangles[0]), {off, mesh.triangles[1]}}) {
    TriangleCorners& corners = mesh.places.corners.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const SurfaceCoordinates at = plane.coordinates_at(mesh.vertices[triangle[k]]);
      corners[k] = static_cast<std::uint32_t>(mesh.places.values.size());
      mesh.places.values.emplace_back(at.u + moved, at.v);
    }
  }
  return mesh;
}

/// Seams included: where both triangles continue the texture, the mean is that of the plane.
TEST(TexturedObject, AMeshInAPlaneHasThePlanesMeans) {
  const Plane plane{{0.2, 1, -0.1}, -2};
  const Texture texture = checker(0.7);
  const TexturedObject expected(textured(plane, texture), 0);
  const AffineMap map = AffineMap::translation({0.5, -0.25, 1}).after(AffineMap::scaling({2, 0.5, -3}));
  const auto shared = std::make_shared<const InstancedMesh>(parallelogram(plane, 1.4));
  const TexturedObject mesh(textured(parallelogram(plane, 1.4), texture), 0);
  const TexturedObject instance(textured(MeshInstance{shared, {}}, texture), 0);
  const TexturedObject moved_plane(textured(plane, texture, map), 0);
  const TexturedObject moved_instance(textured(MeshInstance{shared, {}}, texture, map), 0);
  Random random(5);
  for (int k = 0; k < 300; ++k) {
    const glm::dvec3 upper_left(1, random.uniform(-0.6, -0.3), random.uniform(-0.5, 0.4));
    const double size = std::exp2(random.uniform(-8, -3));
    std::array<glm::dvec3, 4> corners;
    for (std::size_t c = 0; c < 4; ++c)
      corners[c] = upper_left + glm::dvec3(0, c < 2 ? 0 : -size, c % 2 == 0 ? 0 : size);
    const auto near = [&](const TexturedObject& one, const TexturedObject& other) {
      EXPECT_NEAR(color_over(one, corners, TextureFilter::integral).x,
                  color_over(other, corners, TextureFilter::integral).x, 1e-9)
          << k;
      EXPECT_EQ(color_at(one, corners[0]), color_at(other, corners[0])) << k;
    };
    near(mesh, expected);
    near(instance, expected);
    near(moved_instance, moved_plane);
  }
}

/// Each triangle that a corner sees is asked for one footprint, each of four places.
TEST(TexturedObject, AMeshTakesAFootprintForEachTriangleSeen) {
  const TexturedObject mesh(textured(parallelogram({{-1, 0, 0}, -6}, 0), checker(1)), 0);
  const auto places = [&](double y, double z, double size) {
    TextureWork work;
    mesh.color_over(
        {glm::dvec3{1, y + size, z - size}, {1, y + size, z + size}, {1, y - size, z - size}, {1, y - size, z + size}},
        TextureFilter::integral, work);
    return work.places;
  };
  EXPECT_EQ(places(0, 0, 0.01), 8U) << "both, about the diagonal's middle";
  std::uint64_t ones = 0;
  for (double turn = 0; turn < 6; turn += 0.5)
    ones += places(0.2 * std::sin(turn), 0.2 * std::cos(turn), 1e-4) == 4 ? 1 : 0;
  EXPECT_GE(ones, 10U);
}

/// Along a silhouette the planes of the triangles run beside the pyramid: what the corners see counts.
TEST(TexturedObject, AMeshWithoutFootprintsHasWhatItsCornersSee) {
  Mesh ridge;  // seen along its edge: both faces nearly from the side
  ridge.vertices = {{4, 0, 0}, {4, 0, 1}, {400, -0.5, 0}, {400, -0.5, 1}};
  ridge.triangles = {{0, 1, 2}, {1, 3, 2}};
  ridge.places = {{{0, 0}, {0, 9}, {900, 0}, {900, 9}}, ridge.triangles};
  const TexturedObject object(textured(ridge, checker(1)), 0);
  const std::array<glm::dvec3, 4> corners{
      glm::dvec3{1, 0.1, 0.001}, {1, 0.1, 0.002}, {1, -0.00126, 0.001}, {1, -0.00126, 0.002}};
  const glm::dvec3 seen = color_over(object, corners, TextureFilter::integral);
  EXPECT_EQ(seen, color_over(object, corners, TextureFilter::point));
}

TEST(SurfaceCoordinatesOf, EachSurface) {
  const auto expect = [](const SurfaceCoordinates& at, double u, double v, int chart = 0) {
    EXPECT_NEAR(at.u, u, 1e-12);
    EXPECT_NEAR(at.v, v, 1e-12);
    EXPECT_EQ(at.chart, chart);
  };
  expect(Sphere{{1, 1, 1}, 2}.coordinates_at({3, 1, 1}), 0, 0);
  expect(Sphere{{1, 1, 1}, 2}.coordinates_at({1, 1, 3}), 0.25, 0);
  expect(Sphere{{1, 1, 1}, 2}.coordinates_at({1, 3, 1}), 0, 0.5);
  expect(Ellipsoid{{0, 0, 0}, {1, 2, 3}}.coordinates_at({0, 0, -3}), -0.25, 0);
  expect(Disc{{1, 0, 0}, {0, 2, 0}, 3}.coordinates_at({2, 0, 1.5}), 1, 1.5);
  expect(Plane{{-1, 0, 0}, -4}.coordinates_at({4, 2, 3}), 3, 2);  // a wall before the observer: right is z
  expect(Triangle{{{{1, 0, 0}, {1, 0, 1}, {1, 1, 0}}}}.coordinates_at({1, 0.5, 0.25}), 0.25, 0.5);
  expect(Box{{0, 0, 0}, {1, 2, 3}}.coordinates_at({1, 0.5, 2}), 2, 0.5, 1);
  expect(Box{{0, 0, 0}, {1, 2, 3}}.coordinates_at({0.25, 0, 2}), 0.25, 2, 2);
  expect(Box{{0, 0, 0}, {1, 2, 3}}.coordinates_at({0.25, 0.5, 3}), 0.25, 0.5, 5);
  const Cylinder post{{{0, 0, 0}, {0, 2, 0}}, 1};
  expect(post.coordinates_at({1, 1.5, 0}), 0, 1.5);
  expect(post.coordinates_at({0, 0.5, -1}), 0.25, 0.5);  // right-handed about y
  expect(post.coordinates_at({0.25, 2, 0.5}), 0.25, 0.5, 2);
  expect(Cone{{{0, 0, 0}, {0, 2, 0}}, 2, 0}.coordinates_at({1, 1, 0}), 0, 1);
  expect(Cone{{{0, 0, 0}, {0, 2, 0}}, 2, 0}.coordinates_at({1, 0, 0.5}), 1, 0.5, 1);
  expect(Quadric{{.xx = 1, .zz = 1, .y = -1}}.coordinates_at({1, 1, 0}), 0, 1);
  const Torus ring{{0, 0, 0}, {0, 1, 0}, 2, 0.5};
  expect(ring.coordinates_at({2.5, 0, 0}), 0, 0);
  expect(ring.coordinates_at({0, 0.5, -2}), 0.25, 0.25);
}

}  // namespace
}  // namespace pyrasim
