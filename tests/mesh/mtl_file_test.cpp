// SPDX-License-Identifier: Apache-2.0
#include "mesh/mtl_file.h"

#include "../error_of.h"
#include "error.h"

namespace pyrasim {
namespace {

std::string error_in(const std::string& text) {
  return error_of<InputError>([&] { read_mtl(text, "m.mtl"); });
}

TEST(MtlFile, ColoursOfMaterials) {
  const MtlFile mtl = read_mtl(
      "# two\nnewmtl red\nKa 1 1 1\nKd 0.8 0.1 0\nKs 0 0 0\nillum 2\nd 1.0\nNs 10\n\nnewmtl my grey \nKd 0.25\nTr "
      "0\nKe 0 0 0\n"
      "newmtl white\n",
      "m.mtl");
  ASSERT_EQ(mtl.materials.size(), 3U);
  EXPECT_EQ(mtl.materials[0].name, "red");
  EXPECT_EQ(mtl.materials[0].color, glm::dvec3(0.8, 0.1, 0));
  EXPECT_FALSE(mtl.materials[0].map);
  EXPECT_EQ(mtl.materials[1].name, "my grey");
  EXPECT_EQ(mtl.materials[1].color, glm::dvec3(0.25));
  EXPECT_EQ(mtl.materials[2].color, glm::dvec3(1));
  EXPECT_TRUE(mtl.warnings.empty());
}

TEST(MtlFile, MapsAndTheirOptions) {
  const MtlFile mtl = read_mtl(
      "newmtl a\nmap_Kd wood grain.png\nnewmtl b\nmap_Kd -s 2 4 1 -o 0.5 -clamp on textures\\x.png\nnewmtl c\n"
      "map_Kd -clamp off -blendu on -s 3 1.png\n",
      "m.mtl");
  const auto& a = mtl.materials[0].map;
  ASSERT_TRUE(a);
  EXPECT_EQ(a->file, "wood grain.png");
  EXPECT_FALSE(a->clamp);
  EXPECT_EQ(a->scale, glm::dvec2(1));
  EXPECT_EQ(a->offset, glm::dvec2(0));
  EXPECT_EQ(a->line, "m.mtl:2");
  const auto& b = mtl.materials[1].map;
  ASSERT_TRUE(b);
  EXPECT_EQ(b->file, "textures/x.png");
  EXPECT_TRUE(b->clamp);
  EXPECT_EQ(b->scale, glm::dvec2(2, 4));
  EXPECT_EQ(b->offset, glm::dvec2(0.5, 0));
  const auto& c = mtl.materials[2].map;
  ASSERT_TRUE(c);
  EXPECT_EQ(c->file, "1.png");
  EXPECT_EQ(c->scale, glm::dvec2(3, 1));
  EXPECT_TRUE(mtl.warnings.empty());
}

TEST(MtlFile, WarnsOfWhatWouldLookDifferent) {
  const MtlFile mtl = read_mtl(
      "newmtl glass\nd 0.5\nTr 0.5\nKe 1 0 0\nmap_d x.png\nmap_Kd -mm 0 2 -t 1 1 x.png\nfoo\nfoo 1\nmtllib m.mtl\n",
      "m.mtl");
  ASSERT_EQ(mtl.warnings.size(), 1U);
  EXPECT_EQ(mtl.warnings[0],
            "m.mtl: of materials Kd and map_Kd are read; these lines are passed over: Ke 1, Tr 1, d 1, foo 2, "
            "map_Kd -mm 1, map_Kd -t 1, map_d 1, mtllib 1");
  EXPECT_EQ(mtl.materials[0].map->file, "x.png");
}

TEST(MtlFile, Mistakes) {
  EXPECT_EQ(error_in("Kd 1 1 1\n"), "m.mtl:1: Kd of no material; newmtl and a material's name are needed before it");
  EXPECT_EQ(error_in("newmtl a\nKd 1 x 1\n"), "m.mtl:2: \"x\" is no colour; a number from 0 to 4096 is allowed");
  EXPECT_EQ(error_in("newmtl a\nKd 1 1\n"), "m.mtl:2: a colour of 2 numbers; three are needed, or one");
  EXPECT_EQ(error_in("newmtl a\nKd -1 0 0\n"), "m.mtl:2: \"-1\" is no colour; a number from 0 to 4096 is allowed");
  EXPECT_EQ(error_in("newmtl a\nKd spectral x.rfl\n"), "m.mtl:2: a spectral colour; red, green and blue are allowed");
  EXPECT_EQ(error_in("newmtl a\nmap_Kd -clamp on\n"),
            "m.mtl:2: map_Kd without a file; the path of a PNG file is allowed");
  EXPECT_EQ(error_in("newmtl a\nmap_Kd -s 0 1 x.png\n"), "m.mtl:2: a scale of nothing; 1e-30 at least is allowed");
}

}  // namespace
}  // namespace pyrasim
