// SPDX-License-Identifier: Apache-2.0
// Extremes: rays inside the faces and along the edges of bounding boxes.
#include "formats.h"

namespace pyrasim {
namespace {

/// Squares and balls in a lattice whose boxes begin and end at slopes that rays have exactly.
Scene lattice() {
  Scene scene = empty_scene(64, 64, 1.0 / 32);
  for (int x = 1; x <= 4; x *= 2) {
    for (int y = -2; y <= 2; ++y) {
      for (int z = -2; z <= 2; ++z) {
        const glm::dvec3 corner(4 * x, y, z);
        scene.objects.push_back(object(Triangle{{corner, corner + glm::dvec3(0, 1, 0), corner + glm::dvec3(0, 0, 1)}}));
        scene.objects.push_back(object(Triangle{{corner, corner + glm::dvec3(1, 0, 0), corner + glm::dvec3(0, 0, 1)}}));
        if ((x + y + z) % 2 == 0) scene.objects.push_back(object(Sphere{corner, 0.5}));
      }
    }
  }
  return scene;
}

TEST(ExtremesBoxFaces, RaysInThemMissNothing) {
  const Scene scene = lattice();
  for (const NumberFormat& format : number_formats()) {
    SCOPED_TRACE(format.name());
    const auto intersector = make_intersector(scene, format);
    const auto exhaustive = make_intersector(scene, format, Search::exhaustive);
    ASSERT_GT(intersector->contents().inner_nodes, 1U);
    int hits = 0;
    for (int y = -16; y <= 16; ++y) {
      for (int z = -16; z <= 16; ++z) {
        for (const double zero : {0.0, -0.0}) {
          const glm::dvec3 v(1, y == 0 ? zero : y / 16.0, z == 0 ? zero : z / 16.0);
          Work work;
          const Sample sample = intersector->intersect(v, work);
          ASSERT_EQ(sample, exhaustive->intersect(v, work)) << y << " " << z;
          hits += sample.seen.object == no_object ? 0 : 1;
        }
      }
    }
    EXPECT_GT(hits, 200);
  }
}

}  // namespace
}  // namespace pyrasim
