// SPDX-License-Identifier: Apache-2.0
#include "cli/sensitivity.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <type_traits>

#include "cli/machine_changes.h"
#include "error.h"
#include "hw_model/machine_settings.h"

namespace pyrasim::cli {
namespace {

/// What a frame's work takes of a box, on one machine.
struct Load {
  std::string_view box;
  double busy;       ///< cycles, of all its units together
  double units = 1;  ///< that share them
  hw::Cycle latency = 0;
  hw::Cycle interval = 1;  ///< of which the latency is seen as far as it is longer
};

class Loads {
 public:
  explicit Loads(const Outcome& outcome) : outcome_(outcome) {}

  std::vector<Load> on(const hw::MachineSpec& machine) const {
    std::vector<Load> loads;
    const auto add = [&](std::string_view box, const hw::StageTiming& timing, hw::Cycle beside = 0) {
      loads.push_back({.box = box,
                       .busy = static_cast<double>(firings(box) * timing.interval + beside),
                       .latency = timing.latency,
                       .interval = timing.interval});
    };
    const auto add_testers = [&](std::string_view box, hw::Cycle busy, hw::Cycle latency) {
      loads.push_back({.box = box,
                       .busy = static_cast<double>(busy),
                       .units = static_cast<double>(machine.intersection_units),
                       .latency = latency});
    };
    const Work& work = outcome_.counts.work;
    const hw::IntersectionCost& cost = machine.intersection_cost;
    add("pixel_scan", machine.pixel_scan);
    add("view_vector_generator", machine.view_vector_generator);
    add_testers("intersection_units", firings("intersection_units") * cost.ray + cost_of(work, cost),
                machine.intersection_latency);
    add_testers(
        "shadow_units",
        firings("shadow_units") + machine.shadow_unit.ray * work.shadow.total_rays() + cost_of(work.shadow.tests, cost),
        machine.shadow_unit.latency);
    add("pyramid_classifier", machine.pyramid_classifier);
    add("subdivision_controller", machine.subdivision_controller);
    add("color_unit", machine.color_unit, cost_of(outcome_.counts.texture, machine.texture_cost));
    add("tree_accumulator", machine.tree_accumulator);
    add("frame_buffer", {1, machine.frame_buffer_interval});
    return loads;
  }

 private:
  std::uint64_t firings(std::string_view box) const {
    std::uint64_t sum = 0;
    for (const UnitAccount& unit : outcome_.units) sum += unit.box == box ? unit.cycles.firings : 0;
    return sum;
  }

  const Outcome& outcome_;
};

/// "intersection_unit_to_shadow_unit" of "intersection_unit_3_to_shadow_unit_3": without the numbers of copies.
std::string without_numbers(const std::string& name) {
  std::string text;
  for (std::size_t k = 0; k < name.size();) {
    const std::size_t end = std::min(name.find_first_not_of("0123456789", k + 1), name.size());
    if (name[k] == '_' && end > k + 1 && (end == name.size() || name.compare(end, 4, "_to_") == 0)) {
      k = end;
    } else {
      text += name[k++];
    }
  }
  return text;
}

/// The FIFOs whose depth `path` sets; empty where it sets something else.
std::string fifo_of(const std::string& path) {
  constexpr std::string_view fifos = "fifos.";
  if (path.starts_with(fifos)) return path.substr(fifos.size());
  if (path == "tree_accumulator.pixels") return "tree_accumulator_to_pixel_scan";
  if (path == "intersection.issue_order_queue") return "view_vector_generator_to_pyramid_classifier";
  return "";
}

/// The critical path, by what its cycles are owed to.
class Path {
 public:
  explicit Path(const Outcome& outcome) : outcome_(outcome) {}

  double of_box(std::string_view owed, std::string_view box) const {
    return sum(owed, [&](const std::string& place) {
      return std::any_of(outcome_.units.begin(), outcome_.units.end(),
                         [&](const UnitAccount& unit) { return unit.name == place && unit.box == box; });
    });
  }
  double of_fifo(const std::string& fifo) const {
    return sum("room", [&](const std::string& place) { return without_numbers(place) == fifo; });
  }

 private:
  double sum(std::string_view owed, const auto& is_there) const {
    double cycles = 0;
    for (const PathAccount& account : outcome_.critical_path) {
      if (account.owed == owed && is_there(account.place)) cycles += static_cast<double>(account.cycles);
    }
    return cycles;
  }

  const Outcome& outcome_;
};

/// How much longer the path is expected to become where `before` is `after`.
double lengthened(const Path& path, const Load& before, const Load& after) {
  if (before.busy == 0) return 0;
  const double work = after.busy / before.busy;
  double cycles = path.of_box("occupied", before.box) * (work * before.units / after.units - 1) +
                  path.of_box("service", before.box) * (work - 1);
  if (before.latency > before.interval) {
    const auto each = static_cast<double>(before.latency - before.interval);
    const double longer = static_cast<double>(after.latency) - static_cast<double>(before.latency);
    cycles += path.of_box("latency", before.box) / each * longer;
  }
  return cycles;
}

/// Steps of a setting.
std::vector<std::string> steps_of(const std::string& path) {
  if (!fifo_of(path).empty() || path == "subdivision_controller.pool") return {path + "=x2", path + "=x0.5"};
  return {path + "=-1", path + "=+1"};
}

/// None where there is no such machine, or it is the same.
std::optional<hw::MachineSpec> machine_after(const std::string& change, const Run& run) {
  try {
    hw::MachineSpec machine = changed_machine(run.machine, {change});
    hw::check_machine_holds(machine, run.max_level, run.rendered().columns);
    return machine == run.machine ? std::nullopt : std::optional(std::move(machine));
  } catch (const Error&) {
    return std::nullopt;
  }
}

}  // namespace

std::vector<Prediction> predictions(const Run& run, const Outcome& outcome) {
  const Path path(outcome);
  const Loads loads(outcome);
  const std::vector<Load> before = loads.on(run.machine);
  std::vector<Prediction> list;
  hw::for_each_setting(run.machine, [&](const std::string& setting, const auto& value, const auto&) {
    if constexpr (std::is_integral_v<std::decay_t<decltype(value)>>) {
      if (setting == "pyramid_classifier.line_buffer") return;  // there is room, or no machine
      for (const std::string& change : steps_of(setting)) {
        const auto machine = machine_after(change, run);
        if (!machine) continue;
        const std::vector<Load> after = loads.on(*machine);
        auto expected = static_cast<double>(outcome.cycles);
        double least = 0;
        for (std::size_t k = 0; k < before.size(); ++k) {
          expected += lengthened(path, before[k], after[k]);
          least = std::max(least, after[k].busy / after[k].units);
        }
        if (const std::string fifo = fifo_of(setting); !fifo.empty()) {
          expected += path.of_fifo(fifo) * (change.ends_with("=x2") ? -0.5 : 1);
        }
        list.push_back({change, static_cast<hw::Cycle>(std::llround(std::max(least, expected)))});
      }
    }
  });
  std::stable_sort(list.begin(), list.end(),
                   [](const Prediction& a, const Prediction& b) { return a.cycles < b.cycles; });
  return list;
}

}  // namespace pyrasim::cli
