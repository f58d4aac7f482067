// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/command.h"
#include "cli/machine_changes.h"
#include "cli/output_plan.h"
#include "cli/row_output.h"
#include "cli/setting_axes.h"
#include "cli/statistics_document.h"
#include "cli/whatif_rows.h"
#include "error.h"
#include "run/recorded_run.h"
#include "text/printable.h"

namespace pyrasim::cli {
namespace {

struct WhatifCommand {
  std::string trace;
  std::vector<std::string> changes;
  std::string machine;
  hw::Cycle max_cycles = hw::never;
  JobOption jobs;
  std::string csv;
  std::string stats;

  void run() const {
    OutputPlan outputs;
    outputs.reads("RUN", trace);
    outputs.reads("--machine", machine);
    outputs.writes("--csv", csv);
    outputs.writes("--stats", stats);
    const RecordedRun recorded = load_recorded_run(trace);
    const std::vector<WhatifPoint> points = plan(recorded);
    for (const WhatifPoint& point : points) {
      hw::check_machine_holds(point.machine, recorded.run.max_level, recorded.run.rendered().columns);
    }
    std::optional<TextOutput> statistics;
    if (!stats.empty()) statistics.emplace(stats);
    RowOutput output(csv, outputs.table());
    make_all(recorded, points, output, statistics);
  }

  /// The recorded machine, and those that are asked for.
  std::vector<WhatifPoint> plan(const RecordedRun& recorded) const {
    std::vector<WhatifPoint> points{{"recorded", recorded.run.machine}};
    hw::MachineSpec base = recorded.run.machine;
    std::string name;
    if (!machine.empty()) {
      base = hw::load_machine(machine);
      name = one_line(base.name);
      points.push_back({name, base});
    }
    for (const SettingAxes::Combination& combination : SettingAxes(changes).combinations) {
      if (combination.assignments.empty()) continue;
      const std::string text = one_line(fmt::format("{}", fmt::join(combination.assignments, " ")));
      points.push_back({name.empty() ? text : name + " " + text, changed_machine(base, combination.assignments)});
    }
    return points;
  }

  void make_all(const RecordedRun& recorded, const std::vector<WhatifPoint>& points, RowOutput& output,
                std::optional<TextOutput>& statistics) const {
    const WhatifRows rows(one_line(trace), recorded.run, points);
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    std::vector<std::string> names;
    names.reserve(points.size());
    for (const WhatifPoint& point : points) names.push_back(point.change);
    output.header(std::string(whatif_csv_header), rows.table_header());
    const auto prepare = [&](std::size_t k) {
      Task task = recorded.on(points[k].machine);
      task.run.max_cycles = max_cycles;
      task.occupancies = statistics.has_value();
      return task;
    };
    make_rows(names, jobs.at_once(), prepare, [&](std::size_t k, const std::optional<Outcome>& outcome) {
      if (k == 0) require_same_cycles(trace, recorded, *outcome);
      const WhatifRow row{points[k], *outcome, recorded.cycles};
      output.row(rows.csv_row(row), rows.table_row(row));
      if (statistics) list.push_back(rows.document(row));
    });
    if (statistics) statistics->write(text_of({{"command", command_line()}, {"trace", trace}, {"points", list}}));
    output.finish("");
  }
};

}  // namespace

void add_whatif_command(const Command& program) {
  auto options = std::make_shared<WhatifCommand>();
  const Command command = program.add_command(
      "whatif", "Simulate a recorded frame on other machines, in exact cycles and without tracing a ray.",
      [options] { options->run(); });
  command.add_text("RUN", options->trace, "the recorded frame, of simulate --trace RUN.ptrace").required();
  command.add_arguments("CHANGE", options->changes,
                        "a setting of the machine and its value: 4, +1, -1, x2, a list of values (1,2,4) or a range "
                        "(1..8), as in intersection.units=+1; several are changed together");
  command.add_text("--machine", options->machine, "another machine (JSON) to change; the recorded one without it")
      .type_name("FILE");
  command
      .add_integer("--max-cycles", options->max_cycles, 1, hw::never - 1,
                   "give up on a frame that takes longer: exit code 4")
      .type_name("N");
  options->jobs.add(command);
  command.add_text("--csv", options->csv, "the rows as CSV; - for stdout").type_name("FILE|-");
  command.add_text("--stats", options->stats, "the statistics of every row as JSON; - for stdout").type_name("FILE|-");
}

}  // namespace pyrasim::cli
