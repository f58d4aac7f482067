// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/between.h"
#include "cli/command.h"
#include "cli/machine_options.h"
#include "cli/output_plan.h"
#include "cli/simulate_apart.h"
#include "cli/statistics_document.h"
#include "error.h"
#include "render/picture_memory.h"

namespace pyrasim::cli {
namespace {

// What a machine file may say.
constexpr std::size_t most_units = 256;
constexpr double most_mhz = 1e6;

/// A frame on a machine, as asked for or with one change.
struct Frame {
  Scene scene;
  hw::MachineSpec spec;
  hw::SimulationOptions options;

  ApartResult simulate(hw::Cycle max_cycles) const {
    hw::SimulationOptions limited = options;
    limited.max_cycles = max_cycles;
    return simulate_apart(scene, spec, limited);
  }
  /// Its cycles, where they are within the budget.
  std::optional<hw::Cycle> cycles_within_budget() const { return simulate(spec.budget()).cycles; }
  double fps(hw::Cycle cycles) const { return spec.clock_mhz * 1e6 / static_cast<double>(cycles); }
};

/// What became of one kind of change.
struct Change {
  std::string setting;
  std::string from;
  std::string to;                   ///< of the smallest change that meets the budget, or of the largest that was tried
  std::optional<hw::Cycle> cycles;  ///< none: no change of this kind is enough
  double fps = 0;
};

/// `frame` with a setting at `value`.
using Vary = std::function<Frame(int value)>;

/// The first value from `from` (not enough) towards `to` whose frame meets the budget, and its cycles; by bisection, so
/// that it is the first if every further one does too.
std::optional<std::pair<int, hw::Cycle>> first_that_meets(int from, int to, const Vary& vary) {
  const auto cycles_at = [&](int value) { return vary(value).cycles_within_budget(); };
  auto cycles = cycles_at(to);
  if (!cycles) return std::nullopt;
  while (std::abs(to - from) > 1) {
    const int middle = from + (to - from) / 2;
    if (const auto found = cycles_at(middle)) {
      to = middle;
      cycles = found;
    } else {
      from = middle;
    }
  }
  return std::pair(to, *cycles);
}

Change change(const std::string& setting, int from, int to, const Vary& vary,
              const std::function<std::string(int)>& name) {
  Change change{setting, name(from), name(to), std::nullopt};
  if (from == to) return change;
  if (const auto found = first_that_meets(from, to, vary)) {
    change.to = name(found->first);
    change.cycles = found->second;
    change.fps = vary(found->first).fps(found->second);
  }
  return change;
}

Change change_units(const Frame& frame) {
  const auto units = static_cast<int>(frame.spec.intersection_units);
  const Vary vary = [&](int value) {
    Frame varied = frame;
    varied.spec.intersection_units = static_cast<std::size_t>(value);
    return varied;
  };
  int enough = units;  // doubling first: a machine of 256 units is slow to simulate
  for (int next = std::min<int>(2 * units, most_units); next > enough; next = std::min<int>(2 * next, most_units)) {
    enough = next;
    if (vary(next).cycles_within_budget()) break;
  }
  return change("intersection.units", std::min(units, enough), enough, vary,
                [](int value) { return std::to_string(value); });
}

/// The cycles stay; the clock is simulated all the same.
Change change_clock(const Frame& frame, hw::Cycle cycles) {
  const double least = static_cast<double>(cycles) * frame.spec.goal_fps / 1e6;
  Frame varied = frame;
  varied.spec.clock_mhz = std::min(std::ceil(least), most_mhz);
  Change change{"clock_mhz", fmt::format("{}", frame.spec.clock_mhz), fmt::format("{}", varied.spec.clock_mhz),
                varied.cycles_within_budget()};
  if (change.cycles) change.fps = varied.fps(*change.cycles);
  return change;
}

Change change_level(const Frame& frame) {
  const Vary vary = [&](int value) {
    Frame varied = frame;
    varied.options.max_level = value;
    return varied;
  };
  return change("max_level", frame.options.max_level, 0, vary, [](int value) { return std::to_string(value); });
}

Change change_size(const Frame& frame) {
  const Screen& screen = frame.scene.camera.screen;
  const auto rows = [&](int columns) {
    return std::max(1, static_cast<int>(std::lround(static_cast<double>(columns) * screen.rows / screen.columns)));
  };
  const Vary vary = [&](int columns) {
    Frame varied = frame;
    varied.scene.camera.screen = resized(screen, columns, rows(columns));
    return varied;
  };
  return change("size", screen.columns, 1, vary,
                [&](int columns) { return fmt::format("{}x{}", columns, rows(columns)); });
}

struct BudgetCommand {
  FrameOptions frame;
  MachineOptions machine;
  std::optional<double> fps;
  std::string stats;

