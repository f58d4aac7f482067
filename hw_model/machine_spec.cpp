// SPDX-License-Identifier: Apache-2.0
#include "hw_model/machine_spec.h"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>

#include "error.h"
#include "hw_model/machine_settings.h"
#include "json/json_file.h"
#include "json/json_override.h"
#include "json/json_reader.h"
#include "text/counted.h"
#include "text/printable.h"

namespace pyrasim::hw {
namespace {

using Paths = std::vector<std::string>;

/// Those that a machine file may hold: settings, and what stands for several or is for people.
Paths allowed_paths() {
  Paths paths{"name"};
  const MachineSpec spec;
  for_each_setting(spec, [&](const std::string& path, const auto&, const auto&) {
    if (path.starts_with("fifos.") && !paths.back().starts_with("fifos.")) paths.emplace_back("fifos.all");
    paths.push_back(path);
  });
  return paths;
}

/// Refuses keys of `reader`, and of the objects in it, that are in none of `paths`; these begin with `prefix`.
void allow_paths(const JsonReader& reader, const Paths& paths, const std::string& prefix) {
  std::vector<std::string_view> keys;
  std::vector<std::string_view> groups;
  for (const std::string_view path : paths) {
    if (!path.starts_with(prefix)) continue;
    const std::string_view rest = path.substr(prefix.size());
    const std::string_view key = rest.substr(0, rest.find('.'));
    if (!keys.empty() && keys.back() == key) continue;
    keys.push_back(key);
    if (key.size() < rest.size()) groups.push_back(key);
  }
  reader.allow_keys(keys);
  for (const std::string_view group : groups) {
    if (const auto found = reader.find(group)) allow_paths(*found, paths, fmt::format("{}{}.", prefix, group));
  }
}

/// The node at `path`; none where the file does not say it.
std::optional<JsonReader> find(const JsonReader& root, std::string_view path) {
  const std::size_t dot = path.find('.');
  auto node = root.find(path.substr(0, dot));
  return node && dot != std::string_view::npos ? find(*node, path.substr(dot + 1)) : std::move(node);
}

template <class Integer>
Integer value(const JsonReader& node, Integer, const IntegerRange& range) {
  return static_cast<Integer>(node.integer(range));
}
double value(const JsonReader& node, double, const NumberRange& range) { return node.number(range); }

Dispatch value(const JsonReader& node, Dispatch, const decltype(dispatch_names)& names) {
  return node.choice<Dispatch>({{names[0].first, names[0].second}, {names[1].first, names[1].second}});
}

/// A key that machine files once had.
struct FormerKey {
  std::string_view group, key, why, instead;
};
constexpr std::array former_keys{
    FormerKey{"frame_buffer", "latency", "nothing waits for what the frame buffer stores, so that it has no latency",
              "remove it; allowed keys: interval"},
    FormerKey{"intersection", "reorder_buffer", "has another name now", "issue_order_queue is allowed"},
    FormerKey{"pyramid_classifier", "corner_row", "has another name now", "line_buffer is allowed"},
    FormerKey{"fifos", "pyramid_classifier_to_tree_accumulator", "the colour unit stands between the two now",
              "pyramid_classifier_to_color_unit and color_unit_to_tree_accumulator are allowed"},
};

void refuse_former_keys(const JsonReader& root) {
  for (const auto& [group, key, why, instead] : former_keys) {
    const auto found = root.find(group);
    if (found && found->has(key)) found->member(key).fail(std::string(why), std::string(instead));
  }
}

/// How many settings differ.
std::size_t differing(const MachineSpec& a, const MachineSpec& b) {
  const auto first = settings_document(a).flatten();
  const auto second = settings_document(b).flatten();
  std::size_t count = 0;
  for (const auto& [path, value] : first.items()) count += second[path] != value ? 1 : 0;
  return count;
}

}  // namespace

std::string MachineSpec::title() const {
  return overridden == 0 ? name : fmt::format("{} + {}", name, counted(overridden, "setting"));
}

MachineSpec read_machine(const JsonReader& root) {
  MachineSpec spec;
  refuse_former_keys(root);
  allow_paths(root, allowed_paths(), "");
  spec.name = root.optional_string("name").value_or(std::filesystem::path(root.file()).stem().string());
  const auto every_fifo = find(root, "fifos.all");
  for_each_setting(spec, [&](const std::string& path, auto& setting, const auto& allowed) {
    if (every_fifo && path.starts_with("fifos.")) setting = value(*every_fifo, setting, allowed);
    if (const auto node = find(root, path)) setting = value(*node, setting, allowed);
  });
  return spec;
}

MachineSpec read_machine(const std::string& file, const nlohmann::json& document) {
  return read_machine(JsonReader(file, document));
}

MachineSpec load_machine(const std::optional<std::filesystem::path>& file, const std::vector<std::string>& overrides) {
  const std::string name = file ? file->string() : "default";
  nlohmann::json document = file ? read_json_file(*file) : nlohmann::json::object();
  const MachineSpec spec = read_machine(name, document);
  for (const std::string& assignment : overrides) apply_override(document, assignment);
  try {
    MachineSpec changed = read_machine(name, document);
    changed.overridden = differing(spec, changed);
    return changed;
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
  if (spec.line_buffer < static_cast<std::size_t>(columns) + 2) {
    throw InputError(fmt::format(
        "machine {}: /pyramid_classifier/line_buffer: {} cannot hold a row of corners and one more; at least {} = {} + "
        "2 is needed, or fewer columns",
        excerpt(spec.name), spec.line_buffer, columns + 2, columns));
  }
}

}  // namespace pyrasim::hw
