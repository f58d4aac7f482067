// SPDX-License-Identifier: Apache-2.0
#include "mesh/load_mesh.h"

#include <array>
#include <string>
#include <vector>

#include "../error_of.h"
#include "../temp_folder.h"
#include "error.h"

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

  /// A line for each warning, without the file's path and a colon in front.
  std::string warnings(const LoadedMesh& loaded) const {
    const std::string file = (folder() / "m.obj").string() + ":";
    std::string lines;
    for (const std::string& warning : loaded.warnings) {
      EXPECT_EQ(warning.find(file), 0U) << warning;
      lines += warning.substr(file.size()) + "\n";
    }
    return lines;
  }
};

TEST_F(LoadMesh, ReadsTrianglesOfEveryKindOfCorner) {
  const auto loaded = load(square +
                           "vt 0 0\nvn 0 0 1\n# comment\ns off\n"
                           "f 1 2 3\n  f 1/1 3/1 4/1\r\nf 1//1 2//1 4//1\nf 2/1/1 3/1/1 4/1/1\nf -4 -3 -2\n"
                           "f 1/ 2/ 3/\nf 1// 2// 3//\nf 1/1/ 2/1/ 3/1/\nf +1 +2 +3\n");
  EXPECT_EQ(loaded.mesh.vertices.size(), 4U);
  EXPECT_EQ(loaded.mesh.vertices[2], glm::dvec3(1, 1, 0));
  ASSERT_EQ(loaded.mesh.triangles.size(), 9U);
  EXPECT_EQ(loaded.mesh.triangles[1], (std::array<std::uint32_t, 3>{0, 2, 3}));
  for (std::size_t k = 4; k < 9; ++k) {
    EXPECT_EQ(loaded.mesh.triangles[k], (std::array<std::uint32_t, 3>{0, 1, 2})) << k;
  }
  EXPECT_TRUE(loaded.warnings.empty());
}

TEST_F(LoadMesh, KeepsTheFilesPrecision) {
  EXPECT_EQ(load("v 0.1 1e-3 +2.5 1\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").mesh.vertices[0], glm::dvec3(0.1, 1e-3, 2.5));
  EXPECT_EQ(load("v 1e-400 -1e-400 1.\nv .5 5E-1 0\nv 0 1 0\nf 1 2 3\n").mesh.vertices[0], glm::dvec3(0, 0, 1));
  EXPECT_EQ(load("v 5e-324 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").mesh.vertices[0], glm::dvec3(5e-324, 0, 0));
}

TEST_F(LoadMesh, ReadsLinesAsOtherReadersDo) {
  const std::string plain = square + "f 1 2 3\nf -1 -2 -3\n";
  const LoadedMesh expected = load(plain);
  const std::vector<std::string> texts{
      "\xef\xbb\xbf" + plain,  // a byte-order mark
      "v 0 \\\n 0 0\nv 1 0\\\n0\nv 1 1 0\nv 0 1 0\nf 1 2\\\n 3\nf -1 \\\n-2 \\  \n-3",
      "v 0 0 0\rv 1 0 0\rv 1 1 0\rv 0 1 0\rf 1 2 3\rf -1 -2 -3\r",
      "v 0 0 0\r\nv 1 0\\\r\n 0\r\nv 1 1 0\r\nv 0 1 0\r\nf 1 2 3\r\nf -1 -2 -3",
      "\tv\t0\t0\t0 \n v  1 0\v0\t\n\fv\f1 1 0\nv 0 1 0\n  f 1\t2 3 \t\n f -1 -2 -3 ",
      square + "f 1 2 3 # of four\nf -1 -2 -3# of four\n",
      "v 0 0 0 # the origin\nv 1 0 0#\nv 1 1 0\nv 0 1 0\n# f 1 2 4 \\\nf 1 2 3 # \\\n  # f 1 2 4\nf -1 -2 -3\n"};
  for (const std::string& text : texts) {
    const LoadedMesh loaded = load(text);
    EXPECT_EQ(loaded.mesh.vertices, expected.mesh.vertices) << text;
    EXPECT_EQ(loaded.mesh.triangles, expected.mesh.triangles) << text;
    EXPECT_TRUE(loaded.warnings.empty()) << text;
  }
}

TEST_F(LoadMesh, LinesKeepTheirNumbers) {
  EXPECT_EQ(mesh_error("# one\\\nv 0 \\\n0 \\\n 0\r\n\r\nf 1 2 x\n").find(":6: \"x\""), 0U);
  EXPECT_EQ(mesh_error(square + "f 1 2 \\\n \\\n x\n").find(":5: \"x\""), 0U);
  EXPECT_EQ(mesh_error(square + "f 1 2 3 \\\n"), "(no error)");
}

