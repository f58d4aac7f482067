// SPDX-License-Identifier: Apache-2.0
#include "hw_model/machine_spec.h"

#include <gtest/gtest.h>

#include "../error_of.h"
#include "../shipped_scene.h"
#include "../temp_folder.h"
#include "../test_scenes.h"
#include "error.h"
#include "hw_model/processor.h"

namespace pyrasim::hw {
namespace {

class LoadMachine : public TempFolderTest {
 protected:
  /// The message for a machine file of this text, without the folder.
  std::string error(const std::string& text) const {
    const std::filesystem::path file = write("machine.json", text);
    const std::string message = error_of<InputError>([&] { load_machine(file); });
    const std::string path = file.string();
    return message.rfind(path, 0) == 0 ? "machine.json" + message.substr(path.size()) : message;
  }
};

bool starts_with(const std::string& text, const std::string& start) { return text.rfind(start, 0) == 0; }
bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST_F(LoadMachine, DefaultsWithoutAFile) {
  const MachineSpec spec = load_machine(std::nullopt);
  const MachineSpec defaults;
  EXPECT_EQ(spec.name, "default");
  EXPECT_EQ(spec.clock_mhz, defaults.clock_mhz);
  EXPECT_EQ(spec.intersection_units, defaults.intersection_units);
  EXPECT_EQ(spec.intersection_cost.surface_test, defaults.intersection_cost.surface_test);
  EXPECT_EQ(spec.fifos.subdivision_controller_to_pyramid_classifier,
            defaults.fifos.subdivision_controller_to_pyramid_classifier);
  EXPECT_EQ(spec.budget(), 6'666'666U);  // 200 MHz at 30 frames a second
}

TEST_F(LoadMachine, TheDefaultIsTheShippedFiles) { EXPECT_EQ(load_machine(shipped_machine("default")), MachineSpec{}); }

TEST_F(LoadMachine, EveryKeyOfAFile) {
  const MachineSpec spec = load_machine(write("big.json", R"({
    "name": "test", "clock_mhz": 100, "goal_fps": 50,
    "pixel_scan": {"latency": 2, "interval": 3},
    "view_vector_generator": {"latency": 4, "interval": 5},
    "intersection": {"units": 6, "latency": 7,
                     "cost": {"ray": 8, "box_test": 9, "sphere": 10, "plane": 11, "triangle": 0, "disc": 24, "box": 25, "ellipsoid": 26,
                              "cylinder": 27, "cone": 28, "quadric": 29, "torus": 30, "instance": 31}},
    "pyramid_classifier": {"latency": 12, "interval": 13},
    "subdivision_controller": {"latency": 14, "interval": 15, "pool": 16},
    "color_unit": {"latency": 24, "interval": 25},
    "tree_accumulator": {"latency": 17, "interval": 18, "pixels": 19},
    "frame_buffer": {"interval": 21},
    "fifos": {"all": 22, "tree_accumulator_to_frame_buffer": 23}})"));
  EXPECT_EQ(spec.name, "test");
  EXPECT_EQ(spec.budget(), 2'000'000U);
  EXPECT_EQ(spec.pixel_scan.latency, 2U);
  EXPECT_EQ(spec.pixel_scan.interval, 3U);
  EXPECT_EQ(spec.view_vector_generator.latency, 4U);
  EXPECT_EQ(spec.view_vector_generator.interval, 5U);
  EXPECT_EQ(spec.intersection_units, 6U);
  EXPECT_EQ(spec.intersection_latency, 7U);
  EXPECT_EQ(spec.intersection_cost.ray, 8U);
  EXPECT_EQ(spec.intersection_cost.box_test, 9U);
  EXPECT_EQ(spec.intersection_cost.surface_test,
            (std::array<Cycle, surface_kinds>{10, 11, 0, 24, 25, 26, 27, 28, 29, 30, 31}));
  EXPECT_EQ(spec.pyramid_classifier.latency, 12U);
  EXPECT_EQ(spec.pyramid_classifier.interval, 13U);
  EXPECT_EQ(spec.subdivision_controller.latency, 14U);
  EXPECT_EQ(spec.subdivision_controller.interval, 15U);
  EXPECT_EQ(spec.subdivision_pool, 16U);
  EXPECT_EQ(spec.color_unit.latency, 24U);
  EXPECT_EQ(spec.color_unit.interval, 25U);
  EXPECT_EQ(spec.tree_accumulator.latency, 17U);
  EXPECT_EQ(spec.tree_accumulator.interval, 18U);
  EXPECT_EQ(spec.pixels_in_flight, 19U);
  EXPECT_EQ(spec.frame_buffer_interval, 21U);
  EXPECT_EQ(spec.fifos.pixel_scan_to_view_vector_generator, 22U);
  EXPECT_EQ(spec.fifos.tree_accumulator_to_frame_buffer, 23U);  // its own number goes before that for all
}

TEST_F(LoadMachine, NameIsTheFilesWhereItSaysNone) { EXPECT_EQ(load_machine(write("tiny.json", "{}")).name, "tiny"); }

TEST_F(LoadMachine, ErrorsNameFileAndPointer) {
  EXPECT_TRUE(starts_with(error(R"({"clock": 5})"), "machine.json: /clock: ")) << error(R"({"clock": 5})");
  EXPECT_TRUE(starts_with(error(R"({"frame_buffer": {"delay": 5}})"), "machine.json: /frame_buffer/delay: "));
  EXPECT_TRUE(starts_with(error(R"({"frame_buffer": {"latency": 1}})"),
                          "machine.json: /frame_buffer/latency: nothing waits for what the frame buffer stores"));
  EXPECT_TRUE(
      starts_with(error(R"({"intersection": {"cost": {"helix": 1}}})"), "machine.json: /intersection/cost/helix: "));
  EXPECT_TRUE(starts_with(error(R"({"intersection": {"units": 0}})"), "machine.json: /intersection/units: "));
  EXPECT_TRUE(starts_with(error(R"({"intersection": {"units": 257}})"), "machine.json: /intersection/units: "));
  EXPECT_TRUE(starts_with(error(R"({"intersection": {"units": 1.5}})"), "machine.json: /intersection/units: "));
  EXPECT_TRUE(starts_with(error(R"({"intersection": {"units": "4"}})"), "machine.json: /intersection/units: "));
  EXPECT_TRUE(starts_with(error(R"({"intersection": []})"), "machine.json: /intersection: "));
  EXPECT_TRUE(
      starts_with(error(R"({"intersection": {"cost": {"ray": 0}}})"), "machine.json: /intersection/cost/ray: "));
  EXPECT_TRUE(starts_with(error(R"({"pixel_scan": {"latency": 0}})"), "machine.json: /pixel_scan/latency: "));
  EXPECT_TRUE(starts_with(error(R"({"fifos": {"all": 0}})"), "machine.json: /fifos/all: "));
  EXPECT_TRUE(starts_with(error(R"({"clock_mhz": 0})"), "machine.json: /clock_mhz: "));
  EXPECT_TRUE(contains(error(R"({"intersection": {"units": 257}})"), "256"));
  EXPECT_TRUE(starts_with(error("{"), "machine.json:")) << error("{");
  EXPECT_TRUE(contains(error_of<InputError>([&] { load_machine(folder() / "none.json"); }), "none.json"));
}

TEST_F(LoadMachine, OverridesGoOverTheFile) {
  const auto file = write("machine.json", R"({"intersection": {"units": 3, "latency": 9}})");
  const MachineSpec spec =
      load_machine(file, {"intersection.units=5", "fifos.all=2", "frame_buffer.interval=7", "intersection.units=6"});
  EXPECT_EQ(spec.intersection_units, 6U);  // the last word
  EXPECT_EQ(spec.intersection_latency, 9U);
  EXPECT_EQ(spec.fifos.pyramid_classifier_to_color_unit, 2U);
  EXPECT_EQ(spec.frame_buffer_interval, 7U);
  EXPECT_EQ(load_machine(std::nullopt, {"tree_accumulator.pixels=1"}).pixels_in_flight, 1U);
}

TEST_F(LoadMachine, WrongOverridesAreUsageErrors) {
  for (const char* override : {"intersection.units=0", "intersection.units=many", "no_such.key=1", "clock_mhz=-1"}) {
    const std::string message = error_of<UsageError>([&] { load_machine(std::nullopt, {override}); });
    EXPECT_TRUE(starts_with(message, "--set: ")) << message;
  }
  EXPECT_NE(error_of<UsageError>([] { load_machine(std::nullopt, {"intersection.units"}); }), "(no error)");
  // A mistake of the file stays one of the file.
  const auto file = write("machine.json", R"({"clock_mhz": 0})");
  EXPECT_NE(error_of<InputError>([&] { load_machine(file, {"clock_mhz=5"}); }), "(no error)");
}

TEST(RequiredPool, ByHand) {
  EXPECT_EQ(required_pool(0), 0U);
  EXPECT_EQ(required_pool(1), 0U);
  EXPECT_EQ(required_pool(2), 4U);
  EXPECT_EQ(required_pool(3), 7U);
  EXPECT_EQ(required_pool(10), 28U);
}

TEST(RequiredPool, OneLessIsRefusedBeforeElaboration) {
  const Scene scene = random_scene(1, {3, 0, 0}, 4, 4);
  for (int max_level = 2; max_level <= 10; ++max_level) {
    MachineSpec spec;
    spec.subdivision_pool = required_pool(max_level) - 1;
    SimulationOptions options;
    options.max_level = max_level;
    const std::string message = error_of<InputError>([&] { Processor("machine", scene, spec, options); });
    EXPECT_TRUE(contains(message, "/subdivision_controller/pool: " + std::to_string(spec.subdivision_pool))) << message;
    EXPECT_TRUE(contains(message, "at least " + std::to_string(required_pool(max_level)))) << message;
    EXPECT_NE(error_of<InputError>([&] { check_machine_holds(spec, max_level, 4); }), "(no error)");
    check_machine_holds(spec, max_level - 1, 4);
  }
}

TEST(CornerRow, OneLessThanARowAndOneIsRefused) {
  MachineSpec spec;
  spec.line_buffer = 12;
  check_machine_holds(spec, 0, 10);
  const std::string message = error_of<InputError>([&] { check_machine_holds(spec, 0, 11); });
  EXPECT_TRUE(contains(message, "/pyramid_classifier/line_buffer: 12 cannot hold")) << message;
  EXPECT_TRUE(contains(message, "at least 13")) << message;
}

}  // namespace
}  // namespace pyrasim::hw
