// SPDX-License-Identifier: Apache-2.0
#include "cli/machine_changes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "cli/nearest.h"
#include "error.h"
#include "hw_model/machine_settings.h"
#include "json/json_override.h"
#include "text/parse_number.h"
#include "text/printable.h"

namespace pyrasim::cli {
namespace {

using nlohmann::json;

[[noreturn]] void fail(const std::string& change, const std::string& why) {
  throw UsageError(fmt::format("whatif {}: {}", excerpt(change), why));
}

constexpr std::string_view every_fifo = "fifos.all";

/// "+2", "-2", "x2" or "×2".
struct RelativeValue {
  char operation;
  double number;
};

std::optional<RelativeValue> relative_value(std::string_view text) {
  constexpr std::string_view times = "×";
  char operation = text.empty() ? '\0' : text.front();
  std::size_t length = 1;
  if (text.starts_with(times)) {
    operation = 'x';
    length = times.size();
  }
  double number = 0;
  if (operation != '+' && operation != '-' && operation != 'x') return std::nullopt;
  if (!parse_whole(text.substr(length), number) || !std::isfinite(number) || number < 0) return std::nullopt;
  return RelativeValue{operation, number};
}

/// What the setting becomes: of its kind, an integer or not.
json applied(const RelativeValue& relative, const json& now) {
  const auto before = now.get<double>();
  const double after = relative.operation == 'x'   ? before * relative.number
                       : relative.operation == '+' ? before + relative.number
                                                   : before - relative.number;
  if (now.is_number_float()) return after;
  const double whole = std::round(after);
  return relative.operation == 'x' || whole == after ? json(static_cast<std::int64_t>(std::min(whole, 1e18)))
                                                     : json(after);
}

/// The settings that `change` is about.
std::vector<std::string> paths_of(const std::string& path, const hw::MachineSpec& base, const std::string& change) {
  std::vector<std::string> known{std::string(every_fifo)};
  std::vector<std::string> meant;
  hw::for_each_setting(base, [&](const std::string& setting, const auto&, const auto&) {
    known.push_back(setting);
    if (setting == path || (path == every_fifo && setting.starts_with("fifos."))) meant.push_back(setting);
  });
  if (!meant.empty()) return meant;
  const auto near = nearest(path, known);
  fail(change, near ? fmt::format("there is no such setting; {} is near", *near)
                    : "there is no such setting; those of machine files are allowed, see docs/machine.md");
}

json& at(json& document, const std::string& path) {
  json* node = &document;
  std::size_t begin = 0;
  for (std::size_t dot = path.find('.'); dot != std::string::npos; dot = path.find('.', begin)) {
    node = &(*node)[path.substr(begin, dot - begin)];
    begin = dot + 1;
  }
  return (*node)[path.substr(begin)];
}

/// `recorded`: the settings of `base`, from which relative values count.
void apply(json& document, json& recorded, const hw::MachineSpec& base, const std::string& change) {
  const std::size_t equals = change.find('=');
  if (equals == std::string::npos)
    fail(change, "there is no \"=\"; PATH=VALUE is allowed, as in intersection.units=+1");
  const std::string value = change.substr(equals + 1);
  const auto relative = relative_value(value);
  for (const std::string& path : paths_of(change.substr(0, equals), base, change)) {
    if (!relative) {
      apply_override(document, fmt::format("{}={}", path, value), "whatif");
      continue;
    }
    const json& node = at(recorded, path);
    if (!node.is_number()) fail(change, "the setting is no number; one of its names is allowed");
    at(document, path) = applied(*relative, node);
  }
}

}  // namespace

hw::MachineSpec changed_machine(const hw::MachineSpec& base, const std::vector<std::string>& changes) {
  json document = hw::settings_document(base);
  document["name"] = base.name;
  json recorded = document;
  hw::MachineSpec machine = base;
  std::vector<std::string> in_order = changes;  // a FIFO that is named is changed as that says
  std::stable_partition(in_order.begin(), in_order.end(),
                        [](const std::string& change) { return change.starts_with(std::string(every_fifo) + "="); });
  for (const std::string& change : in_order) {
    apply(document, recorded, base, change);
    try {
      machine = hw::read_machine("the machine", document);
    } catch (const InputError& error) {
      fail(change, error.what());
    }
  }
  return machine;
}

}  // namespace pyrasim::cli