TEST_F(LoadMesh, SplitsPolygons) {
  EXPECT_EQ(load(square + "f 1 2 3 4\n").mesh.triangles.size(), 2U);
  const auto loaded = load(square + "v -1 0.5 0\nf 1 2 3 4 5\nf 1 2 3\n");
  EXPECT_EQ(loaded.mesh.triangles.size(), 4U);
  EXPECT_TRUE(loaded.warnings.empty());
  std::string text;
  std::string face = "f";
  for (int k = 0; k < 300; ++k) {  // more than a byte counts
    text += "v " + std::to_string(k < 150 ? k : 299 - k) + (k < 150 ? " 0 0\n" : " 1 0\n");
    face += " " + std::to_string(k - 300);
  }
  EXPECT_EQ(load(text + face + "\n" + face + "\n").mesh.triangles.size(), 2 * 298U);
}

TEST_F(LoadMesh, AllowsFacesBeforeTheirVertices) { EXPECT_EQ(load("f 1 2 3\n" + square).mesh.triangles.size(), 1U); }

TEST_F(LoadMesh, SkipsAndCountsFacesWithoutAnArea) {
  const auto loaded = load(square + "v 2 0 0\nf 1 2 3\nf 1 1 2\nf 1 2 5\nf 1 1 1 1 1\nf 1 2 5 2\nf 3 4 1\n");
  EXPECT_EQ(loaded.mesh.triangles.size(), 2U);
  EXPECT_EQ(warnings(loaded), " 4 faces without an area were skipped; 2 triangles are left\n");
}

TEST_F(LoadMesh, SaysNothingOfRepeatedCorners) {
  const auto loaded = load(square + "f 1 2 3 3\nf 1 2 2 3 4 4\nf 1 2 3\n");
  EXPECT_EQ(loaded.mesh.triangles.size(), 1U + 2U + 1U);
  EXPECT_TRUE(loaded.warnings.empty());
}

TEST_F(LoadMesh, WarnsOfPolygonsThatCrossThemselves) {
  const auto loaded = load(square + "f 1 2 3 4\nf 1 3 2 4\nf 1 2 4 3\n");
  EXPECT_EQ(warnings(loaded),
            " 2 polygons cross or cover themselves, the first in line 6; what they enclose is not defined, and any "
            "triangles may be seen\n");
  EXPECT_GE(loaded.mesh.triangles.size(), 3U);
}

TEST_F(LoadMesh, WarnsOnceOfWhatIsNotRead) {
  const std::string face = square + "f 1 2 3\n";
  EXPECT_EQ(
      warnings(load("v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0\nf 1 2 3\nbevel on\n")),
      " how things look is not read (bevel 1, colours of vertices 2); materials (usemtl) are, of one colour each or a "
      "picture\n");
  EXPECT_EQ(warnings(load(face + "l 1 2\nl 0\np 1\nvp 0 0\ncstype bezier\nend\n")),
            " lines, points and free-form surfaces are not read (cstype 1, end 1, l 2, p 1, vp 1); faces (f) are\n");
  EXPECT_EQ(
      warnings(load(face + "F 1 2 3\nfoo\nfoo 1\n" + std::string(90, 'x') + "\nb\x1b[2J\n")),
      " unknown keywords (F 1, b\\u001b[2J 1, foo 2, xxxxxxxxxxxxxxxxxxxx\u2026 1); their lines are passed over\n");
  std::string many = face;
  for (int k = 10; k < 30; ++k) many += "key" + std::to_string(k) + "\n";
  EXPECT_EQ(warnings(load(many)),
            " unknown keywords (key10 1, key11 1, key12 1, key13 1, key14 1, key15 1, key16 1, key17 1 and 12 more); "
            "their lines are passed over\n");
}

TEST_F(LoadMesh, SaysWhatIsLeftUnused) {
  const auto loaded = load(square + "o a\nusemtl red\nf 1 2 3\nusemtl blue\no b\nf 1 3 4\n");
  EXPECT_TRUE(loaded.warnings.empty());
  EXPECT_TRUE(loaded.unused("m.obj", true, true).empty());
  EXPECT_EQ(loaded.unused("m.obj", false, true),
            std::vector<std::string>{"m.obj: materials are not used (2), since the object has a color or a texture"});
  EXPECT_EQ(loaded.unused("m.obj", false, false),
            (std::vector<std::string>{"m.obj: materials are not used (2), since the object has a color or a texture",
                                      "m.obj: groups are one object (2); with \"split\": \"groups\" each is one"}));
  EXPECT_TRUE(loaded.unused("m.obj", true, false).empty()) << "by its materials it is several";
  EXPECT_TRUE(load(square + "o a\ng c\nf 1 2 3\ng b\n").unused("m.obj", false, false).empty())
      << "one group has a face";
}

TEST_F(LoadMesh, GroupsHaveTheNamesOfObjectAndGroup) {
  const auto loaded =
      load(square + "f 1 2 3\ng wheel  left\nf 1 2 4\no car\nf 1 3 4\ng wheel\nf 2 3 4\no car\nf 1 2 3\n");
  std::vector<std::string> names;
  for (const TriangleMark& mark : loaded.marks) names.push_back(loaded.groups[mark.group].text);
  EXPECT_EQ(names, (std::vector<std::string>{"", "wheel  left", "car", "car/wheel", "car"}));
}

