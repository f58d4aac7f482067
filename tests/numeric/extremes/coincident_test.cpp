// SPDX-License-Identifier: Apache-2.0
// Extremes: surfaces in the same place. The first in the scene is seen, whatever the hierarchy and the format. (That
// the machine's number of units does not matter: hw_model/coincident_test.cpp.)
#include "formats.h"

namespace pyrasim {
namespace {

/// `copies` of one surface, each object of its own color, among others that the hierarchy has to put somewhere.
Scene with_copies(const SceneSurface& surface, int copies) {
  Scene scene = empty_scene(8, 8, 0.05);
  for (int k = 0; k < copies; ++k) {
    scene.objects.push_back(object(surface, glm::dvec3(k == 0 ? 1 : 0, 0.5, 0.5)));
    if (k % 4 == 3) scene.objects.push_back(object(Sphere{{9, 0.1 * (k % 40), 0.2 * (k % 7)}, 0.1}));
  }
  return scene;
}

const std::vector<SceneSurface> surfaces{Sphere{{5, 0.3, -0.1}, 2}, Plane{{1, 0.25, 0.125}, 5},
                                         Triangle{{{{5, -3, -2}, {5.5, 4, -2}, {6, 0, 4}}}}};

TEST(ExtremesCoincident, TheFirstIsSeenInEveryFormat) {
  for (const SceneSurface& surface : surfaces) {
    const Scene scene = with_copies(surface, 40);
    for (const NumberFormat& format : number_formats()) {
      SCOPED_TRACE(format.name());
      const auto intersector = make_intersector(scene, format);
      int seen = 0;
      for (int k = 0; k < 200; ++k) {
        Work work;
        const auto object = intersector->intersect({1, 0.02 * (k / 14 - 7), 0.02 * (k % 14 - 7)}, work).seen.object;
        if (object == no_object || object % 5 == 4) continue;  // one of the small ones, or none
        ASSERT_EQ(object, 0U) << k;
        ++seen;
      }
      EXPECT_GT(seen, 60);
    }
  }
}

TEST(ExtremesCoincident, TenThousandOfThem) {
  const Scene scene = with_copies(surfaces[0], 8000);  // and 2000 others
  for (const char* name : {"double", "float", "fp16", "fp24", "fix32.16"}) {
    const auto intersector = make_intersector(scene, parse_number_format(name));
    Work work;
    for (const double y : {0.0, 0.1, -0.1}) EXPECT_EQ(intersector->intersect({1, y, 0}, work).seen.object, 0U) << name;
    EXPECT_GE(work.surface_tests[0], 24000U);
  }
}

/// Different surfaces that touch at what a format sees as one place: any may be first, but it is the scene's order that
/// says which, not the hierarchy's.
TEST(ExtremesCoincident, TheHierarchyDoesNotDecide) {
  for (const NumberFormat& format : number_formats()) {
    SCOPED_TRACE(format.name());
    Random random(13);
    Scene scene = empty_scene(16, 16, 0.05);
    for (int k = 0; k < 60; ++k) {
      const glm::dvec3 place(5, std::floor(random.uniform(-2, 2)), std::floor(random.uniform(-2, 2)));
      scene.objects.push_back(object(Sphere{place + glm::dvec3(1, 0, 0), 1}));
      scene.objects.push_back(
          object(Triangle{{place - glm::dvec3(0, 1, 1), place + glm::dvec3(0, 2, 0), place + glm::dvec3(0, 0, 2)}}));
    }
    const auto intersector = make_intersector(scene, format);
    const auto exhaustive = make_intersector(scene, format, Search::exhaustive);
    for (int k = 0; k < 1000; ++k) {
      const glm::dvec3 v(1, 0.0125 * (k % 32 - 16), 0.025 * (k / 32 - 16));
      Work work;
      ASSERT_EQ(intersector->intersect(v, work), exhaustive->intersect(v, work)) << k;
    }
  }
}

}  // namespace
}  // namespace pyrasim
