// SPDX-License-Identifier: Apache-2.0
#include "scene/load_mesh.h"

#include <array>
#include <string>

#include "../error_of.h"
#include "error.h"
#include "temp_folder.h"

namespace pyrasim {
namespace {

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

class LoadMesh : public TempFolderTest {
 protected:
  LoadedMesh load(const std::string& text) const { return load_mesh(write("m.obj", text)); }

  /// The message for an OBJ text, without the file's path in front.
  std::string mesh_error(const std::string& text) const {
    const std::string file = write("m.obj", text).string();
    const std::string message = error_of<InputError>([&] { load_mesh(file); });
    return message.find(file) == 0 ? message.substr(file.size()) : message;
  }
};

TEST_F(LoadMesh, ReadsTrianglesOfEveryKindOfCorner) {
  const auto loaded = load(square +
                           "vt 0 0\nvn 0 0 1\n# comment\no part\ng group\nusemtl none\ns off\n"
                           "f 1 2 3\n  f 1/1 3/1 4/1\r\nf 1//1 2//1 4//1\nf 2/1/1 3/1/1 4/1/1\nf -4 -3 -2\n");
  EXPECT_EQ(loaded.mesh.vertices.size(), 4U);
  EXPECT_EQ(loaded.mesh.vertices[2], glm::dvec3(1, 1, 0));
  ASSERT_EQ(loaded.mesh.triangles.size(), 5U);
  EXPECT_EQ(loaded.mesh.triangles[1], (std::array<std::uint32_t, 3>{0, 2, 3}));
  EXPECT_EQ(loaded.mesh.triangles[4], (std::array<std::uint32_t, 3>{0, 1, 2}));
  EXPECT_EQ(loaded.skipped, 0U);
}

TEST_F(LoadMesh, KeepsTheFilesPrecision) {
  EXPECT_EQ(load("v 0.1 1e-3 +2.5 1 1 1\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").mesh.vertices[0], glm::dvec3(0.1, 1e-3, 2.5));
}

TEST_F(LoadMesh, SplitsPolygons) {
  EXPECT_EQ(load(square + "f 1 2 3 4\n").mesh.triangles.size(), 2U);
  const auto loaded = load(square + "v -1 0.5 0\nf 1 2 3 4 5\nf 1 2 3\n");
  EXPECT_EQ(loaded.mesh.triangles.size(), 4U);
  EXPECT_EQ(loaded.skipped, 0U);
}

TEST_F(LoadMesh, AllowsFacesBeforeTheirVertices) { EXPECT_EQ(load("f 1 2 3\n" + square).mesh.triangles.size(), 1U); }

TEST_F(LoadMesh, SkipsAndCountsDegenerateTriangles) {
  const auto loaded = load(square + "v 2 0 0\nf 1 2 3\nf 1 1 2\nf 1 2 5\nf 3 4 1\n");
  EXPECT_EQ(loaded.mesh.triangles.size(), 2U);
  EXPECT_EQ(loaded.skipped, 2U);
}

TEST_F(LoadMesh, CountsWhatPolygonsLose) {
  const auto loaded = load(square + "f 1 2 3 3\nf 1 1 1 1 1\nf 1 2 3\n");
  EXPECT_EQ(loaded.mesh.triangles.size() + loaded.skipped, 2U + 3U + 1U);
  EXPECT_GE(loaded.skipped, 4U);
}

TEST_F(LoadMesh, RefusesWrongIndices) {
  EXPECT_EQ(mesh_error(square + "f 1 2 3\nf 0 1 2\n"),
            ":6: the index 0 selects no vertex; 1 to 4, or -1 to -4 counted back from the last, is allowed");
  EXPECT_EQ(mesh_error(square + "f 1 2 3\nf 1 2 5\nf 1 2 4\n"),
            ":6: the index 5 selects no vertex; 1 to 4, or -1 to -4 counted back from the last, is allowed");
  EXPECT_EQ(mesh_error(square + "f 1 2 3 9\n"),
            ":5: the index 9 selects no vertex; 1 to 4, or -1 to -4 counted back from the last, is allowed");
  EXPECT_EQ(mesh_error(square + "f 1 2 -5\n"),
            ":5: the index -5 selects no vertex; 1 to 4, or -1 to -4 counted back from the last, is allowed");
  EXPECT_EQ(mesh_error("f 1 2 3\n"), ":1: the index 3 selects no vertex; there are no vertices to select");
}

TEST_F(LoadMesh, RefusesWrongFaces) {
  const std::string allowed = " is no corner of a face; V, V/T, V//N or V/T/N with indices other than 0 is allowed";
  EXPECT_EQ(mesh_error(square + "f 1 2 x\n"), ":5: \"x\"" + allowed);
  EXPECT_EQ(mesh_error(square + "f 1 2 3.5\n"), ":5: \"3.5\"" + allowed);
  EXPECT_EQ(mesh_error(square + "f 1 2 3/\n"), ":5: \"3/\"" + allowed);
  EXPECT_EQ(mesh_error(square + "f 1 2 3/0\n"), ":5: \"3/0\"" + allowed);
  EXPECT_EQ(mesh_error(square + "f 1 2 3/1/1/1\n"), ":5: \"3/1/1/1\"" + allowed);
  EXPECT_EQ(mesh_error(square + "f 1 2 99999999999\n"), ":5: \"99999999999\"" + allowed);
  EXPECT_EQ(mesh_error(square + "f 1 2 \\\n 3\n"), ":5: \"\\\"" + allowed);
  EXPECT_EQ(mesh_error(square + "f 1 2\n"), ":5: a face with 2 corners; at least 3 are needed");
}

TEST_F(LoadMesh, RefusesWrongCoordinates) {
  const std::string allowed = " is no coordinate; a number from -1e+30 to 1e+30 is allowed";
  EXPECT_EQ(mesh_error("v 0 0 0\r\nv 1 nan 0\r\n"), ":2: \"nan\"" + allowed);
  EXPECT_EQ(mesh_error("v 0 inf 0\n"), ":1: \"inf\"" + allowed);
  EXPECT_EQ(mesh_error("v 0 0 1e999\n"), ":1: \"1e999\"" + allowed);
  EXPECT_EQ(mesh_error("v 0 0 1e31\n"), ":1: \"1e31\"" + allowed);
  EXPECT_EQ(mesh_error("v 0 one 0\n"), ":1: \"one\"" + allowed);
  EXPECT_EQ(mesh_error("v 0 1x 0\n"), ":1: \"1x\"" + allowed);
  EXPECT_EQ(mesh_error("v 0 0\n"), ":1: a vertex with 2 coordinates; three are needed");
}

TEST_F(LoadMesh, RefusesFilesWithoutAMesh) {
  EXPECT_EQ(mesh_error(""), ": it has no faces; at least one is needed");
  EXPECT_EQ(mesh_error(square), ": it has no faces; at least one is needed");
  EXPECT_EQ(mesh_error("\x89PNG\r\n\x1a\n...\n"), ": it has no faces; at least one is needed");
  EXPECT_EQ(mesh_error(square + "f 1 1 2\n"), ": all its faces are degenerate; at least one with an area is needed");
  EXPECT_EQ(mesh_error(square + "f 1 2 3\nl 0 1\n").find(": Failed parse `l' line"), 0U);
  EXPECT_EQ(
      error_of<InputError>([&] { load_mesh(folder() / "none.obj"); }),
      (folder() / "none.obj").string() + ": cannot be read: No such file or directory; a readable OBJ file is allowed");
}

}  // namespace
}  // namespace pyrasim