TEST_F(LoadMesh, MaterialsLastUntilTheNext) {
  const auto loaded =
      load("mtllib a.mtl b.mtl\n" + square + "f 1 2 3\nusemtl my red\nf 1 2 4\nf 1 3 4 2\nusemtl blue\nf 2 3 4\n");
  std::vector<std::uint32_t> materials;
  for (const TriangleMark& mark : loaded.marks) materials.push_back(mark.material);
  EXPECT_EQ(materials, (std::vector<std::uint32_t>{no_value, 0, 0, 0, 1}));
  ASSERT_EQ(loaded.materials.size(), 2U);
  EXPECT_EQ(loaded.materials[0].text, "my red");
  EXPECT_EQ(loaded.materials[0].line, 7U);
  ASSERT_EQ(loaded.libraries.size(), 1U);
  EXPECT_EQ(loaded.libraries[0].text, "a.mtl b.mtl");
}

TEST_F(LoadMesh, TrianglesKeepWhatTheirCornersSelect) {
  const auto& mesh = load(square +
                          "vt 0.5\nvt 1 0.25 7\nvt -1 2\nvn 0 0 1\nvn 1 0 0\n"
                          "f 1/1/1 2/2/2 3/-1/-2 4/1/1\nf 1//2 2//1 3//1\nf 1 1/1 2/1\n")
                         .mesh;
  ASSERT_EQ(mesh.triangles.size(), 3U);
  for (std::size_t k = 0; k < 2; ++k) {
    const auto places = mesh.places.of(k);
    const auto normals = mesh.normals.of(k);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::uint32_t vertex = mesh.triangles[k][corner];
      const std::array<glm::dvec2, 4> expected{{{0.5, 0}, {1, 0.25}, {-1, 2}, {0.5, 0}}};
      EXPECT_EQ(places[corner], expected[vertex]) << k;
      EXPECT_EQ(normals[corner], vertex == 1 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1)) << k;
    }
  }
  EXPECT_EQ(mesh.places.corners[2], (TriangleCorners{no_value, no_value, no_value}));
  EXPECT_EQ(mesh.normals.corners[2], (TriangleCorners{1, 0, 0}));
  EXPECT_FALSE(all_have(mesh.places));
  EXPECT_TRUE(all_have(mesh.normals));
  EXPECT_FALSE(all_have(load(square + "f 1 2 3\n").mesh.places));
}

TEST_F(LoadMesh, RefusesWrongTextureCoordinatesAndNormals) {
  EXPECT_EQ(mesh_error("vt\n"), ":1: a texture coordinate with 0 coordinates; one is needed, or two");
  EXPECT_EQ(mesh_error("vt 0 x\n"), ":1: \"x\" is no coordinate; a number from -1e+30 to 1e+30 is allowed");
  EXPECT_EQ(mesh_error("vn 0 1\n"), ":1: a normal with 2 components; three are needed");
  EXPECT_EQ(mesh_error("vn 0 inf 1\n"), ":1: \"inf\" is no component; a number from -1e+30 to 1e+30 is allowed");
  EXPECT_EQ(mesh_error(square + "f 1/1 2/1 3/1\n"),
            ":5: the index 1 selects no texture coordinate; there are no texture coordinates to select");
  EXPECT_EQ(mesh_error(square + "vn 0 0 1\nf 1//1 2//1 3//2\n"),
            ":6: the index 2 selects no normal; 1 to 1, or -1 to -1 counted back from the last, is allowed");
  EXPECT_EQ(mesh_error(square + "vn 0 0 1\nf 1//1 2//-2 3//1\n"),
            ":6: the index -2 selects no normal; 1 to 1, or -1 to -1 counted back from the last, is allowed");
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
  EXPECT_EQ(mesh_error(square + "f 1 2 3///\n"), ":5: \"3///\"" + allowed);
  EXPECT_EQ(mesh_error(square + "f 1 2 /3\n"), ":5: \"/3\"" + allowed);
  EXPECT_EQ(mesh_error(square + "f 1 2 3/0\n"), ":5: \"3/0\"" + allowed);
  EXPECT_EQ(mesh_error(square + "f 1 2 3/1/1/1\n"), ":5: \"3/1/1/1\"" + allowed);
  EXPECT_EQ(mesh_error(square + "f 1 2 99999999999\n"), ":5: \"99999999999\"" + allowed);
  EXPECT_EQ(mesh_error(square + "f 1 2 \\ 3\n"), ":5: \"\\\"" + allowed);
  EXPECT_EQ(mesh_error(square + "f 1 2 " + std::string(1000, '3') + "\n"),
            ":5: \"" + std::string(60, '3') + "\u2026\"" + allowed);
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
  EXPECT_EQ(mesh_error("\xff\xfev\0 1\0"), ":1: it is UTF-16; UTF-8 is allowed");
  EXPECT_EQ(
      error_of<InputError>([&] { load_mesh(folder() / "none.obj"); }),
      (folder() / "none.obj").string() + ": cannot be read: No such file or directory; a readable OBJ file is allowed");
}

}  // namespace
}  // namespace pyrasim
