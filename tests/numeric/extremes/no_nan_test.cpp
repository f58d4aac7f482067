// SPDX-License-Identifier: Apache-2.0
// Extremes: no pixel of any picture in any format is NaN or infinite. What must not be in a scene at all is refused
// when it is read: scene/load_scene_error_test.cpp and end_to_end/bad_input.py.
#include "../../shipped_scene.h"
#include "formats.h"

namespace pyrasim {
namespace {

int pixels_without_a_color(const Image& image) {
  int count = 0;
  for (const glm::vec3& pixel : image.pixels()) {
    for (int k = 0; k < 3; ++k) count += pixel[k] >= 0 && pixel[k] <= static_cast<float>(max_color) ? 0 : 1;
  }
  return count;
}

class ExtremesNoNan : public testing::TestWithParam<const char*> {};

TEST_P(ExtremesNoNan, PixelsOfShippedScenes) {
  Scene scene = shipped_scene(GetParam());
  scene.camera.screen = resized(scene.camera.screen, 24, 18);
  const bool large = std::string(GetParam()) == "bunny";
  for (const NumberFormat& format : number_formats()) {
    // The large mesh takes a while to prepare: double, and the formats with the fewest bits.
    if (large && format != NumberFormat() && format != fp16 && format != NumberFormat::fixed(24, 12)) {
      continue;
    }
    EXPECT_EQ(pixels_without_a_color(picture(scene, format)), 0) << format.name();
  }
}
INSTANTIATE_TEST_SUITE_P(Scenes, ExtremesNoNan, testing::Values("spheres", "fins", "keel", "bunny"),
                         [](const auto& test) { return std::string(test.param); });

/// Everything that makes narrow formats overflow, underflow or divide by 0 at once: surfaces through the observer,
/// huge beside tiny ones, a screen of nearly 180 degrees.
TEST(ExtremesNoNanPixels, OfSurfacesThroughTheObserver) {
  for (const double half_width : {1e-6, 1.0, 100.0, 1e6}) {
    Scene scene = empty_scene(16, 16, half_width / 8);
    scene.light = SingleLight{0.25, {0.6, -1, 0.4}};
    for (const double size : {1e-30, 1e-6, 1.0, 1e6, 1e30}) {
      scene.objects.push_back(object(Sphere{{size, 0, 0}, size}));
      scene.objects.push_back(object(Sphere{{3 * size, 0, size}, size}));
      scene.objects.push_back(object(Sphere{{0, 0, 0}, size}));
      scene.objects.push_back(object(Triangle{{{{0, 0, 0}, {size, size, 0}, {size, 0, size}}}}));
      scene.objects.push_back(object(Plane{{size, size, 0}, size}));
      scene.objects.push_back(object(Plane{{0, size, 0}, 0}));
    }
    for (const NumberFormat& format : number_formats()) {
      EXPECT_EQ(pixels_without_a_color(picture(scene, format, 1)), 0) << format.name() << " " << half_width;
      Scene one = scene;
      for (const Object& alone : scene.objects) {
        one.objects = {alone};
        EXPECT_EQ(pixels_without_a_color(picture(one, format, 0)), 0) << format.name() << " " << half_width;
      }
    }
  }
}

/// Subnormal coordinates are read as they are: a triangle of 1e-310 is a small triangle, with a normal.
TEST(ExtremesNoNanPixels, OfSubnormalTriangles) {
  Scene scene = empty_scene(16, 16, 0.1);
  scene.light = SingleLight{0.25, {0.6, -1, 0.4}};
  for (const double size : {1e-305, 1e-310, 4e-322}) {
    scene.objects = {object(Triangle{{{{size, -size, -size}, {size, size, -size}, {size, 0, size}}}})};
    const Image expected = picture(scene, {}, 0);
    EXPECT_EQ(pixels_without_a_color(expected), 0) << size;
    EXPECT_EQ(expected.at(8, 8), glm::vec3(1, 1, 1) * expected.at(8, 8).x) << size;
    EXPECT_NE(expected.at(8, 8), glm::vec3(scene.background)) << size;
  }
}

}  // namespace
}  // namespace pyrasim
