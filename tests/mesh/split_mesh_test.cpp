// SPDX-License-Identifier: Apache-2.0
#include "mesh/split_mesh.h"

#include <map>

#include "../temp_folder.h"

namespace pyrasim {
namespace {

class SplitMesh : public TempFolderTest {
 protected:
  LoadedMesh load() const {
    return load_mesh(write("m.obj",
                           "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 9 9 9\nvt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\n"
                           "usemtl red\no a\nf 1/1/1 2/2/1 3/3/1\nusemtl blue\nf 3/3/1 4/1/1 1/2/1\no b\nf 2 3 4\n"
                           "usemtl red\nf 1 2 4\n"));
  }
};

using Vertices = std::array<glm::dvec3, 3>;

/// By their vertices, which are all that a part has to keep.
std::vector<Vertices> triangles_of(const TriangleMesh& mesh) {
  std::vector<Vertices> result;
  for (const auto& [a, b, c] : mesh.triangles) result.push_back({mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]});
  return result;
}

TEST_F(SplitMesh, ByEitherOrBoth) {
  const LoadedMesh mesh = load();
  const std::vector<Vertices> all = triangles_of(mesh.mesh);
  for (const auto& [by_group, by_material, count] :
       {std::tuple(false, true, 2U), {true, false, 2U}, {true, true, 4U}}) {
    const auto parts = split_mesh(mesh, by_group, by_material);
    ASSERT_EQ(parts.size(), count);
    std::size_t triangles = 0;
    for (const MeshPart& part : parts) {
      std::size_t next = 0;
      for (std::size_t k = 0; k < all.size(); ++k) {
        const TriangleMark& mark = mesh.marks[k];
        if ((by_group && mark.group != part.group) || (by_material && mark.material != part.material)) continue;
        ASSERT_LT(next, part.mesh.triangles.size());
        EXPECT_EQ(triangles_of(part.mesh)[next], all[k]);
        const bool has_values = mesh.mesh.places.corners[k][0] != no_value;
        EXPECT_EQ(part.mesh.places.corners[next][0] != no_value, has_values);
        if (has_values) {
          EXPECT_EQ(part.mesh.places.of(next), mesh.mesh.places.of(k));
          EXPECT_EQ(part.mesh.normals.of(next), mesh.mesh.normals.of(k));
        }
        ++next;
      }
      EXPECT_EQ(next, part.mesh.triangles.size());
      triangles += next;
      for (const glm::dvec3& vertex : part.mesh.vertices) EXPECT_LT(vertex.x, 9) << "no triangle has it";
    }
    EXPECT_EQ(triangles, all.size());
  }
}

}  // namespace
}  // namespace pyrasim
