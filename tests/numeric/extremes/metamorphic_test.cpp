// SPDX-License-Identifier: Apache-2.0
// Extremes: what must not change a picture does not change a bit of it, in any format.
#include <array>
#include <tuple>

#include "formats.h"
#include "numeric/vectors.h"

namespace pyrasim {
namespace {

/// A quadric whose points are mapped by `map`, which exchanges axes and turns some around.
template <class Map>
void map_quadric(Quadric& quadric, const Map& map) {
  const Quadric::Coefficients of = quadric.coefficients;
  const std::array<glm::dvec3, 3> axes{map(glm::dvec3(1, 0, 0)), map(glm::dvec3(0, 1, 0)), map(glm::dvec3(0, 0, 1))};
  const std::array<glm::dvec3, 3> rows{{{of.xx, of.xy, of.xz}, {of.xy, of.yy, of.yz}, {of.xz, of.yz, of.zz}}};
  const auto square = [&](int i, int j) {  // of the mapped axes
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t l = 0; l < 3; ++l) sum += axes[k][i] * axes[l][j] * rows[k][static_cast<int>(l)];
    }
    return sum;
  };
  const glm::dvec3 linear = map(glm::dvec3(of.x, of.y, of.z));
  quadric.coefficients = {square(0, 0), square(1, 1), square(2, 2), square(0, 1), square(0, 2),
                          square(1, 2), linear.x,     linear.y,     linear.z,     of.constant};
  for (HalfSpace<double>& plane : quadric.clip) plane.normal = map(plane.normal);
}

/// Applies `map` to every point, normal and direction of the scene but the camera's.
template <class Map>
Scene mapped(Scene scene, const Map& map) {
  if (scene.light) scene.light->direction = map(scene.light->direction);
  for (Object& object : scene.objects) {
    if (auto* sphere = std::get_if<Sphere>(&object.surface)) {
      sphere->center = map(sphere->center);
    } else if (auto* plane = std::get_if<Plane>(&object.surface)) {
      plane->normal = map(plane->normal);
    } else if (auto* triangle = std::get_if<Triangle>(&object.surface)) {
      for (glm::dvec3& vertex : triangle->vertices) vertex = map(vertex);
    } else if (auto* disc = std::get_if<Disc>(&object.surface)) {
      disc->center = map(disc->center);
      disc->normal = map(disc->normal);
    } else if (auto* box = std::get_if<Box>(&object.surface)) {
      const glm::dvec3 a = map(box->min);
      const glm::dvec3 b = map(box->max);
      for (int k = 0; k < 3; ++k) std::tie(box->min[k], box->max[k]) = std::minmax({a[k], b[k]});
    } else if (auto* ellipsoid = std::get_if<Ellipsoid>(&object.surface)) {
      ellipsoid->center = map(ellipsoid->center);
      ellipsoid->radii = magnitudes(map(ellipsoid->radii));
    } else if (auto* cylinder = std::get_if<Cylinder>(&object.surface)) {
      cylinder->axis = {map(cylinder->axis.base), map(cylinder->axis.cap)};
    } else if (auto* cone = std::get_if<Cone>(&object.surface)) {
      cone->axis = {map(cone->axis.base), map(cone->axis.cap)};
    } else if (auto* quadric = std::get_if<Quadric>(&object.surface)) {
      map_quadric(*quadric, map);
    } else if (auto* torus = std::get_if<Torus>(&object.surface)) {
      torus->center = map(torus->center);
      torus->axis = map(torus->axis);
    } else if (auto* instance = std::get_if<MeshInstance>(&object.surface)) {
      QuadrupleMatrix rows{};
      for (int k = 0; k < 3; ++k) {
        glm::dvec3 axis(0);
        axis[k] = 1;
        const glm::dvec3 column = map(axis);
        for (int i = 0; i < 3; ++i) rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] = column[i];
      }
      instance->map = AffineMap(rows, {}).after(instance->map);
    }
  }
  return scene;
}

/// Pixel (row, column) of the result is that of `image` at source(row, column).
template <class Source>
Image rearranged(const Image& image, int columns, int rows, const Source& source) {
  Image result(columns, rows);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const auto [from_row, from_column] = source(row, column);
      result.at(row, column) = image.at(from_row, from_column);
    }
  }
  return result;
}

constexpr int columns = 26;
constexpr int rows = 19;

Scene lit_scene(std::uint64_t seed) { return random_scene(seed, {9, 9, 1, 5, 5, 8, 5, 4}, columns, rows); }

TEST(ExtremesMetamorphic, MirroredScenesMakeMirroredPictures) {
  const Scene scene = lit_scene(41);
  const Scene upside_down = mapped(scene, [](const glm::dvec3& v) { return glm::dvec3(v.x, -v.y, v.z); });
  const Scene left_to_right = mapped(scene, [](const glm::dvec3& v) { return glm::dvec3(v.x, v.y, -v.z); });
  for (const NumberFormat& format : number_formats()) {
    SCOPED_TRACE(format.name());
    const Image image = picture(scene, format);
    EXPECT_TRUE(picture(upside_down, format).pixels() ==
                rearranged(image, columns, rows, [](int r, int c) { return std::pair(rows - 1 - r, c); }).pixels());
    EXPECT_TRUE(picture(left_to_right, format).pixels() ==
                rearranged(image, columns, rows, [](int r, int c) { return std::pair(r, columns - 1 - c); }).pixels());
  }
}

