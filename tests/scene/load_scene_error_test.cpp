// SPDX-License-Identifier: Apache-2.0
// Every mistake that a scene file can have, and the line that it becomes.
#include <nlohmann/json.hpp>
#include <string>

#include "../error_of.h"
#include "../temp_folder.h"
#include "error.h"
#include "scene/load_scene.h"

namespace pyrasim {
namespace {

using nlohmann::json;

class LoadSceneError : public TempFolderTest {
 protected:
  /// The message for a scene text, without the file's path in front.
  std::string text_error(const std::string& text) const {
    const std::string file = write("s.json", text).string();
    const std::string message = error_of<InputError>([&] { load_scene(file); });
    return message.find(file) == 0 ? message.substr(file.size()) : message;
  }

  /// The message for a good scene whose value at `pointer` is `value`, given as JSON.
  std::string error_with(const std::string& pointer, const std::string& value) const {
    json scene = good_scene();
    scene[json::json_pointer(pointer)] = json::parse(value);
    return text_error(scene.dump());
  }

  /// The message for a good scene without the member `key` of the object at `pointer`.
  std::string error_without(const std::string& pointer, const std::string& key) const {
    json scene = good_scene();
    scene[json::json_pointer(pointer)].erase(key);
    return text_error(scene.dump());
  }

