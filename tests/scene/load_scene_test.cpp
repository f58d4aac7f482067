// SPDX-License-Identifier: Apache-2.0
#include "scene/load_scene.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <string>

#include "../error_of.h"
#include "../shipped_scene.h"
#include "../temp_folder.h"
#include "error.h"
#include "image/write_image.h"

namespace pyrasim {
namespace {

class LoadScene : public TempFolderTest {
 protected:
  Scene load(const std::string& text) const { return load_scene(write("s.json", text)); }
};

/// A scene whose camera has the members `camera`, with `more` behind it.
std::string with_camera(const std::string& camera, const std::string& more = R"("objects": [])") {
  return "{\"camera\": {" + camera + "}, " + more + "}";
}

const std::string small_screen = R"("screen": {"columns": 4, "rows": 3, "dx": 1, "dy": 0.5, "dz": 0.25})";

TEST_F(LoadScene, Defaults) {
  const Scene scene = load(with_camera(small_screen));
  EXPECT_EQ(scene.camera.position, glm::dvec3(0, 0, 0));
  EXPECT_EQ(scene.camera.look_at, glm::dvec3(1, 0, 0));
  EXPECT_EQ(scene.camera.up, glm::dvec3(0, 1, 0));
  EXPECT_EQ(scene.camera.screen.columns, 4);
  EXPECT_EQ(scene.camera.screen.rows, 3);
  EXPECT_EQ(scene.camera.screen.dx, 1);
  EXPECT_EQ(scene.camera.screen.dy, 0.5);
  EXPECT_EQ(scene.camera.screen.dz, 0.25);
  EXPECT_EQ(scene.background, glm::dvec3(0, 0, 0));
  EXPECT_FALSE(scene.light);
  EXPECT_TRUE(scene.objects.empty());
  EXPECT_TRUE(scene.warnings.empty());
}

TEST_F(LoadScene, ReadsEverything) {
  write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const Scene scene = load(R"({ // a comment
    "camera": {"position": [1, 2, 3], "look_at": [4, 5, 6], "up": [0, 0, 2],
               "screen": {"columns": 4, "rows": 3, "dx": 2, "dy": 0.5, "dz": 0.25}},
    "background": [0.1, 0.2, 4096], "light": {"ambient": 0.25, "direction": [1, -1, 0.5]},
    "objects": [{"name": "ball", "type": "sphere", "center": [5, 0, 0], "radius": 1.5, "color": [0.9, 0.5, 0.2]},
                {"type": "plane", "normal": [0, 2, 0], "offset": -1, "color": [0, 0, 0]},
                {"type": "triangle", "vertices": [[0, 0, 0], [0, 1, 0], [0, 0, 1]], "color": [1, 1, 1]},
                {"type": "mesh", "file": "m.obj", "color": [1, 0, 0]},
                {"type": "disc", "center": [1, 2, 3], "normal": [0, 3, 0], "radius": 2.5, "color": [1, 0, 0]},
                {"type": "box", "min": [-1, 0, 1], "max": [0, 2, 1.5], "color": [1, 0, 0]},
                {"type": "ellipsoid", "center": [1, 2, 3], "radii": [1, 0.5, 2], "color": [1, 0, 0]},
                {"type": "cylinder", "base": [1, 2, 3], "cap": [3, 2, 1], "radius": 0.5, "color": [1, 0, 0]},
                {"type": "cone", "base": [1, 2, 3], "cap": [3, 2, 1], "base_radius": 0.5, "cap_radius": 0,
                 "capped": false, "color": [1, 0, 0]},
                {"type": "quadric", "coefficients": {"xx": 1, "yz": -2, "z": 3, "constant": -1}, "capped": true,
                 "clip": {"min": [-1, -2, -3], "planes": [{"normal": [0, 2, 0], "offset": 4}]}, "color": [1, 0, 0]},
                {"type": "polygon", "vertices": [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], "color": [1, 0, 0]},
                {"type": "torus", "center": [1, 2, 3], "axis": [0, 2, 0], "major_radius": 2, "minor_radius": 2,
                 "color": [1, 0, 0]}]})");
  EXPECT_EQ(scene.camera.position, glm::dvec3(1, 2, 3));
  EXPECT_EQ(scene.camera.look_at, glm::dvec3(4, 5, 6));
  EXPECT_EQ(scene.camera.up, glm::dvec3(0, 0, 2));
  EXPECT_EQ(scene.background, glm::dvec3(0.1, 0.2, 4096));
  ASSERT_TRUE(scene.light);
  EXPECT_EQ(scene.light->ambient, 0.25);
  EXPECT_EQ(scene.light->direction, glm::dvec3(1, -1, 0.5));
  ASSERT_EQ(scene.objects.size(), 12U);
  EXPECT_EQ(scene.objects[0].name, "ball");
  EXPECT_EQ(scene.objects[0].color, glm::dvec3(0.9, 0.5, 0.2));
  EXPECT_EQ(std::get<Sphere>(scene.objects[0].surface).center, glm::dvec3(5, 0, 0));
  EXPECT_EQ(std::get<Sphere>(scene.objects[0].surface).radius, 1.5);
  EXPECT_EQ(scene.objects[1].name, "");
  EXPECT_EQ(std::get<Plane>(scene.objects[1].surface).normal, glm::dvec3(0, 2, 0));
  EXPECT_EQ(std::get<Plane>(scene.objects[1].surface).offset, -1);
  EXPECT_EQ(std::get<Triangle>(scene.objects[2].surface).vertices[2], glm::dvec3(0, 0, 1));
  EXPECT_EQ(std::get<Mesh>(scene.objects[3].surface).triangles.size(), 1U);
  EXPECT_EQ(std::get<Disc>(scene.objects[4].surface).center, glm::dvec3(1, 2, 3));
  EXPECT_EQ(std::get<Disc>(scene.objects[4].surface).normal, glm::dvec3(0, 3, 0));
  EXPECT_EQ(std::get<Disc>(scene.objects[4].surface).radius, 2.5);
  EXPECT_EQ(std::get<Box>(scene.objects[5].surface).min, glm::dvec3(-1, 0, 1));
  EXPECT_EQ(std::get<Box>(scene.objects[5].surface).max, glm::dvec3(0, 2, 1.5));
  EXPECT_EQ(std::get<Ellipsoid>(scene.objects[6].surface).center, glm::dvec3(1, 2, 3));
  EXPECT_EQ(std::get<Ellipsoid>(scene.objects[6].surface).radii, glm::dvec3(1, 0.5, 2));
  const auto& cylinder = std::get<Cylinder>(scene.objects[7].surface);
  EXPECT_EQ(cylinder.axis.base, glm::dvec3(1, 2, 3));
  EXPECT_EQ(cylinder.axis.cap, glm::dvec3(3, 2, 1));
  EXPECT_EQ(cylinder.radius, 0.5);
  EXPECT_TRUE(cylinder.capped);
  const auto& cone = std::get<Cone>(scene.objects[8].surface);
  EXPECT_EQ(cone.axis.cap, glm::dvec3(3, 2, 1));
  EXPECT_EQ(cone.base_radius, 0.5);
  EXPECT_EQ(cone.cap_radius, 0);
  EXPECT_FALSE(cone.capped);
  const auto& quadric = std::get<Quadric>(scene.objects[9].surface);
  EXPECT_EQ(quadric.coefficients.xx, 1);
  EXPECT_EQ(quadric.coefficients.yy, 0);
  EXPECT_EQ(quadric.coefficients.yz, -2);
  EXPECT_EQ(quadric.coefficients.z, 3);
  EXPECT_EQ(quadric.coefficients.constant, -1);
  EXPECT_TRUE(quadric.capped);
  ASSERT_EQ(quadric.clip.size(), 4U);
  EXPECT_EQ(quadric.clip[1].normal, glm::dvec3(0, -1, 0));
  EXPECT_EQ(quadric.clip[1].offset, 2);
  EXPECT_EQ(quadric.clip[3].normal, glm::dvec3(0, 2, 0));
  EXPECT_EQ(quadric.clip[3].offset, 4);
  EXPECT_EQ(std::get<Polygon>(scene.objects[10].surface).vertices.size(), 4U);
  const auto& torus = std::get<Torus>(scene.objects[11].surface);
  EXPECT_EQ(torus.center, glm::dvec3(1, 2, 3));
  EXPECT_EQ(torus.axis, glm::dvec3(0, 2, 0));
  EXPECT_EQ(torus.major_radius, 2);
  EXPECT_EQ(torus.minor_radius, 2);
}

TEST_F(LoadScene, ReadsLights) {
  const Scene scene = load(with_camera(small_screen, R"("lights": [
      {"type": "ambient", "color": [0.25, 0.5, 1], "intensity": 2},
      {"type": "directional", "direction": [1, -1, 0.5], "color": [1, 1, 0]},
      {"type": "point", "position": [0, 5, 0], "color": [1, 0, 1], "falloff": "quadratic", "intensity": 0.5, "shadow": false},
      {"type": "point", "position": [0, 5, 0], "color": [1, 0, 1]}],
    "objects": [{"type": "sphere", "center": [5, 0, 0], "radius": 1, "color": [1, 1, 1], "shadow": false},
                {"type": "sphere", "center": [5, 0, 0], "radius": 1, "color": [1, 1, 1]}])"));
  EXPECT_FALSE(scene.light);
  ASSERT_TRUE(scene.lights);
  ASSERT_EQ(scene.lights->size(), 4U);
  EXPECT_EQ(std::get<AmbientLight>(scene.lights->at(0)).color, glm::dvec3(0.5, 1, 2));
  const auto& sun = std::get<DirectionalLight>(scene.lights->at(1));
  EXPECT_EQ(sun.direction, glm::dvec3(1, -1, 0.5));
  EXPECT_TRUE(sun.shadow);
  const auto& lamp = std::get<PointLight>(scene.lights->at(2));
  EXPECT_EQ(lamp.position, glm::dvec3(0, 5, 0));
  EXPECT_EQ(lamp.color, glm::dvec3(0.5, 0, 0.5));
  EXPECT_EQ(lamp.falloff, Falloff::quadratic);
  EXPECT_FALSE(lamp.shadow);
  EXPECT_EQ(std::get<PointLight>(scene.lights->at(3)).falloff, Falloff::none);
  EXPECT_TRUE(std::get<PointLight>(scene.lights->at(3)).shadow);
  EXPECT_FALSE(scene.objects[0].casts_shadow);
  EXPECT_TRUE(scene.objects[1].casts_shadow);
}

TEST_F(LoadScene, LightHasNoAmbientByDefault) {
  EXPECT_EQ(load(with_camera(small_screen, R"("light": {"direction": [0, -1, 0]}, "objects": [])")).light->ambient, 0);
}

TEST_F(LoadScene, FieldOfViewGivesSquarePixels) {
  const auto screen = load(with_camera(R"("screen": {"columns": 10, "rows": 3, "horizontal_fov": 90})")).camera.screen;
  EXPECT_EQ(screen.dx, 1);
  EXPECT_DOUBLE_EQ(screen.dz, 2 * std::tan(std::numbers::pi / 4) / 10);
  EXPECT_EQ(screen.dy, screen.dz);
}

TEST_F(LoadScene, ScreensMayHaveOnePixelOrBeVeryWide) {
  EXPECT_EQ(load(with_camera(R"("screen": {"columns": 1, "rows": 1, "horizontal_fov": 60})")).camera.screen.rows, 1);
  EXPECT_EQ(load(with_camera(R"("screen": {"columns": 20000, "rows": 1, "horizontal_fov": 60})")).camera.screen.columns,
            20000);
}

TEST_F(LoadScene, MeshPathsBeginAtTheScenesFolderOrAtTheRoot) {
  std::filesystem::create_directory(folder() / "sub");
  write("sub/m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const auto scene = [&](const std::string& path) {
    return with_camera(small_screen, R"("objects": [{"type": "mesh", "color": [1, 1, 1], "file": ")" + path + R"("}])");
  };
  EXPECT_NO_THROW(load(scene("sub/m.obj")));
  EXPECT_NO_THROW(load(scene((folder() / "sub/m.obj").string())));
}

TEST_F(LoadScene, OneWarningForAllFacesOfAMeshWithoutAnArea) {
  const std::string mesh = write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 1 2\nf 2 2 2\n").string();
  const Scene scene =
      load(with_camera(small_screen, R"("objects": [{"type": "mesh", "color": [1, 1, 1], "file": "m.obj"}])"));
  ASSERT_EQ(scene.warnings.size(), 1U);
  EXPECT_EQ(scene.warnings[0], (folder() / "s.json").string() + ": /objects/0/file: " + mesh +
                                   ": 2 faces without an area were skipped; 1 triangle is left");
}

/// Two faces of two materials in two groups, one face of a third group without a material in front.
class LoadScenesMeshes : public LoadScene {
 protected:
  LoadScenesMeshes() {
    write("m.obj",
          "mtllib m.mtl\nv 5 0 0\nv 5 1 0\nv 5 0 1\nv 5 1 1\nvt 0 0\nvt 1 0\nvt 0 1\nvn -1 0 0\n"
          "f 1/1/1 2/2/1 3/3/1\no a\nusemtl red\nf 1/1/1 2/2/1 3/3/1\no b\nusemtl picture\nf 2/1/1 4/2/1 3/3/1\n"
          "usemtl red\nf 2/1/1 4/2/1 3/3/1\n");
    write("m.mtl", "newmtl red\nKd 1 0 0\nnewmtl picture\nKd 0.5 1 1\nmap_Kd -s 2 4 -o 0.5 0 x.png\n");
    write_image(folder() / "x.png", Image(2, 2));
  }
  Scene mesh(const std::string& more) const {
    return load(with_camera(small_screen, R"("objects": [{"type": "mesh", "file": "m.obj")" + more + "}]"));
  }
  std::string error(const std::string& more) const {
    const std::string message = error_of<InputError>([&] { mesh(more); });
    const std::string file = (folder() / "s.json").string();
    return message.find(file) == 0 ? message.substr(file.size()) : message;
  }
};

std::vector<std::string> names_of(const Scene& scene) {
  std::vector<std::string> names;
  for (const Object& object : scene.objects) names.push_back(object.name);
  return names;
}

TEST_F(LoadScenesMeshes, WithoutAColourMaterialsCount) {
  const Scene scene = mesh(R"(, "name": "tail", "shadow": false, "transform": {"translate": [1, 0, 0]})");
  EXPECT_EQ(names_of(scene), (std::vector<std::string>{"tail", "tail/red", "tail/picture"}));
  EXPECT_EQ(scene.objects[0].color, glm::dvec3(1));
  EXPECT_EQ(scene.objects[1].color, glm::dvec3(1, 0, 0));
  EXPECT_EQ(std::get<Mesh>(scene.objects[1].surface).triangles.size(), 2U);
  EXPECT_EQ(scene.objects[2].color, glm::dvec3(0.5, 1, 1));
  EXPECT_EQ(scene.objects[1].texture, nullptr);
  ASSERT_NE(scene.objects[2].texture, nullptr);
  const Texture& texture = scene.objects[2].texture->texture;
  const TexturePoint cell = texture.cell(0.25, 0.5);  // scaled by 2 and 4, plus 0.5 and 0
  EXPECT_DOUBLE_EQ(cell.u, 1.0);
  EXPECT_DOUBLE_EQ(cell.v, 2.0);
  for (const Object& object : scene.objects) {
    EXPECT_FALSE(object.casts_shadow);
    EXPECT_EQ(std::get<Mesh>(object.surface).vertices[0].x, 6);
    EXPECT_TRUE(std::get<Mesh>(object.surface).places.empty());
    EXPECT_TRUE(std::get<Mesh>(object.surface).normals.empty());
  }
  ASSERT_EQ(scene.warnings.size(), 1U);
  EXPECT_NE(scene.warnings[0].find("faces before the first usemtl are white"), std::string::npos) << scene.warnings[0];
  EXPECT_EQ(scene.files.size(), 4U) << "scene, mesh, library and picture";
}

TEST_F(LoadScenesMeshes, GroupsAreObjects) {
  const Scene scene = mesh(R"(, "name": "tail", "split": "groups", "color": [0, 0, 1], "smooth": true)");
  EXPECT_EQ(names_of(scene), (std::vector<std::string>{"tail", "tail/a", "tail/b"}));
  for (const Object& object : scene.objects) {
    EXPECT_EQ(object.color, glm::dvec3(0, 0, 1));
    EXPECT_FALSE(std::get<Mesh>(object.surface).normals.empty());
  }
  EXPECT_EQ(names_of(mesh(R"(, "split": "groups")")), (std::vector<std::string>{"", "a/red", "b/picture", "b/red"}));
}

TEST_F(LoadScenesMeshes, ATextureIsOnAllParts) {
  const std::string texture = R"(, "texture": {"type": "checker", "colors": [[1, 1, 1], [0, 0, 0]]})";
  const Scene whole = mesh(texture);
  ASSERT_EQ(whole.objects.size(), 1U);
  EXPECT_EQ(whole.objects[0].color, glm::dvec3(1));
  EXPECT_NE(whole.objects[0].texture, nullptr);
  const Scene parts = mesh(texture + R"(, "split": "groups")");
  ASSERT_EQ(parts.objects.size(), 3U);
  for (const Object& object : parts.objects) EXPECT_NE(object.texture, nullptr);
}

TEST_F(LoadScenesMeshes, InstancesHaveTheTexturesAndNormalsOfTheirMesh) {
  const Scene scene =
      load(with_camera(small_screen, R"("shapes": {"s": {"type": "mesh", "file": "m.obj", "smooth": true}},
      "objects": [{"type": "instance", "of": "s", "texture": {"type": "image", "file": "x.png"}}])"));
  EXPECT_NE(scene.objects[0].texture, nullptr);
  EXPECT_FALSE(std::get<MeshInstance>(scene.objects[0].surface).of->mesh.normals.empty());
}

TEST_F(LoadScenesMeshes, Mistakes) {
  const std::string plain = "v 5 0 0\nv 5 1 0\nv 5 0 1\nvn 0 0 0\n";
  const std::string picture = R"(, "texture": {"type": "image", "file": "x.png"})";
  EXPECT_EQ(error(R"(, "split": "parts")"), ": /objects/0/split: \"parts\" is unknown; one of \"groups\" is allowed");
  write("m.obj", plain + "f 1 2 3\n");
  EXPECT_EQ(error(""), ": /objects/0: the key \"color\" is missing; it must be given");
  EXPECT_EQ(
      error(picture),
      ": /objects/0/texture: some faces of the mesh have no texture coordinates (vt) at their corners; faces that "
      "all have them may have textures");
  EXPECT_EQ(
      error(R"(, "color": [1, 1, 1], "smooth": true)"),
      ": /objects/0/smooth: some faces of the mesh have no normals (vn) at their corners; normals of all, or false, "
      "are needed");
  write("m.obj", plain + "f 1//1 2//1 3//1\n");
  EXPECT_EQ(error(R"(, "color": [1, 1, 1], "smooth": true)"),
            ": /objects/0/smooth: a normal of the mesh has no length; normals with a direction, or false, are needed");
  write("m.obj", plain + "mtllib m.mtl\nusemtl picture\nf 1 2 3\n");
  EXPECT_EQ(error("").find(": /objects/0: some faces of the mesh have no texture coordinates"), 0U) << error("");
  write("m.mtl", "newmtl picture\nmap_Kd none.png\n");
  EXPECT_EQ(error("").find(": /objects/0/file: " + (folder() / "m.mtl").string() + ":2: "), 0U) << error("");
  write("m.mtl", "newmtl picture\nmap_Kd x.jpg\n");
  EXPECT_EQ(error(""), ": /objects/0/file: " + (folder() / "m.mtl").string() + ":2: " + (folder() / "x.jpg").string() +
                           " is no PNG file by its name; a file that ends in .png is allowed");
  const auto shape = [&] {
    load(with_camera(small_screen,
                     R"("shapes": {"s": {"type": "mesh", "file": "m.obj", "split": "groups"}}, "objects": [])"));
  };
  EXPECT_NE(error_of<InputError>(shape).find("/shapes/s/split: a shape is one surface; meshes of objects may be split"),
            std::string::npos);
}

/// The unit normal of a mesh's triangle.
glm::dvec3 normal(const Mesh& mesh, std::size_t triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  return glm::normalize(glm::cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]));
}

