// SPDX-License-Identifier: Apache-2.0
// Transforms and shapes in scene files.
#include <fmt/format.h>

#include <cmath>
#include <string>

#include "../error_of.h"
#include "../temp_folder.h"
#include "error.h"
#include "scene/load_scene.h"

namespace pyrasim {
namespace {

class Transforms : public TempFolderTest {
 protected:
  Scene load(const std::string& members) const {
    return load_scene(
        write("s.json", R"({"camera": {"screen": {"columns": 4, "rows": 3, "horizontal_fov": 60}}, )" + members + "}"));
  }
  /// The one object: a surface under a transform.
  SceneSurface loaded(const std::string& surface, const std::string& transform) const {
    return load(objects(surface, transform)).objects.at(0).surface;
  }
  std::string error(const std::string& members) const {
    const std::string message = error_of<InputError>([&] { load(members); });
    const std::string file = (folder() / "s.json").string();
    return message.find(file) == 0 ? message.substr(file.size()) : message;
  }
  static std::string objects(const std::string& surface, const std::string& transform) {
    return R"("objects": [{"color": [1, 1, 1], )" + surface + R"(, "transform": )" + transform + "}]";
  }
};

const std::string ball = R"("type": "sphere", "center": [1, 2, 3], "radius": 2)";
const std::string box = R"("type": "box", "min": [0, 0, 0], "max": [1, 2, 3])";
const std::string disc = R"("type": "disc", "center": [1, 0, 0], "normal": [0, 0, 2], "radius": 2)";
const std::string ring =
    R"("type": "torus", "center": [1, 0, 0], "axis": [0, 0, 2], "major_radius": 2, "minor_radius": 2)";
const std::string tube = R"("type": "cylinder", "base": [0, 0, 0], "cap": [0, 0, 2], "radius": 1)";

TEST_F(Transforms, StepsAreAppliedInOrder) {
  const auto sphere = std::get<Sphere>(
      loaded(ball, R"([{"scale": -2}, {"rotate": {"axis": [0, 0, 3], "degrees": 90}}, {"translate": [10, 0, 0]}])"));
  EXPECT_EQ(sphere.center, glm::dvec3(14, -2, -6));
  EXPECT_EQ(sphere.radius, 4);
}

TEST_F(Transforms, OneStepAloneOrAMatrix) {
  EXPECT_EQ(std::get<Sphere>(loaded(ball, R"({"translate": [1, 1, 1]})")).center, glm::dvec3(2, 3, 4));
  EXPECT_EQ(std::get<Sphere>(loaded(ball, R"({"matrix": [[0, 0, 1, 5], [1, 0, 0, 6], [0, 1, 0, 7]]})")).center,
            glm::dvec3(8, 7, 9));
}

TEST_F(Transforms, AScaledSphereIsAnEllipsoid) {
  const auto ellipsoid = std::get<Ellipsoid>(loaded(ball, R"({"scale": [1, -2, 0.5]})"));
  EXPECT_EQ(ellipsoid.center, glm::dvec3(1, -4, 1.5));
  EXPECT_EQ(ellipsoid.radii, glm::dvec3(2, 4, 1));
  EXPECT_EQ(rounded(ellipsoid.axes()[1]), glm::dvec3(0, -1, 0));
}

TEST_F(Transforms, SimilaritiesKeepKinds) {
  const std::string turn = R"([{"rotate": {"axis": [1, 2, 2], "degrees": 30}}, {"scale": [-3, 3, 3]}])";
  EXPECT_EQ(std::get<Sphere>(loaded(ball, turn)).radius, 6);
  EXPECT_EQ(std::get<Disc>(loaded(disc, turn)).radius, 6);
  EXPECT_EQ(std::get<Torus>(loaded(ring, turn)).major_radius, 6);
  EXPECT_EQ(std::get<Torus>(loaded(ring, turn)).minor_radius, 6);
  EXPECT_EQ(std::get<Torus>(loaded(ring, R"({"rotate": {"axis": [1, 0, 0], "degrees": 90}})")).axis,
            glm::dvec3(0, -1, 0));
  EXPECT_EQ(std::get<Cylinder>(loaded(tube, turn)).radius, 3);
  EXPECT_NEAR(static_cast<double>(std::get<Cylinder>(loaded(tube, turn)).axis.length()), 6, 1e-14);
  EXPECT_TRUE(std::holds_alternative<Shared<Parallelepiped>>(loaded(box, turn)));
  EXPECT_EQ(std::get<Box>(loaded(box, R"({"scale": [-1, 1, 2]})")).min, glm::dvec3(-1, 0, 0));
  EXPECT_TRUE(std::holds_alternative<Shared<FramedQuadric>>(loaded(tube, R"({"scale": [1, 2, 1]})")));
}

TEST_F(Transforms, PlanesGoByTheirNormals) {
  const auto plane =
      std::get<Plane>(loaded(R"("type": "plane", "normal": [0, 2, 0], "offset": 4)", R"([{"scale": [1, 3, 1]}])"));
  EXPECT_EQ(plane.normal, glm::dvec3(0, 1, 0));
  EXPECT_EQ(plane.offset, 6);
}

TEST_F(Transforms, InstancesOfInstancesAreMappedFromTheInnermostOut) {
  const Scene scene = load(R"("shapes": {"ball": {)" + ball + R"(, "transform": {"scale": 2}},
      "moved": {"type": "instance", "of": "ball", "transform": {"translate": [1, 0, 0]}}},
    "objects": [{"type": "instance", "of": "moved", "color": [1, 0, 0], "name": "big", "shadow": false,
                 "transform": {"scale": 10}},
                {"type": "instance", "of": "ball", "color": [0, 1, 0]}])");
  EXPECT_EQ(scene.objects.at(0).name, "big");
  EXPECT_FALSE(scene.objects[0].casts_shadow);
  EXPECT_EQ(scene.objects[0].color, glm::dvec3(1, 0, 0));
  EXPECT_EQ(std::get<Sphere>(scene.objects[0].surface).center, glm::dvec3(30, 40, 60));
  EXPECT_EQ(std::get<Sphere>(scene.objects[0].surface).radius, 40);
  EXPECT_EQ(std::get<Sphere>(scene.objects.at(1).surface).center, glm::dvec3(2, 4, 6));
}

/// Each shape of the next, and the last of `last`.
std::string chain_of_instances(int length, const std::string& last, const std::string& transform) {
  std::string shapes = R"("shapes": {)";
  for (int k = 0; k < length; ++k) {
    shapes += fmt::format(R"("s{}": {{"type": "instance", "of": "s{}"{}}}, )", k, k + 1, transform);
  }
  return shapes + fmt::format(R"("s{}": {{{}}}}}, "objects": [{{"type": "instance", "of": "s0", "color": [1, 1, 1]}}])",
                              length, last);
}

TEST_F(Transforms, InstancesMayBeNestedDeeperThanCalls) {
  const Scene scene = load(chain_of_instances(100'000, ball, ""));
  EXPECT_EQ(std::get<Sphere>(scene.objects.at(0).surface).center, glm::dvec3(1, 2, 3));
  const std::string moved = R"(, "transform": {"translate": [0.25, 0, 0]})";
  const Scene far = load(chain_of_instances(10'000, ball, moved));
  EXPECT_EQ(std::get<Sphere>(far.objects.at(0).surface).center, glm::dvec3(2501, 2, 3));
  const std::string doubled = R"(, "transform": {"scale": 2})";
  EXPECT_NE(error(chain_of_instances(10'000, ball, doubled)).find("/transform: it makes lengths "), std::string::npos);
  const std::string circle = R"("type": "instance", "of": "s0")";
  EXPECT_EQ(
      error(chain_of_instances(10'000, circle, "")).find(": /shapes/s10000/of: a shape is made of itself: \"s0\" of "),
      0U);
}

TEST_F(Transforms, AMeshFileIsReadOnce) {
  write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl x\nf 1 2 3\n");
  const Scene scene = load(R"("shapes": {"m": {"type": "mesh", "file": "m.obj"}},
    "objects": [{"type": "instance", "of": "m", "color": [1, 1, 1]},
                {"type": "mesh", "file": "m.obj", "color": [1, 1, 1], "transform": {"scale": [1, 2, 3]}}])");
  EXPECT_EQ(scene.files.size(), 2U);
  EXPECT_EQ(scene.warnings.size(), 1U);
  EXPECT_EQ(std::get<Mesh>(scene.objects.at(1).surface).vertices[2], glm::dvec3(0, 2, 0));
}

TEST_F(Transforms, InstancesOfAMeshShareItAndAreNotCopied) {
  write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const Scene scene = load(R"("shapes": {"m": {"type": "mesh", "file": "m.obj", "transform": {"scale": 2}},
                                         "n": {"type": "instance", "of": "m", "transform": {"translate": [1, 0, 0]}}},
    "objects": [{"type": "instance", "of": "m", "color": [1, 1, 1]},
                {"type": "instance", "of": "n", "color": [1, 1, 1], "transform": {"scale": [1, 2, 3]}}])");
  const auto& plain = std::get<MeshInstance>(scene.objects.at(0).surface);
  const auto& moved = std::get<MeshInstance>(scene.objects.at(1).surface);
  EXPECT_EQ(plain.of, moved.of);
  const auto placed = [](const MeshInstance& instance) {
    return rounded(instance.map.point(exactly(instance.of->mesh.vertices[2])));
  };
  EXPECT_EQ(placed(plain), glm::dvec3(0, 2, 0));
  EXPECT_EQ(placed(moved), glm::dvec3(1, 4, 0));
}

TEST_F(Transforms, Mistakes) {
  const auto with = [&](const std::string& transform, const std::string& surface = ball) {
    return error(objects(surface, transform));
  };
  const std::string at = ": /objects/0/transform";
  EXPECT_EQ(with(R"({"scale": 0})"),
            at + "/scale: 0 flattens space; a number of at least 1e-30 in magnitude is allowed");
  EXPECT_EQ(with(R"([{"scale": [1, 0, 1]}])"),
            at + "/0/scale/1: 0 flattens space; a number of at least 1e-30 in magnitude is allowed");
  EXPECT_EQ(with(R"({"rotate": {"axis": [0, 0, 0], "degrees": 1}})"),
            at + "/rotate/axis: the vector is zero; a component of at least 1e-30 in magnitude is needed");
  EXPECT_EQ(with(R"({"matrix": [[1, 1, 0, 0], [1, 1, 0, 0], [0, 0, 1, 0]]})"),
            at + "/matrix: it is singular, or nearly: it flattens space; ratios of at most 1000000 between directions "
                 "are allowed");
  EXPECT_EQ(with(R"({"matrix": [[1e-300, 0, 0, 0], [0, 1e-300, 0, 0], [0, 0, 1e-300, 0]]})"),
            at + "/matrix: it makes lengths 1e-300 times as long; factors from 1e-60 to 1e+60 are allowed");
  EXPECT_EQ(with(R"([{"scale": 1e30}, {"scale": 1e29}, {"scale": 100}])"),
            at + ": it makes lengths 1e+61 times as long; factors from 1e-60 to 1e+60 are allowed");
  EXPECT_EQ(with(R"({"scale": [1, 1, 3e6]})"),
            at + "/scale: it stretches one direction 3e+06 times as much as another; ratios of at most 1000000 between "
                 "directions are allowed");
  EXPECT_EQ(with(R"([{"scale": [1, 1, 2000]}, {"scale": [1e-3, 1, 1]}])"),
            at + ": it stretches one direction 2e+06 times as much as another; ratios of at most 1000000 between "
                 "directions are allowed");
  EXPECT_EQ(with(R"({"scale": 2, "translate": [1, 1, 1]})"),
            at + ": it has 2 members; one of scale, rotate, translate, matrix is allowed");
  EXPECT_EQ(with(R"({"turn": 2})"), at + "/turn: unknown key; allowed keys: scale, rotate, translate, matrix");
  EXPECT_EQ(with("[]"), at + ": it has 0 elements; an array of at least 1 element is allowed");
  EXPECT_EQ(with(R"({"scale": [1, 2, 1]})", disc),
            at + ": it would make an ellipse of a disc; moving, turning, mirroring and scaling by the same in all "
                 "directions are allowed");
  EXPECT_EQ(with(R"({"scale": [1, 2, 1]})", ring), at + ": it would make a ring of another form of a torus; moving, "
                                                        "turning, mirroring and scaling by the same in all "
                                                        "directions are allowed");
  EXPECT_EQ(with(R"([{"scale": 1e20}, {"scale": 1e20}])"),
            at + ": it moves a point beyond all coordinates; coordinates of at most 1e+30 are allowed");
  EXPECT_EQ(with(R"({"scale": 1e-30})", R"("type": "sphere", "center": [0, 0, 0], "radius": 0.5)"),
            at + ": it makes a length 5e-31; lengths from 1e-30 to 1e+30 are allowed");
}

TEST_F(Transforms, MistakesOfShapes) {
  const auto with = [&](const std::string& shapes, const std::string& of) {
    return error("\"shapes\": {" + shapes + R"(}, "objects": [{"type": "instance", "color": [1, 1, 1], "of": ")" + of +
                 "\"}]");
  };
  EXPECT_EQ(with("", "x"), ": /objects/0/of: there is no shape \"x\"; the name of one of \"shapes\" is allowed");
  EXPECT_EQ(with(R"("a": {"type": "instance", "of": "b"}, "b": {"type": "instance", "of": "a"})", "a"),
            ": /shapes/b/of: a shape is made of itself: \"a\" of \"b\" of \"a\"; instances that end at a surface are "
            "allowed");
  EXPECT_EQ(with("\"a\": {" + ball + R"(, "color": [1, 1, 1]})", "a"),
            ": /shapes/a/color: unknown key; allowed keys: type, transform, center, radius");
  EXPECT_EQ(with("\"a\": {" + disc + R"(, "transform": {"scale": [1, 2, 3]}})", "a").find(": /shapes/a/transform: it"),
            0U);
}

}  // namespace
}  // namespace pyrasim
