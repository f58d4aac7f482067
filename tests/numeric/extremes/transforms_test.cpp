// SPDX-License-Identifier: Apache-2.0
// Extremes: what transforms make of scenes, against the same scenes made otherwise.
#include "formats.h"
#include "numeric/vectors.h"
#include "surface/transformed.h"

namespace pyrasim {
namespace {

constexpr int columns = 64;
constexpr int rows = 48;

/// All of a scene, its camera and its light too.
Scene moved(Scene scene, const AffineMap& map) {
  for (Object& object : scene.objects) object.surface = transformed(object.surface, map);
  const auto direction = [&](const glm::dvec3& v) { return rounded(map.direction(exactly(v))); };
  scene.camera.position = rounded(map.point(exactly(scene.camera.position)));
  scene.camera.look_at = rounded(map.point(exactly(scene.camera.look_at)));
  scene.camera.up = direction(scene.camera.up);
  if (scene.light) scene.light->direction = direction(scene.light->direction);
  return scene;
}

/// How many pixels differ by more than rounding; `mirrored`: from those on the other side.
int other_pixels(const Image& a, const Image& b, bool mirrored) {
  int others = 0;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const auto p = a.at(row, column);
      const auto q = b.at(row, mirrored ? columns - 1 - column : column);
      if (std::max({std::abs(p.x - q.x), std::abs(p.y - q.y), std::abs(p.z - q.z)}) > 1e-5) ++others;
    }
  }
  return others;
}

TEST(ExtremesTransforms, AMovedSceneSeenByAMovedObserverIsTheSame) {
  const AffineMap turn = AffineMap::translation({30, -20, 7}).after(AffineMap::rotation({1, -2, 0.5}, 77));
  const AffineMap mirror = turn.after(AffineMap::scaling({1, -1, 1}));
  int others = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const Scene scene = random_scene(seed, {6, 6, 1, 5, 6, 12}, columns, rows);
    const Image image = picture(scene, NumberFormat());
    others += other_pixels(image, picture(moved(scene, turn), NumberFormat()), false);
    others += other_pixels(image, picture(moved(scene, mirror), NumberFormat()), true);
  }
  print_figure("scenes moved with their observer: other pixels", NumberFormat(),
               fmt::format("{} of {}", others, 16 * rows * columns));
  EXPECT_LE(others, 16);
}

TEST(ExtremesTransforms, AScaledSphereIsTheEllipsoidBitForBit) {
  const AffineMap map = AffineMap::translation({6, 0.5, -0.25}).after(AffineMap::scaling({0.5, 2, 1.25}));
  Scene scaled = empty_scene(columns, rows, 1.2 / columns);
  scaled.light = SingleLight{0.25, {0.6, -1, 0.4}};
  Scene written = scaled;
  scaled.objects = {object(transformed(Sphere{{0, 0, 0}, 1.5}, map))};
  written.objects = {object(Ellipsoid{{6, 0.5, -0.25}, {0.75, 3, 1.875}})};
  for (const NumberFormat& format : number_formats()) {
    EXPECT_TRUE(picture(scaled, format).pixels() == picture(written, format).pixels()) << format.name();
  }
}

/// The twelve triangles of a box from -1 to 1.
Mesh faces_of_box() {
  Mesh mesh;
  for (int k = 0; k < 8; ++k) mesh.vertices.emplace_back(k % 2 * 2 - 1, k / 2 % 2 * 2 - 1, k / 4 * 2 - 1);
  for (const auto& [a, b, c, d] : {std::array{0U, 1U, 3U, 2U},
                                   {4U, 5U, 7U, 6U},
                                   {0U, 1U, 5U, 4U},
                                   {2U, 3U, 7U, 6U},
                                   {0U, 2U, 6U, 4U},
                                   {1U, 3U, 7U, 5U}}) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  }
  return mesh;
}

TEST(ExtremesTransforms, AShearedBoxIsItsFaces) {
  std::mt19937_64 random(3);
  Scene scene = empty_scene(columns, rows, 1.2 / columns);
  scene.light = SingleLight{0.25, {0.6, -1, 0.4}};
  const Image nothing = picture(scene, NumberFormat());
  int others = 0;
  int seen = 0;
  for (int k = 0; k < 16; ++k) {
    QuadrupleMatrix matrix{};
    for (QuadrupleVector& row : matrix) row = exactly(random_vector(random, glm::dvec3(-1), glm::dvec3(1)));
    const AffineMap map(matrix, {5, 0, 0});
    scene.objects = {object(transformed(Box{{-1, -1, -1}, {1, 1, 1}}, map))};
    const Image solid = picture(scene, NumberFormat());
    scene.objects = {object(transformed(faces_of_box(), map))};
    others += other_pixels(solid, picture(scene, NumberFormat()), false);
    seen += other_pixels(solid, nothing, false);
  }
  print_figure("sheared boxes and their faces: other pixels", NumberFormat(), fmt::format("{} of {}", others, seen));
  EXPECT_GT(seen, 4000);
  EXPECT_LE(others, 16);
}

}  // namespace
}  // namespace pyrasim