  void run() const {
    Frame asked{frame.load(), machine.load(), {}};
    if (fps) asked.spec.goal_fps = *fps;
    const Screen& screen = asked.scene.camera.screen;
    asked.options.max_level = parse_max_level(frame.max_level, screen);
    asked.options.leaf = frame.leaf;
    check_addressable(screen, asked.options.max_level);
    check_picture_fits(asked.scene.camera.rendered());
    asked.options.formats = frame.formats(screen, std::int64_t{1} << asked.options.max_level);
    hw::check_machine_holds(asked.spec, asked.options.max_level, screen.columns);
    OutputPlan plan;
    plan.reads("SCENE", asked.scene.files);
    plan.reads("--machine", machine.file);
    plan.writes("--stats", stats);
    std::optional<TextOutput> statistics;
    if (!stats.empty()) statistics.emplace(stats);

    const auto [cycles, why_unfinished] = asked.simulate(machine.max_cycles);
    if (!cycles) throw LimitError(why_unfinished);
    std::vector<Change> changes;
    if (*cycles > asked.spec.budget()) {
      changes = {change_units(asked), change_clock(asked, *cycles), change_level(asked), change_size(asked)};
    }
    if (statistics) statistics->write(text_of(document(asked, *cycles, changes)));
    plan.table() << table(asked, *cycles, changes);
  }

  std::string table(const Frame& asked, hw::Cycle cycles, const std::vector<Change>& changes) const {
    const Screen& screen = asked.scene.camera.screen;
    const double reached = asked.fps(cycles);
    const double goal = asked.spec.goal_fps;
    std::string text = fmt::format(
        "{} at {}x{} pixels, MAX_LEVEL {}, on machine {}\n{} cycles, {:.1f} frames per second\n", frame.scene,
        screen.columns, screen.rows, asked.options.max_level, asked.spec.name, cycles, reached);
    text += fmt::format("budget: {} cycles for {} frames per second, {} by {:.1f} %\n", asked.spec.budget(), goal,
                        changes.empty() ? "met" : "missed", 100 * std::abs(reached / goal - 1));
    if (changes.empty()) return text;
    text += "\nthe smallest changes that meet it, each alone and simulated:\n";
    for (const Change& change : changes) {
      if (change.cycles) {
        text += fmt::format("  {:<18}  {:>9} -> {:<9}  {:>12} cycles  {:>8.1f} frames per second\n", change.setting,
                            change.from, change.to, *change.cycles, change.fps);
      } else {
        text += fmt::format("  {:<18}  {:>9} -> {:<9}  not enough\n", change.setting, change.from, change.to);
      }
    }
    return text;
  }

  nlohmann::ordered_json document(const Frame& asked, hw::Cycle cycles, const std::vector<Change>& changes) const {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Change& change : changes) {
      list.push_back({{"setting", change.setting}, {"from", change.from}, {"to", change.to}});
      list.back()["met"] = change.cycles.has_value();
      if (change.cycles) {
        list.back()["cycles"] = *change.cycles;
        list.back()["frames_per_second"] = change.fps;
      }
    }
    return {{"command", command_line()},
            {"scene", frame.scene},
            {"machine", asked.spec.name},
            {"cycles", cycles},
            {"frames_per_second", asked.fps(cycles)},
            {"budget", {{"goal_fps", asked.spec.goal_fps}, {"cycles", asked.spec.budget()}, {"met", changes.empty()}}},
            {"changes", list}};
  }
};

}  // namespace

void add_budget_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<BudgetCommand>();
  CLI::App* command = app.add_subcommand(
      "budget", "Say whether a machine meets a frame rate, and the smallest changes that make it do so.");
  add_frame_options(*command, options->frame);
  add_scalar_option(*command, options->frame.scalar);
  options->machine.add(*command);
  command->add_option("--fps", options->fps, "frames per second to reach; the machine's goal without it")
      ->type_name("F")
      ->check(between(0.001, 1e6));
  command->add_option("--stats", options->stats, "the result as JSON; - for stdout")->type_name("FILE|-");
  command->callback([&action, options] { action = [options] { options->run(); }; });
}

}  // namespace pyrasim::cli
