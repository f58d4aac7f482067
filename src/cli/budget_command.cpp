// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/asked_run.h"
#include "cli/budget_search.h"
#include "cli/command.h"
#include "cli/critical_settings.h"
#include "cli/machine_options.h"
#include "cli/output_plan.h"
#include "cli/statistics_document.h"
#include "run/interrupt.h"
#include "text/counted.h"
#include "text/printable.h"

namespace pyrasim::cli {
namespace {

/// What became of a change of one setting or of two.
struct Change {
  struct Step {
    std::string setting, from, to;
  };
  std::vector<Step> steps;  ///< to the smallest change that meets the budget, or to the largest
  bool met;
  FrameOutcome outcome;  ///< its bottleneck only where the budget is not met
  double fps;
  BudgetFrame frame;
};

Change change_to(const std::vector<const BudgetSetting*>& settings, const BudgetFrame& asked,
                 const BudgetFrame& changed, bool met, const FrameOutcome& outcome) {
  Change change{{}, met, outcome, frames_per_second(changed.run, outcome.cycles), changed};
  for (const BudgetSetting* setting : settings) {
    change.steps.push_back({setting->name, setting->value(asked), setting->value(changed)});
  }
  return change;
}

/// The smallest change of the settings that is enough, or how far the largest one of all of them comes.
Change change_of(const std::vector<const BudgetSetting*>& settings, const BudgetFrame& asked, BudgetFrames& frames) {
  const auto enough = settings.size() == 1 ? smallest_change(*settings[0], asked, frames)
                                           : smallest_pair(*settings[0], *settings[1], asked, frames);
  if (enough) return change_to(settings, asked, enough->frame, true, {enough->cycles, {}});
  BudgetFrame largest = asked;
  for (const BudgetSetting* setting : settings) {
    if (setting->can_change(largest)) largest = setting->with(largest, setting->largest_change);
  }
  return change_to(settings, asked, largest, false, frames.outcome(largest));
}

/// What was tried.
struct Changes {
  std::vector<BudgetSetting> settings;
  std::vector<Change> alone;  ///< of each setting, and of those that the critical path leads to
  std::vector<Change> pairs;  ///< where one alone is not enough

  Changes(const BudgetFrame& asked, BudgetFrames& frames) : settings(budget_settings(asked)) {
    alone.push_back(change_of({&settings[0]}, asked, frames));
    // Where more units do not help, what caps them may have an interval to shorten.
    if (!alone[0].met) {
      if (const auto interval = interval_setting(asked, alone[0].outcome.bottleneck.back().unit)) {
        settings.insert(settings.begin() + 1, *interval);
      }
    }
    for (std::size_t k = 1; k < settings.size(); ++k) alone.push_back(change_of({&settings[k]}, asked, frames));
    for (std::size_t k = 0; k < settings.size(); ++k) {
      for (std::size_t other = k + 1; other < settings.size(); ++other) try_pair(k, other, asked, frames);
    }
    for (const BudgetSetting& setting : critical_settings(asked, frames, settings)) {
      alone.push_back(change_of({&setting}, asked, frames));
    }
    for (const std::vector<Change>* changes : {&alone, &pairs}) {
      for (const Change& change : *changes) {
        if (change.met) frames.confirm(change.frame);
      }
    }
  }

  /// The one that is not enough alone comes first.
  void try_pair(std::size_t first, std::size_t second, const BudgetFrame& asked, BudgetFrames& frames) {
    if (alone[first].met) std::swap(first, second);
    if (alone[first].met || !settings[first].can_change(asked) || !settings[second].can_change(asked)) return;
    const Change pair = change_of({&settings[first], &settings[second]}, asked, frames);
    const bool first_helps = !alone[second].met || pair.steps[1].to != alone[second].steps[0].to;
    if (first_helps) pairs.push_back(pair);
  }
};

/// A line's beginning: one step in columns, two side by side.
std::string steps_text(const Change& change, std::size_t name_width) {
  if (change.steps.size() == 1) {
    const Change::Step& step = change.steps.front();
    return fmt::format("{:<{}}  {:>9} -> {:<9}", step.setting, name_width, step.from, step.to);
  }
  std::string text;
  for (const Change::Step& step : change.steps) {
    text += fmt::format("{}{} {} -> {}", text.empty() ? "" : ", ", step.setting, step.from, step.to);
  }
  return text;
}

std::string change_lines(const std::vector<Change>& changes) {
  std::size_t name_width = 0;
  for (const Change& change : changes) name_width = std::max(name_width, change.steps.front().setting.size());
  std::size_t width = 0;
  for (const Change& change : changes) width = std::max(width, steps_text(change, name_width).size());
  std::string text;
  for (const Change& change : changes) {
    text += fmt::format("  {:<{}}  {:>12} cycles  {:>8.1f} frames per second\n", steps_text(change, name_width), width,
                        change.outcome.cycles, change.fps);
    if (!change.met) text += fmt::format("      not enough: capped by {}\n", hw::cause_text(change.outcome.bottleneck));
  }
  return text;
}

nlohmann::ordered_json outcome_document(const Change& change) {
  nlohmann::ordered_json document{
      {"met", change.met}, {"cycles", change.outcome.cycles}, {"frames_per_second", change.fps}};
  if (!change.met) {
    const std::vector<hw::BottleneckLink>& chain = change.outcome.bottleneck;
    document["capped_by"] = {
        {"unit", chain.back().unit}, {"busy", chain.back().busy}, {"closes_loop", hw::closes_loop(chain)}};
  }
  return document;
}

nlohmann::ordered_json step_document(const Change::Step& step) {
  return {{"setting", step.setting}, {"from", step.from}, {"to", step.to}};
}

nlohmann::ordered_json changes_document(const std::vector<Change>& changes) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Change& change : changes) {
    list.push_back(step_document(change.steps.front()));
    list.back().update(outcome_document(change));
  }
  return list;
}

