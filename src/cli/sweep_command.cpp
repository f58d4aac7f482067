// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>

#include "cli/asked_run.h"
#include "cli/command.h"
#include "cli/finished_rows.h"
#include "cli/output_plan.h"
#include "cli/row_output.h"
#include "cli/sweep_plan.h"
#include "cli/sweep_rows.h"
#include "error.h"
#include "image/image_error.h"
#include "render/picture_memory.h"
#include "run/executor.h"
#include "run/interrupt.h"
#include "scene/load_scene.h"
#include "text/counted.h"
#include "text/printable.h"

namespace pyrasim::cli {
namespace {

/// What the points of one scene on one screen share.
struct Shared {
  std::shared_ptr<const Scene> scene;
  std::shared_ptr<const Intersector> intersector;
  std::shared_ptr<const Rendering> truth;  ///< by the reference; none where nothing is measured
};

struct SweepCommand {
  std::vector<std::string> scenes;
  FrameAxes frames;
  std::string reference = "grid:32";
  MachineOptions machine;
  JobOption jobs;
  std::string csv;
  std::string resumed;

  void run() const {
    const std::optional<Method> peer = reference == "none" ? std::nullopt : std::optional(parse_method(reference));
    if (!csv.empty() && !resumed.empty())
      throw UsageError("sweep: either --csv, or --resume, which is written likewise");
    if (resumed == "-") throw UsageError("--resume -: a file that can be read and written is allowed");
    OutputPlan outputs;
    const std::vector<std::shared_ptr<const Scene>> loaded = load(outputs);
    outputs.reads("--machine", machine.file);
    outputs.writes_usually("--csv", csv, ".csv");
    outputs.writes_usually("--resume", resumed, ".csv");
    const MachineAxes machines(machine);
    std::vector<SweepPoint> points = plan(loaded, machines);
    check(points);
    const FinishedRows finished =
        resumed.empty() ? FinishedRows() : FinishedRows(resumed, std::string(sweep_csv_header), sweep_key_fields);
    const std::size_t planned = points.size();
    // Files that can be read once have no SHA-256: nobody knows whether they are the same as before.
    std::erase_if(points, [&](const SweepPoint& point) {
      return !point.run.scene.sha256.empty() && finished.holds(sweep_key(point));
    });
    if (points.empty()) {
      outputs.table() << last_lines(peer, planned, 0);
      return;
    }
    const SweepTable table(scenes, machines);
    RowOutput output(resumed.empty() ? csv : resumed, outputs.table());
    output.header(std::string(sweep_csv_header) + finished.text(), table.header());
    make_all(points, table, peer, output);
    output.finish(last_lines(peer, planned, points.size()));
  }

  std::vector<std::shared_ptr<const Scene>> load(OutputPlan& outputs) const {
    std::vector<std::shared_ptr<const Scene>> loaded;
    for (const std::string& name : scenes) {
      loaded.push_back(std::make_shared<const Scene>(load_scene(name)));
      print_warnings(*loaded.back());
      outputs.reads("SCENE", loaded.back()->files);
    }
    return loaded;
  }

  std::vector<SweepPoint> plan(const std::vector<std::shared_ptr<const Scene>>& loaded,
                               const MachineAxes& machines) const {
    std::vector<SweepPoint> points;
    Run run;
    run.max_cycles = machine.max_cycles;
    run.reference = reference;
    for (std::size_t k = 0; k < scenes.size(); ++k) {
      run.scene = files_of(scenes[k], *loaded[k]);
      frames.add_points(points, run, loaded[k], machines);
    }
    return points;
  }

  void check(const std::vector<SweepPoint>& points) const {
    std::vector<PixelWindow> pictures;
    std::vector<PixelWindow> references;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const Run& run = points[k].run;
      check_addressable(run.screen, run.max_level);
      check_picture_fits(run.rendered());
      hw::check_machine_holds(run.machine, run.max_level, run.screen.columns);
      pictures.push_back(run.rendered());
      if (reference != "none" && (k == 0 || !points[k].same_reference(points[k - 1]))) {
        references.push_back(run.rendered());
      }
    }
    check_pictures_fit(pictures, references, jobs.at_once());
  }

  void make_all(const std::vector<SweepPoint>& points, const SweepTable& table, const std::optional<Method>& peer,
                RowOutput& output) const {
    std::vector<std::string> names;
    names.reserve(points.size());
    for (const SweepPoint& point : points) names.push_back(table.name_of(point));
    Shared shared;
    const auto prepare = [&](std::size_t k) {
      if (k == 0 || !points[k].same_reference(points[k - 1])) {
        shared = {};
        shared = prepare_for(points[k], peer);
      }
      return task(points[k].run, shared);
    };
    make_rows(names, jobs.at_once(), prepare, [&](std::size_t k, const std::optional<Outcome>& outcome) {
      output.row(sweep_csv_row(points[k], *outcome), table.line(points[k], *outcome));
    });
  }

  static Shared prepare_for(const SweepPoint& point, const std::optional<Method>& peer) {
    auto scene = std::make_shared<Scene>(*point.scene);
    scene->camera.screen = point.run.screen;
    Shared shared{scene, make_intersector(*scene), nullptr};
    if (peer) {
      shared.truth = std::make_shared<const Rendering>(render(*scene, *peer, {}, 0, progress_bar("reference")));
    }
    stop_if_interrupted();
    return shared;
  }

  static Task task(const Run& run, const Shared& shared) {
    Task task{run, shared.scene, shared.intersector};
    if (!shared.truth) return task;
    task.measure = [truth = shared.truth](const Simulation& finished, Outcome& outcome) {
      const auto [rmse, maximum] = image_error(finished.image(), truth->image);
      outcome.error = {rmse, maximum, truth->statistics.total_rays()};
    };
    return task;
  }

  std::string last_lines(const std::optional<Method>& peer, std::size_t planned, std::size_t made) const {
    std::string text = peer ? fmt::format("errors: linear RGB against {}\n", peer->name()) : "";
    if (!resumed.empty()) {
      text += fmt::format("{} of {} {} in {}\n", planned - made, counted(planned, "row"),
                          of_number(planned - made, "was", "were"), one_line(resumed));
    }
    return text;
  }
};

}  // namespace

void add_sweep_command(const Command& program) {
  auto options = std::make_shared<SweepCommand>();
  const Command command = program.add_command(
      "sweep",
      "Simulate every combination of scene, size, setting, level and edge, and measure each against a reference; a row "
      "is written as soon as it is done.",
      [options] { options->run(); });
  command.add_arguments("SCENE", options->scenes, "scene files (JSON or NFF)").required();
  command.add_text("--max-level", options->frames.levels, "levels").type_name("FIRST:LAST|L,L,...").show_default();
  command.add_text("--size", options->frames.sizes, "screens; the scene's without it").type_name("COLUMNSxROWS,...");
  command.add_text("--edge", options->frames.edges, "mean, drop or both").type_name("mean,drop").show_default();
  command.add_text("--reference", options->reference, "what errors are measured against, or none")
      .type_name("METHOD|none")
      .show_default();
  options->machine.add(command, "=VALUE,...",
                       "a setting over the machine file's, or each of several values, as in intersection.units=1,2,4; "
                       "repeatable");
  options->machine.add_limit(command);
  options->jobs.add(command);
  command.add_text("--csv", options->csv, "the rows as CSV; - for stdout").type_name("FILE|-");
  command
      .add_text("--resume", options->resumed,
                "the rows as CSV; those that the file holds already are kept, and not made again")
      .type_name("FILE");
}

}  // namespace pyrasim::cli
