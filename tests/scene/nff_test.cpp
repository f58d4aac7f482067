// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>
#include <string>
#include <variant>
#include <vector>

#include "../error_of.h"
#include "../temp_folder.h"
#include "camera/observer_frame.h"
#include "error.h"
#include "scene/load_scene.h"

namespace pyrasim {
namespace {

const std::string view = "v\nfrom 0 -5 0\nat 0 0 0\nup 0 0 1\nangle 90\nhither 1\nresolution 8 4\n";  // 7 lines
const std::string white = "f 1 1 1 1 0 0 0 1\n";                                                      // line 8
const std::string square = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

class LoadNff : public TempFolderTest {
 protected:
  Scene load(const std::string& text) const { return load_scene(write("s.nff", text)); }

  /// The objects of a good view and a white material with `commands` behind them.
  std::vector<Object> objects(const std::string& commands) const { return load(view + white + commands).objects; }

  /// The message for a text, without the file's path in front.
  std::string text_error(const std::string& text) const {
    const std::string file = write("s.nff", text).string();
    const std::string message = error_of<InputError>([&] { load_scene(file); });
    return message.find(file) == 0 ? message.substr(file.size()) : message;
  }

  /// The message for `commands` from line 9 on.
  std::string error(const std::string& commands) const { return text_error(view + white + commands); }

  /// The message for a good view whose line with `from` reads `to` instead.
  std::string view_error(const std::string& from, const std::string& to) const {
    std::string text = view;
    return text_error(text.replace(text.find(from), from.size(), to));
  }

