// SPDX-License-Identifier: Apache-2.0
#include "run/run.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>

#include "../temporary_folder.h"
#include "hw_model/machine_settings.h"

namespace pyrasim {
namespace {

Run some_run() {
  Run run;
  run.scene = {"scenes/keel.json", "1234"};
  run.screen = {640, 480, 1, 0.1, 0.3};
  return run;
}

void change(double& setting) { setting += 1; }
void change(hw::Cycle& setting) { setting += 1; }
void change(hw::Dispatch& setting) {
  setting = setting == hw::Dispatch::round_robin ? hw::Dispatch::first_free : hw::Dispatch::round_robin;
}

/// What a run can be asked for, each with another value.
std::vector<Run> all_changes() {
  std::vector<Run> runs;
  const auto changed = [&](const std::function<void(Run&)>& make) {
    runs.push_back(some_run());
    make(runs.back());
  };
  changed([](Run& run) { run.scene.sha256 = "1235"; });
  changed([](Run& run) { run.screen.columns = 641; });
  changed([](Run& run) { run.screen.rows = 481; });
  changed([](Run& run) { run.screen.dx = std::nextafter(1, 2); });
  changed([](Run& run) { run.screen.dy = std::nextafter(0.1, 1); });
  changed([](Run& run) { run.screen.dz = std::nextafter(0.3, 1); });
  changed([](Run& run) { run.window = {1, 0, 1, 1}; });
  changed([](Run& run) { run.window = {0, 1, 1, 1}; });
  changed([](Run& run) { run.window = {0, 0, 2, 1}; });
  changed([](Run& run) { run.window = {0, 0, 1, 2}; });
  changed([](Run& run) { run.max_level = 4; });
  changed([](Run& run) { run.edge = EdgePolicy::drop; });
  changed([](Run& run) { run.formats.view_vectors = parse_number_format("fp24"); });
  changed([](Run& run) { run.formats.intersection = parse_number_format("fp24"); });
  changed([](Run& run) { run.engine = hw::Engine::lockstep; });
  changed([](Run& run) { run.max_cycles = 1000; });
  changed([](Run& run) { run.reference = "grid:4"; });
  std::size_t settings = 0;
  const hw::MachineSpec machine;
  hw::for_each_setting(machine, [&](const auto&...) { ++settings; });
  for (std::size_t which = 0; which < settings; ++which) {
    changed([&](Run& run) {
      std::size_t k = 0;
      hw::for_each_setting(run.machine, [&](const std::string&, auto& setting, const auto&) {
        if (k++ == which) change(setting);
      });
    });
  }
  return runs;
}

TEST(RunKey, ChangesWithEverySetting) {
  std::set<std::string> keys{*run_key(some_run())};
  const auto runs = all_changes();
  EXPECT_GT(runs.size(), 40U);
  for (const auto& run : runs) EXPECT_TRUE(keys.insert(*run_key(run)).second) << canonical_json(run).dump(2);
}

TEST(RunKey, IsThatOfWhatIsRun) {
  auto renamed = some_run();
  renamed.scene.name = "elsewhere.json";
  renamed.machine.name = "another";
  renamed.machine.overridden = 3;
  EXPECT_EQ(run_key(renamed), run_key(some_run()));
  auto whole = some_run();
  whole.window = {0, 0, 640, 480};
  EXPECT_EQ(run_key(whole), run_key(some_run()));
  auto unknown = some_run();
  unknown.scene.sha256.clear();
  EXPECT_EQ(run_key(unknown), std::nullopt);
}

TEST(CanonicalJson, DoesNotDependOnTheOrderOfSettings) {
  auto run = some_run();
  run.machine = hw::load_machine({}, {"intersection.units=2", "clock_mhz=50", "fifos.all=3"});
  auto other = some_run();
  other.machine = hw::load_machine({}, {"fifos.all=3", "clock_mhz=50.0", "intersection.units=2"});
  EXPECT_EQ(canonical_json(run).dump(), canonical_json(other).dump());
  const auto a = nlohmann::json::parse(R"({"clock_mhz": 50, "intersection": {"units": 2, "latency": 9}})");
  const auto b = nlohmann::json::parse(R"({"intersection": {"latency": 9, "units": 2}, "clock_mhz": 5e1})");
  run.machine = hw::read_machine("a.json", a);
  other.machine = hw::read_machine("b.json", b);
  EXPECT_EQ(canonical_json(run).dump(), canonical_json(other).dump());
}

TEST(CanonicalJson, HasExactNumbersAndAllThatIsInEffect) {
  const std::string text = canonical_json(some_run()).dump();
  const auto document = nlohmann::ordered_json::parse(text);
  EXPECT_EQ(document.dump(), nlohmann::json::parse(text).dump());  // its keys are sorted already
  EXPECT_EQ(document["screen"]["dy"].get<double>(), 0.1);
  EXPECT_EQ(document["window"]["columns"], 640);
  EXPECT_EQ(document["max_cycles"], hw::longest_frame);
  EXPECT_EQ(document["machine"]["intersection"]["units"], 4);
  EXPECT_FALSE(document["machine"].contains("name"));
}

class SceneBytes : public TemporaryFolder {
 protected:
  std::string sha256_of(const std::string& scene, const std::string& mesh) const {
    put(in_folder("scene.json"), scene);
    put(in_folder("mesh.obj"), mesh);
    return sha256_of_files({in_folder("scene.json"), in_folder("mesh.obj")});
  }
};

TEST_F(SceneBytes, EachCounts) {
  const std::set<std::string> all{sha256_of("abc", "de"), sha256_of("abd", "de"),  sha256_of("abc", "df"),
                                  sha256_of("ab", "cde"), sha256_of("abc ", "de"), sha256_of("de", "abc")};
  EXPECT_EQ(all.size(), 6U);
  EXPECT_EQ(all.count(sha256_of("abc", "de")), 1U);
}

TEST_F(SceneBytes, OfWhatCannotBeReadAgainAreUnknown) {
  put(in_folder("scene.json"), "abc");
  for (const std::string& other : {std::string("/dev/null"), in_folder("gone.obj").string()}) {
    EXPECT_EQ(sha256_of_files({in_folder("scene.json"), other}), "") << other;
  }
}

}  // namespace
}  // namespace pyrasim
