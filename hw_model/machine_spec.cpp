// SPDX-License-Identifier: Apache-2.0
#include "hw_model/machine_spec.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "error.h"
#include "json/json_file.h"
#include "json/json_override.h"
#include "json/json_reader.h"
#include "text/printable.h"

namespace pyrasim::hw {
namespace {

constexpr IntegerRange cycles{1, 1'000'000};
constexpr IntegerRange cost{0, 1'000'000};
constexpr IntegerRange depth{1, 65'536};

template <class T>
void read(const JsonReader& reader, std::string_view key, const IntegerRange& range, T& setting) {
  if (const auto value = reader.optional_integer(key, range)) setting = static_cast<T>(*value);
}

void read(const JsonReader& reader, std::string_view key, const NumberRange& range, double& setting) {
  setting = reader.optional_number(key, range).value_or(setting);
}

/// `more`: keys beside latency and interval, for the caller to read.
std::optional<JsonReader> read_stage(const JsonReader& root, std::string_view name, StageTiming& timing,
                                     const std::vector<std::string_view>& more = {}) {
  auto reader = root.find(name);
  if (!reader) return reader;
  std::vector<std::string_view> keys{"latency", "interval"};
  keys.insert(keys.end(), more.begin(), more.end());
  reader->allow_keys(keys);
  read(*reader, "latency", cycles, timing.latency);
  read(*reader, "interval", cycles, timing.interval);
  return reader;
}

void read_intersection(const JsonReader& reader, MachineSpec& spec) {
  reader.allow_keys({"units", "dispatch", "reorder_buffer", "latency", "cost"});
  read(reader, "units", {1, 256}, spec.intersection_units);
  spec.dispatch = reader
                      .optional_choice<Dispatch>(
                          "dispatch", {{"round_robin", Dispatch::round_robin}, {"first_free", Dispatch::first_free}})
                      .value_or(spec.dispatch);
  read(reader, "reorder_buffer", depth, spec.reorder_buffer);
  read(reader, "latency", cycles, spec.intersection_latency);
  const auto costs = reader.find("cost");
  if (!costs) return;
  std::vector<std::string_view> keys{"ray", "box_test"};
  keys.insert(keys.end(), surface_kind_names.begin(), surface_kind_names.end());
  costs->allow_keys(keys);
  read(*costs, "ray", cycles, spec.intersection_cost.ray);
  read(*costs, "box_test", cost, spec.intersection_cost.box_test);
  for (std::size_t kind = 0; kind < surface_kinds; ++kind) {
    read(*costs, surface_kind_names[kind], cost, spec.intersection_cost.surface_test[kind]);
  }
}

void read_frame_buffer(const JsonReader& reader, MachineSpec& spec) {
  if (reader.has("latency")) {
    reader.member("latency").fail("nothing waits for what the frame buffer stores, so that it has no latency",
                                  "remove it; allowed keys: interval");
  }
  reader.allow_keys({"interval"});
  read(reader, "interval", cycles, spec.frame_buffer_interval);
}

void read_fifos(const JsonReader& reader, FifoDepths& depths) {
  const std::vector<std::pair<std::string_view, std::size_t*>> fifos{
      {"pixel_scan_to_view_vector_generator", &depths.pixel_scan_to_view_vector_generator},
      {"view_vector_generator_to_intersection_unit", &depths.view_vector_generator_to_intersection_unit},
      {"intersection_unit_to_pyramid_classifier", &depths.intersection_unit_to_pyramid_classifier},
      {"pyramid_classifier_to_subdivision_controller", &depths.pyramid_classifier_to_subdivision_controller},
      {"subdivision_controller_to_view_vector_generator", &depths.subdivision_controller_to_view_vector_generator},
      {"subdivision_controller_to_pyramid_classifier", &depths.subdivision_controller_to_pyramid_classifier},
      {"pyramid_classifier_to_tree_accumulator", &depths.pyramid_classifier_to_tree_accumulator},
      {"tree_accumulator_to_frame_buffer", &depths.tree_accumulator_to_frame_buffer}};
  std::vector<std::string_view> keys{"all"};
  for (const auto& [name, setting] : fifos) keys.push_back(name);
  reader.allow_keys(keys);
  for (const auto& [name, setting] : fifos) {
    read(reader, "all", depth, *setting);
    read(reader, name, depth, *setting);
  }
}

}  // namespace

MachineSpec read_machine(const std::string& file, const nlohmann::json& document) {
  MachineSpec spec;
  const JsonReader root(file, document);
  root.allow_keys({"name", "clock_mhz", "goal_fps", "pixel_scan", "view_vector_generator", "intersection",
                   "pyramid_classifier", "subdivision_controller", "tree_accumulator", "frame_buffer", "fifos"});
  spec.name = root.optional_string("name").value_or(std::filesystem::path(file).stem().string());
  read(root, "clock_mhz", {0.001, 1e6}, spec.clock_mhz);
  read(root, "goal_fps", {0.001, 1e6}, spec.goal_fps);
  read_stage(root, "pixel_scan", spec.pixel_scan);
  read_stage(root, "view_vector_generator", spec.view_vector_generator);
  if (const auto intersection = root.find("intersection")) read_intersection(*intersection, spec);
  if (const auto classifier = read_stage(root, "pyramid_classifier", spec.pyramid_classifier, {"corner_row"})) {
    read(*classifier, "corner_row", {3, 65'537}, spec.corner_row);
  }
  if (const auto controller = read_stage(root, "subdivision_controller", spec.subdivision_controller, {"pool"})) {
    read(*controller, "pool", {0, 1'000'000}, spec.subdivision_pool);
  }
  if (const auto accumulator = read_stage(root, "tree_accumulator", spec.tree_accumulator, {"pixels"})) {
    read(*accumulator, "pixels", {1, 1'000'000}, spec.pixels_in_flight);
  }
  if (const auto buffer = root.find("frame_buffer")) read_frame_buffer(*buffer, spec);
  if (const auto fifos = root.find("fifos")) read_fifos(*fifos, spec.fifos);
  return spec;
}

MachineSpec load_machine(const std::optional<std::filesystem::path>& file, const std::vector<std::string>& overrides) {
  const std::string name = file ? file->string() : "default";
  nlohmann::json document = file ? read_json_file(*file) : nlohmann::json::object();
  MachineSpec spec = read_machine(name, document);
  if (overrides.empty()) return spec;
  for (const std::string& assignment : overrides) apply_override(document, assignment);
  try {
    return read_machine(name, document);
  } catch (const InputError& error) {
    throw UsageError(fmt::format("--set: {}", error.what()));
  }
}

void check_machine_holds(const MachineSpec& spec, int max_level, int columns) {
  const std::size_t required = required_pool(max_level);
  if (spec.subdivision_pool < required) {
    throw InputError(fmt::format(
        "machine {}: /subdivision_controller/pool: {} cannot hold one pixel's tree at MAX_LEVEL {}; at least {} = 3 "
        "({} - 1) + 1 is needed, or a lower MAX_LEVEL",
        excerpt(spec.name), spec.subdivision_pool, max_level, required, max_level));
  }
  if (spec.corner_row < static_cast<std::size_t>(columns) + 2) {
    throw InputError(fmt::format(
        "machine {}: /pyramid_classifier/corner_row: {} cannot hold a row of corners and one more; at least {} = {} + "
        "2 is needed, or fewer columns",
        excerpt(spec.name), spec.corner_row, columns + 2, columns));
  }
}

}  // namespace pyrasim::hw