  std::string warnings(const std::string& commands) const {
    std::string lines;
    const Scene scene = load(view + white + commands);
    for (const std::string& warning : scene.warnings) {
      lines += warning.substr((folder() / "s.nff").string().size()) + "\n";
    }
    return lines;
  }
};

template <class Surface>
const Surface& surface(const std::vector<Object>& objects, std::size_t k = 0) {
  return std::get<Surface>(objects.at(k).surface);
}

TEST_F(LoadNff, ReadsTheView) {
  const Scene scene = load("v\nfrom 1 2 3\nat 4 5 6\nup 0 0 2\nangle 60\nhither 0.1\nresolution 8 4\n");
  EXPECT_EQ(scene.camera.position, glm::dvec3(1, 2, 3));
  EXPECT_EQ(scene.camera.look_at, glm::dvec3(4, 5, 6));
  EXPECT_EQ(scene.camera.up, glm::dvec3(0, 0, 2));
  const Screen& screen = scene.camera.screen;
  EXPECT_EQ(screen.columns, 8);
  EXPECT_EQ(screen.rows, 4);
  const double side = 2 / std::numbers::sqrt3;
  EXPECT_NEAR(screen.columns * screen.dz / screen.dx, side, 1e-15);
  EXPECT_NEAR(screen.rows * screen.dy / screen.dx, side, 1e-15);
  EXPECT_EQ(scene.background, glm::dvec3(0));
  EXPECT_FALSE(scene.light);
  EXPECT_FALSE(scene.lights);
  EXPECT_TRUE(scene.warnings.empty());
  EXPECT_EQ(scene.files, std::vector{(folder() / "s.nff").string()});
}

TEST_F(LoadNff, IsRightHanded) {
  const ObserverFrame frame(load(view).camera);
  EXPECT_EQ(frame.point({0, 1, 0}), glm::dvec3(6, 0, 0));
  EXPECT_EQ(frame.point({1, 0, 0}), glm::dvec3(5, 0, 1));  // to the right
  EXPECT_EQ(frame.point({0, 0, 1}), glm::dvec3(5, 1, 0));
}

TEST_F(LoadNff, ReadsBackgroundAndLights) {
  const Scene scene = load(view + "b 0.1 0.2 0.3\nl 1 2 3\nl 4 5 6 0.5 1 2\nl 7 8 9\nl 0 0 0\n");
  EXPECT_EQ(scene.background, glm::dvec3(0.1, 0.2, 0.3));
  ASSERT_TRUE(scene.lights);
  ASSERT_EQ(scene.lights->size(), 4U);
  const auto& first = std::get<PointLight>(scene.lights->at(0));
  EXPECT_EQ(first.position, glm::dvec3(1, 2, 3));
  EXPECT_EQ(first.color, glm::dvec3(0.5));  // one over the square root of four
  EXPECT_EQ(first.falloff, Falloff::none);
  EXPECT_TRUE(first.shadow);
  EXPECT_EQ(std::get<PointLight>(scene.lights->at(1)).color, glm::dvec3(0.5, 1, 2));
}

TEST_F(LoadNff, ColorsAreTimesKd) {
  const std::vector<Object> read = objects("s 0 0 0 1\nf 0.5 1 0.25 0.5 0.9 37 0 1.5\ns 0 0 0 2\ns 0 0 0 3\n");
  ASSERT_EQ(read.size(), 3U);
  EXPECT_EQ(read[0].color, glm::dvec3(1));
  EXPECT_EQ(read[1].color, glm::dvec3(0.25, 0.5, 0.125));
  EXPECT_EQ(read[2].color, read[1].color);
  EXPECT_TRUE(read[0].casts_shadow);
}

TEST_F(LoadNff, ReadsSpheresConesAndCylinders) {
  const std::vector<Object> read =
      objects("s 1 2 3 0.5\nc\n0 0 0 1\n0 0 2 0.5\nc 0 0 0 1 0 0 2 1\nc\n1 0 0 0\n0 0 2 1\n");
  EXPECT_EQ(surface<Sphere>(read).center, glm::dvec3(1, 2, 3));
  EXPECT_EQ(surface<Sphere>(read).radius, 0.5);
  const auto& cone = surface<Cone>(read, 1);
  EXPECT_EQ(cone.axis.base, glm::dvec3(0));
  EXPECT_EQ(cone.axis.cap, glm::dvec3(0, 0, 2));
  EXPECT_EQ(cone.base_radius, 1);
  EXPECT_EQ(cone.cap_radius, 0.5);
  EXPECT_FALSE(cone.capped);
  const auto& cylinder = surface<Cylinder>(read, 2);
  EXPECT_EQ(cylinder.axis.cap, glm::dvec3(0, 0, 2));
  EXPECT_EQ(cylinder.radius, 1);
  EXPECT_FALSE(cylinder.capped);
  EXPECT_EQ(surface<Cone>(read, 3).base_radius, 0);
}

TEST_F(LoadNff, ReadsPolygons) {
  const std::vector<Object> read = objects("p 3\n0 0 0\n1 0 0\n0 1 0\np 4\n" + square +
                                           "p 4\n0 0 0\n1 0 0\n0.1 0.1 0\n0 1 0\n"  // bent inwards
                                           "p 4\n0 0 0\n1 0 0\n1 1 0.5\n0 1 0\n"    // bent out of its plane
                                           "p 5\n" +
                                           square + "0 0 0\n");  // closed once more
  EXPECT_EQ(surface<Triangle>(read).vertices[1], glm::dvec3(1, 0, 0));
  EXPECT_EQ(surface<Polygon>(read, 1).vertices.size(), 4U);
  for (const std::size_t k : {2, 3, 4}) EXPECT_EQ(surface<Mesh>(read, k).triangles.size(), 2U) << k;
}

TEST_F(LoadNff, ReadsPatchesWithoutTheirNormals) {
  const std::vector<Object> read = objects(
      "pp 3\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 1 1\npp 4\n0 0 0 0 0 1\n1 0 0 0 0 1\n1 1 0 0 0 1\n0 1 0 1 0 1\n");
  EXPECT_EQ(surface<Triangle>(read).vertices[2], glm::dvec3(0, 1, 0));
  EXPECT_EQ(surface<Polygon>(read, 1).vertices[3], glm::dvec3(0, 1, 0));
}

TEST_F(LoadNff, ReadsLinesOfAnyShape) {
  const std::vector<Object> read = objects(
      "# a comment\r\n\r\n  s 1 2 # here\r\n 3\t0.5 \r\np 3 0 0 0\n\n1 0 0 # s 0 0 0 1\n0\n1\n0\ns +1 2. 3e0 .5");
  ASSERT_EQ(read.size(), 3U);
  EXPECT_EQ(surface<Sphere>(read).radius, 0.5);
  EXPECT_EQ(surface<Triangle>(read, 1).vertices[2], glm::dvec3(0, 1, 0));
  EXPECT_EQ(surface<Sphere>(read, 2).center, glm::dvec3(1, 2, 3));
  EXPECT_TRUE(load("\xef\xbb\xbf" + view).objects.empty());
}

TEST_F(LoadNff, WarnsOnceOfEachThing) {
  EXPECT_EQ(warnings("f 1 1 1 0.1 0.9 3 0.9 1.5\nf 1 1 1 1 1 0 1e-3 1\ns 0 0 0 1\n"),
            ": 2 of 3 materials transmit light (T above 0); they are opaque here\n");
  EXPECT_EQ(warnings("p 3\n0 0 0\n1 0 0\n2 0 0\np 4\n0 0 0\n0 0 0\n1 1 1\n1 1 1\ns 0 0 0 1\n"),
            ": 2 polygons without an area were skipped; 1 object is left\n");
  EXPECT_EQ(warnings("p 4\n0 0 0\n1 1 0\n1 0 0\n0 1 0\n"),
            ": 1 polygon crosses or covers itself, it is in line 13; what it encloses is not defined, and any "
            "triangles may be seen\n");
}

TEST_F(LoadNff, MistakesOfTheView) {
  EXPECT_EQ(text_error("b 0 0 0\n"), ": it has no view; the command v is needed");
  EXPECT_EQ(text_error(""), ": it has no view; the command v is needed");
  EXPECT_EQ(text_error("v\nfrom 0 0 0\n"), ":2: the file ends within \"v\"; its \"at\" is needed");
  EXPECT_EQ(text_error(view + view), ":8: it is the second view; one is allowed");
  EXPECT_EQ(view_error("at 0 0 0", "up 0 0 0"),
            ":3: \"up\" stands where \"at\" has to; from, at, up, angle, hither, resolution is the order");
  EXPECT_EQ(view_error("at 0 0 0", "at 0 -5 0"), ":4: at is the same point as from; two different points are needed");
  EXPECT_EQ(view_error("up 0 0 1", "up 0 2 0"),
            ":4: up is zero or parallel to the viewing direction; any other direction is allowed");
  EXPECT_EQ(view_error("up 0 0 1", "up 0 0 0"),
            ":4: up is zero or parallel to the viewing direction; any other direction is allowed");
  EXPECT_EQ(view_error("angle 90", "angle 180"),
            ":5: \"180\" is no angle; a number between 0 and 180, neither included, is allowed");
  EXPECT_EQ(view_error("angle 90", "angle 1e-300"), ":7: the angle is too small; pixels of at least 1e-30 are needed");
  EXPECT_EQ(view_error("8 4", "8 0"), ":7: \"0\" is no number of rows; an integer from 1 to 65535 is allowed");
  EXPECT_EQ(view_error("8 4", "8.5 4"), ":7: \"8.5\" is no number of columns; an integer from 1 to 65535 is allowed");
}

TEST_F(LoadNff, MistakesOfCommands) {
  EXPECT_EQ(error("k 1\n"), ":9: \"k\" is no command of NFF; v, b, l, f, s, c, p, pp are allowed");
  EXPECT_EQ(text_error(view + "s 0 0 0 1\n"), ":8: \"s\" has no material; the command f has to come before it");
  EXPECT_EQ(error("s 0 0 0\ns 1 1 1 1\n"), ":10: \"s\" is no radius; a number from 1e-30 to 1e+30 is allowed");
  EXPECT_EQ(error("s 0 0 0 1 5\n"), ":9: \"5\" follows all that \"s\" takes; a command has to begin a line");
  EXPECT_EQ(error("s 0 0 0\n"), ":9: the file ends within \"s\"; its radius is needed");
  EXPECT_EQ(error("s 0 nan 0 1\n"), ":9: \"nan\" is no coordinate; a number from -1e+30 to 1e+30 is allowed");
  EXPECT_EQ(error("s 0 1e31 0 1\n"), ":9: \"1e31\" is no coordinate; a number from -1e+30 to 1e+30 is allowed");
  EXPECT_EQ(error("s 0 0 0 -1\n"), ":9: \"-1\" is no radius; a number from 1e-30 to 1e+30 is allowed");
  EXPECT_EQ(error("c\n0 0 0 1\n0 0 0 1\n"),
            ":11: the apex is where the base is; a point at least 1e-30 away is needed");
  EXPECT_EQ(error("c\n0 0 0 0\n0 0 1 0\n"), ":11: both radii are 0; one of the two may be 0");
  EXPECT_EQ(error("c\n0 0 0 -1\n0 0 1 -1\n"), ":10: \"-1\" is no radius; a number from 0 to 1e+30 is allowed");
  EXPECT_EQ(error("c\n0 0 0 1\n0 0 1 1e-31\n"), ":11: the radius 1e-31 is too small; 0 or at least 1e-30 is allowed");
  EXPECT_EQ(error("p 2\n0 0 0\n1 0 0\n"),
            ":9: \"2\" is no number of corners; an integer from 3 to 2147483647 is allowed");
  EXPECT_EQ(error("p 2000000000\n0 0 0\n"), ":10: the file ends within \"p\"; its coordinate is needed");
  EXPECT_EQ(error("f 1 1 2 1.5 0 0 0 1\n"), ":9: \"1.5\" is no share (Kd); a number from 0 to 1 is allowed");
  EXPECT_EQ(error("b 0 -1 0\n"), ":9: \"-1\" is no component of a colour; a number from 0 to 4096 is allowed");
  EXPECT_EQ(error("l 0 0 0 1\n"), ":9: the file ends within \"l\"; its component of a colour is needed");
  std::string lights;
  for (int k = 0; k < 32; ++k) lights += "l 0 0 1\n";
  EXPECT_EQ(error(lights), "(no error)");
  EXPECT_EQ(error(lights + "l 0 0 1\n"), ":41: there are too many lights; at most 32 are allowed");
  EXPECT_EQ(error("\x1b[31m\n"), ":9: \"\\u001b[31m\" is no command of NFF; v, b, l, f, s, c, p, pp are allowed");
}

TEST_F(LoadNff, FilesThatCannotBeRead) {
  EXPECT_EQ(
      error_of<InputError>([&] { load_scene(folder() / "none.nff"); }),
      (folder() / "none.nff").string() + ": cannot be read: No such file or directory; a readable NFF file is allowed");
}

}  // namespace
}  // namespace pyrasim