  static json good_scene() {
    return json::parse(R"({
      "camera": {"position": [0, 0, 0], "look_at": [1, 0, 0], "up": [0, 1, 0],
                 "screen": {"columns": 4, "rows": 3, "dx": 1, "dy": 0.5, "dz": 0.5}},
      "background": [0, 0, 0], "light": {"ambient": 0.2, "direction": [1, -1, 0]},
      "objects": [{"name": "ball", "type": "sphere", "center": [5, 0, 0], "radius": 1.5, "color": [1, 1, 1]},
                  {"type": "plane", "normal": [0, 1, 0], "offset": -1, "color": [1, 1, 1]},
                  {"type": "triangle", "vertices": [[0, 0, 0], [0, 1, 0], [0, 0, 1]], "color": [1, 1, 1]}]})");
  }
};

TEST_F(LoadSceneError, TheGoodSceneIsGood) { EXPECT_EQ(text_error(good_scene().dump()), "(no error)"); }

TEST_F(LoadSceneError, UnknownKeys) {
  EXPECT_EQ(error_with("/lamps", "[]"),
            ": /lamps: unknown key; allowed keys: camera, background, light, lights, shapes, objects");
  EXPECT_EQ(error_with("/camera/fov", "1"), ": /camera/fov: unknown key; allowed keys: position, look_at, up, screen");
  EXPECT_EQ(error_with("/camera/screen/width", "1"),
            ": /camera/screen/width: unknown key; allowed keys: columns, rows, dx, dy, dz, horizontal_fov");
  EXPECT_EQ(error_with("/light/color", "1"), ": /light/color: unknown key; allowed keys: ambient, direction");
  EXPECT_EQ(
      error_with("/objects/0/normal", "1"),
      ": /objects/0/normal: unknown key; allowed keys: name, type, color, shadow, transform, texture, center, radius");
  EXPECT_EQ(
      error_with("/objects/1/radius", "1"),
      ": /objects/1/radius: unknown key; allowed keys: name, type, color, shadow, transform, texture, normal, offset");
  EXPECT_EQ(error_with("/objects/2/radius", "1"),
            ": /objects/2/radius: unknown key; allowed keys: name, type, color, shadow, transform, texture, vertices");
  EXPECT_EQ(error_with("/objects/0", R"({"type": "mesh", "file": "m.obj", "color": [1, 1, 1], "x": 0})"),
            ": /objects/0/x: unknown key; allowed keys: name, type, color, shadow, transform, texture, file, smooth, "
            "split");
}

/// The message for lights in place of the good scene's light.
TEST_F(LoadSceneError, Lights) {
  const auto with_lights = [&](const std::string& lights) {
    json scene = good_scene();
    scene.erase("light");
    scene["lights"] = json::parse(lights);
    return text_error(scene.dump());
  };
  EXPECT_EQ(with_lights("[]"), "(no error)");
  EXPECT_EQ(error_with("/lights", "[]"), ": /lights: it is given beside light; either light or lights is allowed");
  EXPECT_EQ(with_lights(R"([{"type": "sun", "color": [1, 1, 1]}])"),
            ": /lights/0/type: \"sun\" is unknown; one of \"ambient\", \"directional\", \"point\" is allowed");
  EXPECT_EQ(with_lights(R"([{"type": "ambient"}])"), ": /lights/0: the key \"color\" is missing; it must be given");
  EXPECT_EQ(with_lights(R"([{"type": "ambient", "color": [1, 1, 1], "shadow": true}])"),
            ": /lights/0/shadow: unknown key; allowed keys: type, color, intensity");
  EXPECT_EQ(with_lights(R"([{"type": "directional", "color": [1, 1, 1], "direction": [0, 0, 0]}])"),
            ": /lights/0/direction: the vector is zero; a component of at least 1e-30 in magnitude is needed");
  EXPECT_EQ(with_lights(R"([{"type": "point", "color": [1, 1, -1], "position": [0, 0, 0]}])"),
            ": /lights/0/color/2: -1 is out of range; a number from 0 to 4096 is allowed");
  EXPECT_EQ(with_lights(R"([{"type": "point", "color": [1, 1, 1], "position": [0, 0, 0], "falloff": "cubic"}])"),
            ": /lights/0/falloff: \"cubic\" is unknown; one of \"none\", \"linear\", \"quadratic\" is allowed");
  EXPECT_EQ(error_with("/objects/0/shadow", "1"), ": /objects/0/shadow: it is the number 1; true or false is allowed");
}

/// A sample has a bit for each light with shadows; of others there may be any number.
TEST_F(LoadSceneError, TooManyLightsWithShadows) {
  const auto with_lights = [&](std::size_t count, bool shadow) {
    json scene = good_scene();
    scene.erase("light");
    const json light{{"type", "point"}, {"color", {1, 1, 1}}, {"position", {0, 9, 0}}, {"shadow", shadow}};
    for (std::size_t k = 0; k < count; ++k) scene["lights"].push_back(light);
    return text_error(scene.dump());
  };
  EXPECT_EQ(with_lights(max_shadow_lights, true), "(no error)");
  EXPECT_EQ(with_lights(100'000, false), "(no error)");
  EXPECT_EQ(with_lights(max_shadow_lights + 1, true),
            ": /lights/32: there are too many lights with shadows; at most 32 are allowed, and any number with "
            "\"shadow\": false");
}

TEST_F(LoadSceneError, MissingKeys) {
  for (const char* key : {"camera", "objects"}) {
    EXPECT_EQ(error_without("", key), std::string(": (root): the key \"") + key + "\" is missing; it must be given");
  }
  EXPECT_EQ(error_without("/camera", "screen"), ": /camera: the key \"screen\" is missing; it must be given");
  for (const char* key : {"columns", "rows", "dx", "dy", "dz"}) {
    EXPECT_EQ(error_without("/camera/screen", key),
              std::string(": /camera/screen: the key \"") + key + "\" is missing; it must be given");
  }
  EXPECT_EQ(
      error_with("/camera/screen", R"({"columns": 4, "rows": 3})"),
      ": /camera/screen: the size of the pixels is missing; either horizontal_fov or dx, dy and dz must be given");
  EXPECT_EQ(error_without("/light", "direction"), ": /light: the key \"direction\" is missing; it must be given");
  for (const char* key : {"type", "center", "radius", "color"}) {
    EXPECT_EQ(error_without("/objects/0", key),
              std::string(": /objects/0: the key \"") + key + "\" is missing; it must be given");
  }
  for (const char* key : {"normal", "offset"}) {
    EXPECT_EQ(error_without("/objects/1", key),
              std::string(": /objects/1: the key \"") + key + "\" is missing; it must be given");
  }
  EXPECT_EQ(error_without("/objects/2", "vertices"), ": /objects/2: the key \"vertices\" is missing; it must be given");
  EXPECT_EQ(error_with("/objects/0", R"({"type": "mesh", "color": [1, 1, 1]})"),
            ": /objects/0: the key \"file\" is missing; it must be given");
}

TEST_F(LoadSceneError, DuplicateKeys) {
  EXPECT_EQ(text_error(R"({"objects": [{"type": "sphere", "radius": 1, "radius": 1}]})"),
            ": /objects/0/radius: the key appears twice; a key is allowed once in its object");
}

TEST_F(LoadSceneError, NoJson) {
  EXPECT_EQ(text_error("{\n\"camera\" 1}").find(":2:10: syntax error"), 0U) << text_error("{\n\"camera\" 1}");
  EXPECT_EQ(text_error("[]"), ": (root): it is an array; an object is allowed");
}

TEST_F(LoadSceneError, WrongTypes) {
  EXPECT_EQ(error_with("/camera", "[]"), ": /camera: it is an array; an object is allowed");
  EXPECT_EQ(error_with("/objects", "{}"), ": /objects: it is an object; an array is allowed");
  EXPECT_EQ(error_with("/objects/1", "7"), ": /objects/1: it is the number 7; an object is allowed");
  EXPECT_EQ(error_with("/objects/0/name", "7"), ": /objects/0/name: it is the number 7; a string is allowed");
  EXPECT_EQ(error_with("/objects/0/radius", "\"1\""),
            ": /objects/0/radius: it is the string \"1\"; a number from 1e-30 to 1e+30 is allowed");
  EXPECT_EQ(error_with("/objects/0/center", "[1, 2]"),
            ": /objects/0/center: it has 2 elements; an array of 3 numbers is allowed");
  EXPECT_EQ(error_with("/objects/0/type", "\"cube\""),
            ": /objects/0/type: \"cube\" is unknown; one of \"sphere\", \"plane\", \"triangle\", \"mesh\", \"disc\", "
            "\"box\", \"ellipsoid\", \"cylinder\", \"cone\", \"quadric\", "
            "\"polygon\", \"torus\", \"instance\" is allowed");
  EXPECT_EQ(error_with("/objects/2/vertices", "[[0, 0, 0], [1, 1, 1]]"),
            ": /objects/2/vertices: it has 2 elements; an array of 3 elements is allowed");
  EXPECT_EQ(error_with("/light", "null"), ": /light: it is null; an object is allowed");
}

TEST_F(LoadSceneError, BoxesWithoutVolume) {
  for (const std::string max : {"[0, 1, 1]", "[1, -1, 1]", "[1, 1, 0]"}) {
    const std::string box = R"({"type": "box", "min": [0, 0, 0], "color": [1, 1, 1], "max": )" + max + "}";
    EXPECT_EQ(error_with("/objects/0", box),
              ": /objects/0/max: the box has no volume; each component has to be larger than that of min");
  }
}

TEST_F(LoadSceneError, DiscsWithoutNormalOrRadius) {
  const std::string disc = R"({"type": "disc", "center": [0, 0, 0], "color": [1, 1, 1], )";
  EXPECT_EQ(error_with("/objects/0", disc + R"("normal": [0, 0, 0], "radius": 1})").find(": /objects/0/normal: "), 0U);
  EXPECT_EQ(error_with("/objects/0", disc + R"("normal": [0, 0, 1], "radius": 0})").find(": /objects/0/radius: "), 0U);
}

TEST_F(LoadSceneError, ToriThatMeetThemselvesOrHaveNoAxis) {
  const std::string torus = R"({"type": "torus", "center": [0, 0, 0], "color": [1, 1, 1], )";
  EXPECT_EQ(error_with("/objects/0", torus + R"("axis": [0, 0, 1], "major_radius": 1, "minor_radius": 1.5})"),
            ": /objects/0/minor_radius: 1.5 is more than major_radius, and the tube would meet itself; at most 1 is "
            "allowed");
  EXPECT_EQ(error_with("/objects/0", torus + R"("axis": [0, 0, 0], "major_radius": 2, "minor_radius": 1})")
                .find(": /objects/0/axis: "),
            0U);
  EXPECT_EQ(error_with("/objects/0", torus + R"("axis": [0, 0, 1], "major_radius": 2, "minor_radius": 0})")
                .find(": /objects/0/minor_radius: "),
            0U);
}

TEST_F(LoadSceneError, EllipsoidsWithoutRadii) {
  EXPECT_EQ(
      error_with("/objects/0", R"({"type": "ellipsoid", "center": [0, 0, 0], "color": [1, 1, 1], "radii": [1, 0, 1]})"),
      ": /objects/0/radii/1: 0 is out of range; a number from 1e-30 to 1e+30 is allowed");
}

TEST_F(LoadSceneError, ConesAndCylindersWithoutExtent) {
  const std::string cylinder = R"({"type": "cylinder", "base": [1, 0, 0], "cap": [1, 0, 0], "color": [1, 1, 1], )";
  EXPECT_EQ(error_with("/objects/0", cylinder + R"("radius": 1})"),
            ": /objects/0/cap: it is where base is; a point at least 1e-30 away is needed");
  const std::string cone = R"({"type": "cone", "base": [1, 0, 0], "cap": [1, 1, 0], "color": [1, 1, 1], )";
  EXPECT_EQ(error_with("/objects/0", cone + R"("base_radius": 0, "cap_radius": 0})"),
            ": /objects/0/cap_radius: it is 0, and so is base_radius; one of the two may be 0");
  EXPECT_EQ(error_with("/objects/0", cone + R"("base_radius": 1e-40, "cap_radius": 1})"),
            ": /objects/0/base_radius: 1e-40 is too small; 0 or at least 1e-30 is allowed");
  EXPECT_EQ(error_with("/objects/0", cone + R"("base_radius": 1, "cap_radius": 1, "capped": 1})"),
            ": /objects/0/capped: it is the number 1; true or false is allowed");
}

TEST_F(LoadSceneError, QuadricsWithoutSquaresOrSpace) {
  const std::string quadric = R"({"type": "quadric", "color": [1, 1, 1], "coefficients": )";
  EXPECT_EQ(
      error_with("/objects/0", quadric + R"({"x": 1}})"),
      ": /objects/0/coefficients: no square is left; one of xx, yy, zz, xy, xz and yz has to be at least 1e-60 in "
      "magnitude");
  EXPECT_EQ(error_with("/objects/0", quadric + R"({"xx": 1}, "clip": {"min": [1, 0, 0], "max": [0, 1, 1]}})"),
            ": /objects/0/clip: nothing is left; the half-spaces have to have a point in common");
  EXPECT_EQ(error_with("/objects/0", quadric + R"({"xx": 1}, "clip": {"min": [0, 0, 0], "max": [0, 1, 1]}})"),
            ": /objects/0/clip: what is left is flat; half-spaces that have a volume in common are allowed");
  const std::string plane = R"({"normal": [1, 0, 0], "offset": 1})";
  EXPECT_EQ(
      error_with("/objects/0", quadric + R"({"xx": 1}, "clip": {"min": [0, 0, 0], "max": [1, 1, 1], "planes": [)" +
                                   plane + ", " + plane + ", " + plane + "]}}"),
      ": /objects/0/clip/planes: it has 3 elements; an array of 0 to 2 elements is allowed");
  EXPECT_EQ(error_with("/objects/0", quadric + R"({"xx": 1, "zx": 1}})").find(": /objects/0/coefficients/zx: "), 0U);
}

TEST_F(LoadSceneError, PolygonsThatAreNotFlatAndConvex) {
  const auto error = [&](const std::string& vertices) {
    return error_with("/objects/0", R"({"type": "polygon", "color": [1, 1, 1], "vertices": [)" + vertices + "]}");
  };
  const std::string at = ": /objects/0/vertices: ";
  EXPECT_EQ(error("[0, 0, 0], [1, 0, 0]"), at + "it has 2 elements; an array of 3 to 4096 elements is allowed");
  EXPECT_EQ(error("[0, 0, 0], [1, 0, 0], [2, 0, 0]"),
            at + "the polygon has no area; vertices that are not on one line, once around, are needed");
  EXPECT_EQ(error("[0, 0, 0], [2, 0, 0], [2, 2, 0.5], [0, 2, 0]").substr(0, at.size() + 7), at + "vertex ");
  EXPECT_EQ(error("[0, 0, 0], [2, 0, 0], [0.5, 0.5, 0], [0, 2, 0]"),
            at + "the polygon is bent inwards at vertex 2; a convex polygon is needed");
  EXPECT_EQ(error("[0, 0, 0], [2, 0, 0], [2, 0, 0], [0, 2, 0]"),
            at + "vertex 1 is repeated; vertices have to lie apart");
  EXPECT_EQ(error("[0, 1, 0], [0.588, -0.809, 0], [-0.951, 0.309, 0], [0.951, 0.309, 0], [-0.588, -0.809, 0]"),
            at + "the polygon goes around more than once; a convex polygon is needed");
}

TEST_F(LoadSceneError, NumbersThatAreNotFinite) {
  EXPECT_EQ(text_error(R"({"background": [0, 1e999, 0]})"),
            ": /background/1: the number 1e999 is too large; a magnitude of at most 1.797e308 is allowed");
  EXPECT_EQ(text_error("{\"background\": [NaN]}"), ":1:17: NaN is not a JSON number; a finite number is allowed");
  EXPECT_EQ(text_error(R"({"camera": {"position": [0, -1e400, 0]}})"),
            ": /camera/position/1: the number -1e400 is too large; a magnitude of at most 1.797e308 is allowed");
  for (const std::string name : {"Infinity", "-Infinity"}) {
    EXPECT_EQ(text_error("{\"background\": [" + name + "]}"),
              ":1:17: " + name + " is not a JSON number; a finite number is allowed");
  }
}

TEST_F(LoadSceneError, Coordinates) {
  const std::string allowed = ": 1e+31 is out of range; a number from -1e+30 to 1e+30 is allowed";
  EXPECT_EQ(error_with("/objects/0/center/1", "1e31"), ": /objects/0/center/1" + allowed);
  EXPECT_EQ(error_with("/objects/1/offset", "1e31"), ": /objects/1/offset" + allowed);
  EXPECT_EQ(error_with("/objects/2/vertices/1/2", "1e31"), ": /objects/2/vertices/1/2" + allowed);
  EXPECT_EQ(error_with("/camera/position/0", "1e31"), ": /camera/position/0" + allowed);
  for (const std::string pointer : {"/objects/0/center/1", "/objects/1/offset", "/camera/position/0"}) {
    EXPECT_EQ(error_with(pointer, "5e-324"), "(no error)");  // subnormal coordinates do no harm
  }
}

TEST_F(LoadSceneError, Lengths) {
  for (const std::string value : {"0", "-1.5", "5e-324"}) {
    const std::string wrong =
        ": " + json::parse(value).dump() + " is out of range; a number from 1e-30 to 1e+30 is allowed";
    EXPECT_EQ(error_with("/objects/0/radius", value), ": /objects/0/radius" + wrong);
    EXPECT_EQ(error_with("/camera/screen/dx", value), ": /camera/screen/dx" + wrong);
    EXPECT_EQ(error_with("/camera/screen/dy", value), ": /camera/screen/dy" + wrong);
    EXPECT_EQ(error_with("/camera/screen/dz", value), ": /camera/screen/dz" + wrong);
  }
}

TEST_F(LoadSceneError, Directions) {
  const std::string wrong = ": the vector is zero; a component of at least 1e-30 in magnitude is needed";
  for (const std::string pointer : {"/objects/1/normal", "/light/direction", "/camera/up"}) {
    EXPECT_EQ(error_with(pointer, "[0, 0, 0]"), ": " + pointer + wrong);
    EXPECT_EQ(error_with(pointer, "[0, 1e-200, 0]"), ": " + pointer + wrong);
    EXPECT_EQ(error_with(pointer, "[5e-324, -5e-324, 0]"), ": " + pointer + wrong);
  }
}

TEST_F(LoadSceneError, CamerasWithoutAFrame) {
  EXPECT_EQ(error_with("/camera/look_at", "[0, 0, 0]"),
            ": /camera: look_at is the same point as position; two different points are needed");
  for (const char* up : {"[1, 0, 0]", "[-3, 0, 0]", "[1, 1e-12, 0]"}) {
    EXPECT_EQ(
        error_with("/camera/up", up),
        ": /camera: up is parallel to the viewing direction; an angle between them other than 0 and 180 is needed");
  }
  EXPECT_EQ(error_with("/camera/up", "[1, 1e-6, 0]"), "(no error)");
}

TEST_F(LoadSceneError, ScreenSizes) {
  for (const std::string key : {"columns", "rows"}) {
    for (const std::string value : {"0", "-1", "65536"}) {
      EXPECT_EQ(error_with("/camera/screen/" + key, value),
                ": /camera/screen/" + key + ": " + value + " is out of range; an integer from 1 to 65535 is allowed");
    }
    EXPECT_EQ(error_with("/camera/screen/" + key, "1.5"),
              ": /camera/screen/" + key + ": it is the number 1.5; an integer from 1 to 65535 is allowed");
    EXPECT_EQ(error_with("/camera/screen/" + key, "65535"), "(no error)");
  }
}

TEST_F(LoadSceneError, FieldOfView) {
  for (const std::string value : {"0", "180", "-20", "200"}) {
    EXPECT_EQ(error_with("/camera/screen", R"({"columns": 4, "rows": 3, "horizontal_fov": )" + value + "}"),
              ": /camera/screen/horizontal_fov: " + value +
                  " is out of range; a number between 0 and 180, neither included, is allowed");
  }
  EXPECT_EQ(error_with("/camera/screen/horizontal_fov", "60"),
            ": /camera/screen/dx: it is given beside horizontal_fov; "
            "either horizontal_fov or dx, dy and dz is allowed");
  EXPECT_EQ(error_with("/camera/screen", R"({"columns": 4, "rows": 3, "horizontal_fov": 1e-40})"),
            ": /camera/screen/horizontal_fov: the angle is too small; pixels of at least 1e-30 are needed");
}

TEST_F(LoadSceneError, Colors) {
  for (const std::string pointer : {"/background", "/objects/0/color", "/objects/1/color", "/objects/2/color"}) {
    EXPECT_EQ(error_with(pointer, "[0, 0, -0.5]"),
              ": " + pointer + "/2: -0.5 is out of range; a number from 0 to 4096 is allowed");
    EXPECT_EQ(error_with(pointer, "[4097, 0, 0]"),
              ": " + pointer + "/0: 4097 is out of range; a number from 0 to 4096 is allowed");
  }
  EXPECT_EQ(error_with("/light/ambient", "1.5"),
            ": /light/ambient: 1.5 is out of range; a number from 0 to 1 is allowed");
}

TEST_F(LoadSceneError, TrianglesWithoutArea) {
  const std::string wrong = ": /objects/2/vertices: the triangle has no area; three points not on one line are needed";
  EXPECT_EQ(error_with("/objects/2/vertices", "[[1, 2, 3], [1, 2, 3], [4, 5, 7]]"), wrong);
  EXPECT_EQ(error_with("/objects/2/vertices", "[[0, 0, 0], [0.1, 0.7, 0], [0.3, 2.1, 0]]"), wrong);
  EXPECT_EQ(error_with("/objects/2/vertices", "[[0, 0, 0], [1e-30, 0, 0], [0, 1e-30, 0]]"), "(no error)");
}

TEST_F(LoadSceneError, Meshes) {
  const auto mesh_error = [&](const std::string& file) {
    return error_with("/objects/2", R"({"type": "mesh", "color": [1, 1, 1], "file": ")" + file + "\"}");
  };
  const std::string mesh = write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 4\n").string();
  EXPECT_EQ(mesh_error("m.obj"),
            ": /objects/2/file: " + mesh +
                ":5: the index 4 selects no vertex; 1 to 3, or -1 to -3 counted back from the last, is allowed");
  EXPECT_EQ(mesh_error("none.obj"), ": /objects/2/file: " + (folder() / "none.obj").string() +
                                        ": cannot be read: No such file or directory; a readable OBJ file is allowed");
  EXPECT_EQ(mesh_error(""),
            ": /objects/2/file: the path is empty or holds a null character; the path of an OBJ file is allowed");
}

TEST_F(LoadSceneError, MissingFile) {
  const std::string file = (folder() / "none.json").string();
  EXPECT_EQ(error_of<InputError>([&] { load_scene(file); }),
            file + ": cannot be read: No such file or directory; a readable JSON file is allowed");
}

}  // namespace
}  // namespace pyrasim
