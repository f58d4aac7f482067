// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "cli/command.h"
#include "cli/machine_changes.h"
#include "cli/output_plan.h"
#include "cli/row_output.h"
#include "cli/sensitivity.h"
#include "cli/setting_axes.h"
#include "cli/statistics_document.h"
#include "cli/whatif_rows.h"
#include "error.h"
#include "run/interrupt.h"
#include "run/recorded_run.h"
#include "text/counted.h"
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
  bool sensitivity = false;

  void run() const {
    if (sensitivity && !(changes.empty() && machine.empty())) {
      throw UsageError("whatif: either CHANGE or --machine, or --sensitivity, which is of every setting");
    }
    OutputPlan outputs;
    outputs.reads("RUN", trace);
    outputs.reads("--machine", machine);
    outputs.writes_usually("--csv", csv, ".csv");
    outputs.writes_usually("--stats", stats, ".json");
    require_once();
    RecordedRun recorded;
    run_interruptibly([&] { recorded = load_recorded_run(trace); }, [] { return "while RUN was read"; });
    const std::vector<WhatifPoint> points = plan(recorded);
    for (const WhatifPoint& point : points) {
      hw::check_machine_holds(point.machine, recorded.run.max_level, recorded.run.rendered().columns);
    }
    std::optional<TextOutput> statistics;
    if (!stats.empty()) statistics.emplace(stats);
    RowOutput output(csv, outputs.table());
    if (sensitivity) {
      predict_all(recorded, output, statistics);
    } else {
      make_all(recorded, points, output, statistics);
    }
  }

  void require_once() const {
    std::set<std::string> paths;
    for (const std::string& change : changes) {
      if (const std::string path = change.substr(0, change.find('=')); !paths.insert(path).second) {
        throw UsageError(
            fmt::format("whatif {}: it is changed twice; one change of a setting is allowed, also "
                        "several values, as in {}=1,2",
                        excerpt(path), excerpt(path)));
      }
    }
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
      points.push_back(
          {name.empty() ? text : fmt::format("{} {}", name, text), changed_machine(base, combination.assignments)});
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

  /// From one simulation of the recorded machine.
  void predict_all(const RecordedRun& recorded, RowOutput& output, std::optional<TextOutput>& statistics) const {
    Task task = recorded.on(recorded.run.machine);
    task.critical_path = true;
    task.run.max_cycles = max_cycles;
    std::vector<Prediction> list;
    make_rows(
        {"recorded"}, 1, [&](std::size_t) { return task; },
        [&](std::size_t, const std::optional<Outcome>& outcome) {
          require_same_cycles(trace, recorded, *outcome);
          list = predictions(recorded.run, *outcome);
        });
    const PredictionRows rows(recorded.cycles, list);
    output.header(std::string(prediction_csv_header), rows.table_header());
    nlohmann::ordered_json document = nlohmann::ordered_json::array();
    std::size_t without_effect = 0;
    for (const Prediction& prediction : list) {
      const bool shown = rows.has_effect(prediction);
      if (!shown) ++without_effect;
      output.row(rows.csv_row(prediction), shown ? rows.table_row(prediction) : "");
      document.push_back(rows.document(prediction));
    }
    if (statistics) {
      statistics->write(text_of(
          {{"command", command_line()}, {"trace", trace}, {"cycles", recorded.cycles}, {"predictions", document}}));
    }
    output.finish(
        fmt::format("{}: less than 0.01 % each\n"
                    "estimates, from the recorded machine's critical path; pyrasim whatif RUN CHANGE says it "
                    "exactly\n",
                    counted(without_effect, "other change")));
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
  command.add_flag("--sensitivity", options->sensitivity,
                   "estimate a step of every setting from the recorded machine's critical path, and rank them");
  command.add_text("--csv", options->csv, "the rows as CSV; - for stdout").type_name("FILE|-");
  command.add_text("--stats", options->stats, "the statistics of every row as JSON; - for stdout").type_name("FILE|-");
}

}  // namespace pyrasim::cli