/// Up and right exchanged: the picture is mirrored at the diagonal from its lower left corner.
TEST(ExtremesMetamorphic, ExchangedAxesMakeATransposedPicture) {
  const Scene scene = lit_scene(42);
  Scene exchanged = mapped(scene, [](const glm::dvec3& v) { return glm::dvec3(v.x, v.z, v.y); });
  std::swap(exchanged.camera.screen.columns, exchanged.camera.screen.rows);
  std::swap(exchanged.camera.screen.dy, exchanged.camera.screen.dz);
  for (const NumberFormat& format : number_formats()) {
    SCOPED_TRACE(format.name());
    const Image image = picture(scene, format);
    const auto source = [](int row, int column) { return std::pair(rows - 1 - column, columns - 1 - row); };
    EXPECT_TRUE(picture(exchanged, format).pixels() == rearranged(image, rows, columns, source).pixels());
  }
}

/// Nor do the last bits of a pyramid's color, which a picture's 24 bits seldom show.
TEST(ExtremesMetamorphic, APyramidsColorDoesNotDependOnHowItsCornersAreTurned) {
  Scene scene = empty_scene(1, 1, 1);
  scene.objects = {object(Sphere{{5, 0, 0}, 1}, {max_color, 1, 0.3})};
  const Palette palette(scene, 1);
  TextureWork work;
  Random random(46);
  for (int k = 0; k < 1000; ++k) {
    CornerSamples corners;
    for (Sample& corner : corners) corner = {{0}, random.uniform(0, 1)};
    const auto color = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
      return palette.terminal_color(PyramidCase::covered, {corners[a], corners[b], corners[c], corners[d]},
                                    EdgePolicy::mean, {}, work);
    };
    const FixedColor expected = color(0, 1, 2, 3);
    EXPECT_EQ(color(2, 3, 0, 1), expected);  // upside down
    EXPECT_EQ(color(1, 0, 3, 2), expected);  // left to right
    EXPECT_EQ(color(0, 2, 1, 3), expected);  // transposed
  }
}

/// The world's axes permuted and mirrored, 48 ways, the camera with them. Half of them turn the world, and the picture
/// is the same; the others mirror it.
TEST(ExtremesMetamorphic, TheWorldsAxesDoNotMatter) {
  const Scene scene = lit_scene(43);
  const Image image = picture(scene, {}, 1);
  const Image mirrored = rearranged(image, columns, rows, [](int r, int c) { return std::pair(r, columns - 1 - c); });
  for (const auto& [x, y, z] : {std::tuple(0, 1, 2), {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}) {
    for (int signs = 0; signs < 8; ++signs) {
      const auto map = [&, x = x, y = y, z = z](const glm::dvec3& v) {
        glm::dvec3 result(v[x], v[y], v[z]);
        for (int k = 0; k < 3; ++k) result[k] *= (signs >> k) % 2 == 0 ? 1 : -1;
        return result;
      };
      Scene turned = mapped(scene, map);
      turned.camera.look_at = map(turned.camera.look_at);
      turned.camera.up = map(turned.camera.up);
      const bool mirrors = dot(cross(map({1, 0, 0}), map({0, 1, 0})), map({0, 0, 1})) < 0;
      EXPECT_TRUE(picture(turned, {}, 1).pixels() == (mirrors ? mirrored : image).pixels())
          << x << y << z << " " << signs;
    }
  }
}

/// No two surfaces of a random scene coincide, so that which comes first does not matter.
TEST(ExtremesMetamorphic, TheOrderOfObjectsDoesNotMatter) {
  const Scene flat_and_round = random_scene(44, {9, 9, 1, 5, 5}, columns, rows);
  const Scene with_quadrics = lit_scene(44);
  for (const NumberFormat& format : number_formats()) {
    // Narrow formats do find two surfaces at one distance now and then: the first of them is seen, decision D7.
    if (format.significand_bits < 24 || (format.kind == NumberKind::fixed && format.fraction_bits < 20)) continue;
    // The products that quadrics take are lost earlier.
    const bool narrow = format.kind == NumberKind::fixed && format.fraction_bits < 24;
    const Scene& scene = narrow ? flat_and_round : with_quadrics;
    Scene reversed = scene;
    std::reverse(reversed.objects.begin(), reversed.objects.end());
    EXPECT_TRUE(picture(reversed, format).pixels() == picture(scene, format).pixels()) << format.name();
  }
}

TEST(ExtremesMetamorphic, TheNumberOfThreadsDoesNotMatter) {
  const Scene scene = lit_scene(45);
  for (const NumberFormat& format : number_formats()) {
    const Image image = picture(scene, format, 2, 1);
    for (const int threads : {2, 5}) {
      EXPECT_TRUE(picture(scene, format, 2, threads).pixels() == image.pixels()) << format.name() << " " << threads;
    }
  }
}

}  // namespace
}  // namespace pyrasim