class ShippedScene : public testing::TestWithParam<const char*> {};

TEST_P(ShippedScene, LoadsWithoutWarnings) {
  const Scene scene = shipped_scene(GetParam());
  EXPECT_FALSE(scene.objects.empty());
  EXPECT_TRUE(scene.warnings.empty());
}

INSTANTIATE_TEST_SUITE_P(All, ShippedScene,
                         testing::Values("keel", "spheres", "fins", "blocks", "quadrics", "shadows", "tori", "bunny",
                                         "horizon", "columns", "runway", "knot", "crystals", "buoys"),
                         [](const auto& parameter) { return std::string(parameter.param); });

TEST(ShippedScenes, KeelsFinAndRudderAreOneFlatObjectEach) {
  const Scene scene = shipped_scene("keel");
  for (const std::size_t i : {0U, 1U}) {
    const auto& mesh = std::get<Mesh>(scene.objects[i].surface);
    const glm::dvec3 first = normal(mesh, 0);
    for (std::size_t t = 1; t < mesh.triangles.size(); ++t) EXPECT_NEAR(glm::dot(first, normal(mesh, t)), 1, 1e-9);
  }
}

TEST(ShippedScenes, SpheresAreFiftyOverTwoAndAHalfDecades) {
  const Scene scene = shipped_scene("spheres");
  EXPECT_EQ(scene.objects.size(), 50U);
  double smallest = 1e30;
  double largest = 0;
  for (const Object& object : scene.objects) {
    const double radius = std::get<Sphere>(object.surface).radius;
    smallest = std::min(smallest, radius);
    largest = std::max(largest, radius);
  }
  EXPECT_GE(largest / smallest, std::pow(10, 2.5));
}

TEST(ShippedScenes, FinsAreSliversWithoutLight) {
  const Scene scene = shipped_scene("fins");
  EXPECT_EQ(scene.objects.size(), 24U);
  EXPECT_FALSE(scene.light);
}

TEST(ShippedScenes, BunnyHasAllItsTriangles) {
  EXPECT_EQ(std::get<Mesh>(shipped_scene("bunny").objects[0].surface).triangles.size(), 69666U);
}

}  // namespace
}  // namespace pyrasim
