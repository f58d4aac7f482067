// SPDX-License-Identifier: Apache-2.0
#include "mesh/load_materials.h"

#include "../error_of.h"
#include "../temp_folder.h"
#include "error.h"

namespace pyrasim {
namespace {

class LoadMaterials : public TempFolderTest {
 protected:
  /// Of a triangle in a folder, with `head` in front of its face.
  LoadedMaterials load(const std::string& head) const {
    std::filesystem::create_directories(folder() / "sub");
    const auto file = write("sub/m.obj", head + "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    return load_materials(load_mesh(file), file);
  }
  /// Without the folder's path.
  std::string error(const std::string& head) const {
    std::string message = error_of<InputError>([&] { load(head); });
    for (std::size_t at = 0; (at = message.find(folder().string() + "/")) != std::string::npos;) {
      message.erase(at, folder().string().size() + 1);
    }
    return message;
  }
};

TEST_F(LoadMaterials, TheFirstLibraryThatHasOneCounts) {
  write("one.mtl", "newmtl red\nKd 1 0 0\nnewmtl red\nKd 0.5 0 0\nmap_Kd ignored.png\n");
  write("two three.mtl", "newmtl red\nKd 0.25 0 0\nnewmtl blue\nKd 0 0 1\nmap_Kd pictures/x.png\nfoo\n");
  const auto loaded = load("mtllib ../one.mtl\nmtllib ../two three.mtl\nusemtl blue\nusemtl red\n");
  ASSERT_EQ(loaded.materials.size(), 2U);
  EXPECT_EQ(loaded.materials[0].color, glm::dvec3(0, 0, 1));
  EXPECT_EQ(std::filesystem::path(loaded.materials[0].map->file).lexically_normal(), folder() / "pictures/x.png");
  EXPECT_EQ(loaded.materials[1].color, glm::dvec3(1, 0, 0));
  EXPECT_FALSE(loaded.materials[1].map);
  EXPECT_EQ(loaded.files.size(), 2U);
  EXPECT_EQ(loaded.warnings.size(), 1U);
}

TEST_F(LoadMaterials, ALineMayNameSeveralAndOneTwice) {
  write("one.mtl", "newmtl red\nKd 1 0 0\nfoo\n");
  write("two.mtl", "newmtl blue\nKd 0 0 1\n");
  const auto loaded = load("mtllib ../one.mtl ../two.mtl\nmtllib ../one.mtl\nusemtl blue\nusemtl red");
  EXPECT_EQ(loaded.files.size(), 2U);
  EXPECT_EQ(loaded.warnings.size(), 1U);
}

TEST_F(LoadMaterials, Mistakes) {
  write("one.mtl", "newmtl red\nKd 1 0 0\n");
  const std::string needed = "; a readable MTL file is needed, or the object's color in the scene";
  EXPECT_EQ(error("mtllib none.mtl\nusemtl red"),
            "sub/m.obj:1: sub/none.mtl cannot be read: No such file or directory" + needed);
  EXPECT_EQ(error("mtllib ..\nusemtl red"), "sub/m.obj:1: sub/.. cannot be read: it is no file" + needed);
  EXPECT_EQ(error("mtllib /dev/zero\nusemtl red"), "sub/m.obj:1: /dev/zero cannot be read: it is no file" + needed);
  EXPECT_EQ(error("mtllib ../one.mtl\nusemtl green"),
            "sub/m.obj:2: none of its libraries has a material \"green\"; one of theirs is allowed, or the object's "
            "color in the scene");
  EXPECT_EQ(error("usemtl red").find("sub/m.obj:1: none of its libraries"), 0U);
  EXPECT_EQ(error("mtllib m.obj\nusemtl red").find("sub/m.obj:2: none of its libraries"), 0U) << "itself";
  write("two.mtl", "newmtl red\nKd x\n");
  EXPECT_EQ(error("mtllib ../two.mtl\nusemtl red").find("sub/../two.mtl:2: \"x\" is no colour"), 0U);
}

}  // namespace
}  // namespace pyrasim