nlohmann::ordered_json pairs_document(const std::vector<Change>& pairs) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Change& pair : pairs) {
    list.push_back({{"changes", {step_document(pair.steps[0]), step_document(pair.steps[1])}}});
    list.back().update(outcome_document(pair));
  }
  return list;
}

struct BudgetCommand {
  FrameOptions frame;
  MachineOptions machine;
  std::optional<double> fps;
  std::string stats;

  void run() const {
    AskedRun read = asked_run(frame, machine);
    if (fps) read.run.machine.goal_fps = *fps;
    const BudgetFrame asked{std::move(read.run), std::move(read.scene), {}};
    OutputPlan plan;
    plan.reads("SCENE", asked.scene->files);
    plan.reads("--machine", machine.file);
    plan.writes_usually("--stats", stats, ".json");
    std::optional<TextOutput> statistics;
    if (!stats.empty()) statistics.emplace(stats);

    std::optional<BudgetFrames> frames;
    std::optional<hw::Cycle> cycles;
    std::optional<Changes> changes;
    run_interruptibly(
        [&] {
          frames.emplace(asked);
          cycles = frames->make_asked(machine.max_cycles);
          if (*cycles > asked.run.machine.budget()) changes.emplace(asked, *frames);
        },
        [&] { return cycles ? "while changes were tried" : "in the frame as asked for"; });
    if (statistics) statistics->write(text_of(document(asked, *cycles, changes, *frames)));
    plan.table() << table(asked, *cycles, changes);
  }

  std::string table(const BudgetFrame& asked, hw::Cycle cycles, const std::optional<Changes>& changes) const {
    const Screen& screen = asked.run.screen;
    const double reached = frames_per_second(asked.run, cycles);
    const double goal = asked.run.machine.goal_fps;
    std::string text = fmt::format("{} at {}x{} pixels, MAX_LEVEL {}, on machine {}\n{}, {:.1f} frames per second\n",
                                   one_line(frame.scene), screen.columns, screen.rows, asked.run.max_level,
                                   excerpt(asked.run.machine.title()), counted(cycles, "cycle"), reached);
    text += fmt::format("budget: {} for {} {} per second, {} by {:.1f} %\n",
                        counted(asked.run.machine.budget(), "cycle"), goal, goal == 1 ? "frame" : "frames",
                        changes ? "missed" : "met", 100 * std::abs(reached / goal - 1));
    if (!changes) return text;
    text += "\nthe smallest changes that meet it, each alone:\n" + change_lines(changes->alone);
    if (!changes->pairs.empty()) {
      text += "\nand of two together, where one alone is not enough:\n" + change_lines(changes->pairs);
    }
    return text;
  }

  nlohmann::ordered_json document(const BudgetFrame& asked, hw::Cycle cycles, const std::optional<Changes>& changes,
                                  const BudgetFrames& frames) const {
    return {{"command", command_line()},
            {"scene", frame.scene},
            {"machine", asked.run.machine.name},
            {"cycles", cycles},
            {"frames_per_second", frames_per_second(asked.run, cycles)},
            {"budget",
             {{"goal_fps", asked.run.machine.goal_fps}, {"cycles", asked.run.machine.budget()}, {"met", !changes}}},
            {"simulated", frames.simulated()},
            {"replayed", frames.replayed()},
            {"changes", changes_document(changes ? changes->alone : std::vector<Change>())},
            {"pairs", pairs_document(changes ? changes->pairs : std::vector<Change>())}};
  }
};

}  // namespace

void add_budget_command(const Command& program) {
  auto options = std::make_shared<BudgetCommand>();
  const Command command = program.add_command(
      "budget",
      "Say whether a machine meets a frame rate, and the smallest changes, alone or two together, that make it do so.",
      [options] { options->run(); });
  add_frame_options(command, options->frame);
  add_scalar_option(command, options->frame.scalar);
  options->machine.add(command);
  options->machine.add_limit(command);
  command.add_number("--fps", options->fps, 0.001, 1e6, "frames per second to reach; the machine's goal without it")
      .type_name("F");
  command.add_text("--stats", options->stats, "the result as JSON; - for stdout").type_name("FILE|-");
}

}  // namespace pyrasim::cli
