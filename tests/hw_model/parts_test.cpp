// SPDX-License-Identifier: Apache-2.0
// What a frame has no use for is not there, and what is there accounts for all the work.
#include <gtest/gtest.h>

#include <set>

#include "../shipped_scene.h"
#include "../test_scenes.h"
#include "simulation.h"

namespace pyrasim::hw {
namespace {

using Names = std::set<std::string>;

/// A frame, and what its machine has to have beside what every frame needs.
struct Frame {
  std::string name;
  Scene scene;
  int max_level;
  std::size_t units;
  Names others;
};

const Names of_every_frame{"pixel_scan", "view_vector_generator", "intersection_unit", "pyramid_classifier",
                           "color_unit", "tree_accumulator",      "frame_buffer"};
const std::string controller = "subdivision_controller";
const std::string shadows = "shadow_unit";

/// Parts of an intersection unit by what they are for; of a shadow unit likewise, where there is one.
Names with(Names names, std::initializer_list<const char*> surfaces, bool hierarchy = true) {
  const Names units = names.contains(shadows) ? Names{"intersection_unit", shadows} : Names{"intersection_unit"};
  for (const std::string& unit : units) {
    for (const std::string surface : surfaces) names.insert(unit + "." + surface + "_tester");
    if (hierarchy) names.insert(unit + ".hierarchy_walker");
  }
  return names;
}

Frame shipped(const std::string& name, int max_level, std::size_t units, const Names& others) {
  Scene scene = shipped_scene(name);
  scene.camera.screen = resized(scene.camera.screen, 32, 24);
  return {name, std::move(scene), max_level, units, others};
}

Scene scene_of(std::initializer_list<SceneSurface> surfaces) {
  Scene scene = empty_scene(32, 24, 0.03125);
  for (const SceneSurface& surface : surfaces) scene.objects.push_back(object(surface));
  return scene;
}

/// Two spheres in one place of the screen, far from each other: one leaf for view rays, two for shadow rays.
Frame one_sphere_before_another() {
  Scene scene = scene_of({Sphere{{5, 0, 0}, 1}, Sphere{{50, 0, 0}, 10}});
  scene.lights = {DirectionalLight{{1, -1, 0}, {1, 1, 1}}};
  Names others = with({controller, shadows}, {"sphere"}, false);
  others.insert(shadows + ".hierarchy_walker");
  return {"one sphere before another", std::move(scene), 2, 2, std::move(others)};
}

Frame checkered_floor() {
  const Plane floor{{0, 1, 0}, -1};
  Scene scene = scene_of({floor});
  scene.objects[0].texture = std::make_shared<const ObjectTexture>(ObjectTexture{
      {.colors = {glm::dvec3(1), glm::dvec3(0)}}, std::make_shared<const SceneSurface>(floor), AffineMap()});
  Names others = with({controller}, {"plane"}, false);
  others.insert("color_unit.texture");
  return {"a checkered floor", std::move(scene), 1, 2, std::move(others)};
}

std::vector<Frame> frames() {
  const Sphere ball{{5, 0, 0}, 1};
  const Plane floor{{0, 1, 0}, -1};
  return {
      shipped("keel", 3, 4, with({controller}, {"sphere", "triangle"})),
      shipped("keel", 0, 1, with({}, {"sphere", "triangle"})),
      shipped("spheres", 2, 7, with({controller}, {"sphere"})),
      shipped("fins", 1, 2, with({controller}, {"triangle"})),
      shipped("blocks", 3, 4, with({controller}, {"sphere", "plane", "disc", "box"})),
      shipped("quadrics", 2, 3, with({controller}, {"plane", "cylinder", "cone", "ellipsoid", "quadric", "triangle"})),
      shipped("tori", 1, 2, with({controller}, {"sphere", "plane", "torus"})),
      shipped("crystals", 2, 3, with({controller}, {"sphere", "plane", "triangle", "instance"})),
      shipped("buoys", 1, 2, with({controller, shadows, "color_unit.texture"}, {"plane", "triangle"})),
      shipped(
          "shadows", 3, 3,
          with({controller, shadows}, {"sphere", "plane", "box", "cylinder", "cone", "ellipsoid", "quadric", "disc"})),
      shipped("bunny", 1, 16, with({controller}, {"plane", "triangle"})),
      {"nothing", scene_of({}), 3, 2, {}},
      {"one sphere", scene_of({ball}), 3, 4, with({controller}, {"sphere"}, false)},
      {"one plane", scene_of({floor}), 0, 1, with({}, {"plane"}, false)},
      {"one sphere on a plane", scene_of({ball, floor}), 2, 4, with({controller}, {"sphere", "plane"}, false)},
      {"two spheres", scene_of({ball, Sphere{{5, 1, 2}, 1}}), 2, 1, with({controller}, {"sphere"})},
      one_sphere_before_another(),
      checkered_floor(),
  };
}

/// Of SystemC's own list.
std::size_t modules_in(const Processor& machine) {
  std::size_t modules = 0;
  for (const sc_core::sc_object* child : machine.get_child_objects()) {
    modules += dynamic_cast<const Stage*>(child) != nullptr ? 1U : 0U;
  }
  return modules;
}

void expect_built(const Processor& machine, const Frame& frame) {
  Names expected = of_every_frame;
  expected.insert(frame.others.begin(), frame.others.end());
  Names built;
  std::size_t modules = 0;
  Names listed;
  for (const MachinePart& part : machine.parts()) {
    EXPECT_TRUE(listed.insert(part.name()).second) << part.name();
    EXPECT_FALSE(part.reason.empty()) << part.name();
    if (part.units == 0) continue;
    built.insert(part.name());
    EXPECT_EQ(part.units, part.box == "intersection_unit" || part.box == shadows ? frame.units : 1) << part.name();
    if (part.part.empty()) modules += part.units;
  }
  EXPECT_EQ(built, expected);
  EXPECT_EQ(modules, modules_in(machine));
  EXPECT_EQ(modules, of_every_frame.size() - 1 + frame.units + frame.others.count(controller) +
                         frame.units * frame.others.count(shadows));
  const std::size_t parts = 1 + surface_kinds;  // of each kind of unit: its walker and testers
  EXPECT_EQ(listed.size(), of_every_frame.size() + 2 + 1 + parts * (1 + frame.others.count(shadows)));
}

/// What the parts took and the fixed cost of each ray is all that the box did; boxes did what their units did.
void expect_accounted(const Processor& machine) {
  Cycle of_boxes = 0, of_unit = 0, of_its_parts = 0, of_shadows = 0, of_their_parts = 0;
  for (const MachinePart& part : machine.parts()) {
    EXPECT_TRUE(part.units > 0 || part.busy == 0) << part.name();
    if (part.part.empty()) of_boxes += part.busy;
    if (part.box == "intersection_unit") (part.part.empty() ? of_unit : of_its_parts) += part.busy;
    if (part.box == shadows) (part.part.empty() ? of_shadows : of_their_parts) += part.busy;
  }
  Cycle of_stages = 0;
  for (const Stage* stage : machine.stages()) of_stages += stage->statistics(machine.cycles()).busy;
  EXPECT_EQ(of_boxes, of_stages);
  const FrameStatistics counts = machine.statistics();
  for (const MachinePart& part : machine.parts()) {
    if (part.name() != "color_unit.texture") continue;
    EXPECT_EQ(part.busy, cost_of(counts.texture, machine.spec().texture_cost));
  }
  EXPECT_EQ(of_unit, of_its_parts + machine.spec().intersection_cost.ray * counts.total_rays());
  if (counts.lights_with_shadows == 0) return;
  EXPECT_EQ(of_shadows,
            of_their_parts + counts.total_rays() + machine.spec().shadow_unit.ray * counts.work.shadow.total_rays());
}

TEST(Parts, AreThoseThatTheFrameNeeds) {
  const std::vector<Frame> all = frames();
  Simulation simulation;
  std::vector<const Processor*> machines;
  for (const Frame& frame : all) {
    MachineSpec spec;
    spec.intersection_units = frame.units;
    SimulationOptions options;
    options.max_level = frame.max_level;
    machines.push_back(&simulation.add(frame.scene, spec, options));
  }
  simulation.run();
  for (std::size_t k = 0; k < all.size(); ++k) {
    SCOPED_TRACE(all[k].name);
    expect_built(*machines[k], all[k]);
    expect_accounted(*machines[k]);
  }
}

}  // namespace
}  // namespace pyrasim::hw
