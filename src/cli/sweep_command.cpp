// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>

#include "cli/command.h"
#include "cli/csv.h"
#include "cli/finished_rows.h"
#include "cli/interrupt.h"
#include "cli/output_plan.h"
#include "cli/row_output.h"
#include "cli/run_apart.h"
#include "cli/run_simulation.h"
#include "cli/statistics_document.h"
#include "cli/sweep_plan.h"
#include "error.h"
#include "files/sha256.h"
#include "hw_model/machine_settings.h"
#include "hw_model/report/deadlock.h"
#include "image/image_error.h"
#include "json/json_file.h"
#include "render/picture_memory.h"
#include "scene/load_scene.h"
#include "text/printable.h"
#include "version.h"

namespace pyrasim::cli {
namespace {

constexpr std::string_view csv_header =
    "pyrasim,scene,scene_sha256,machine,settings_sha256,set,columns,rows,max_level,edge,reference,rays_primary,"
    "rays_subdivision,rays_total,subdivisions,rmse,max_error,cycles,frames_per_second,reference_rays\n";
constexpr std::size_t key_fields = 11;  ///< up to reference: what was run

struct SweptScene {
  std::string name;
  Scene scene;
  std::string sha256;  ///< of its files' bytes; empty where one cannot be read again, as a pipe
};

/// One row of the sweep.
struct Point {
  const SweptScene* scene;
  const SweptMachine* machine;
  Screen screen;
  int max_level;
  EdgePolicy edge;

  const char* edge_name() const { return edge == EdgePolicy::mean ? "mean" : "drop"; }
  std::string size() const { return fmt::format("{}x{}", screen.columns, screen.rows); }
  bool same_picture(const Point& other) const {
    return scene == other.scene && screen.columns == other.screen.columns && screen.rows == other.screen.rows;
  }
};

/// What the points of one scene on one screen share.
struct Shared {
  Scene scene;
  std::shared_ptr<const Intersector> intersector;
  std::optional<Rendering> truth;  ///< by the reference; none where nothing is measured
};

struct SweepCommand {
  std::vector<std::string> scenes;
  std::string levels = "0:5";
  std::string sizes;
  std::string edges = "mean";
  std::string reference = "grid:32";
  MachineOptions machine;
  std::string csv;
  std::string resumed;

  void run() const {
    const std::optional<Method> peer = reference == "none" ? std::nullopt : std::optional(parse_method(reference));
    if (!csv.empty() && !resumed.empty())
      throw UsageError("sweep: either --csv, or --resume, which is written likewise");
    if (resumed == "-") throw UsageError("--resume -: a file that can be read and written is allowed");
    OutputPlan outputs;
    std::vector<SweptScene> loaded;
    loaded.reserve(scenes.size());
    for (const std::string& name : scenes) {
      loaded.push_back({name, load_scene(name), {}});
      print_warnings(loaded.back().scene);
      outputs.reads("SCENE", loaded.back().scene.files);
      loaded.back().sha256 = sha256_of(loaded.back().scene.files);
    }
    outputs.reads("--machine", machine.file);
    outputs.writes("--csv", csv);
    outputs.writes("--resume", resumed);
    const MachineAxes axes(machine);
    std::vector<Point> points = plan(loaded, axes);
    for (const Point& point : points) check(point);
    const FinishedRows finished =
        resumed.empty() ? FinishedRows() : FinishedRows(resumed, std::string(csv_header), key_fields);
    const std::size_t planned = points.size();
    // Files that can be read once have no SHA-256: nobody knows whether they are the same as before.
    std::erase_if(points,
                  [&](const Point& point) { return !point.scene->sha256.empty() && finished.holds(key(point)); });
    if (points.empty()) {
      outputs.table() << last_lines(peer, planned, 0);
      return;
    }
    RowOutput output(resumed.empty() ? csv : resumed, outputs.table());
    output.header(std::string(csv_header) + finished.text(), table_header(axes));
    make_all(points, axes, peer, output);
    output.finish(last_lines(peer, planned, points.size()));
  }

  void make_all(const std::vector<Point>& points, const MachineAxes& axes, const std::optional<Method>& peer,
                RowOutput& output) const {
    std::vector<std::string> names;
    names.reserve(points.size());
    for (const Point& point : points) names.push_back(name_of(point, axes));
    std::optional<Shared> shared;
    make_rows(names, [&](std::size_t k) {
      if (k == 0 || !points[k].same_picture(points[k - 1])) {
        shared.reset();
        shared = prepare(points[k], peer);
      }
      const std::string counted = fmt::format("simulating {} of {}", k + 1, points.size());
      const std::string lines =
          run_apart("its simulation", [&] { return simulate(points[k], *shared, axes, progress_bar(counted)); });
      const std::size_t end = lines.find('\n') + 1;
      output.row(lines.substr(0, end), lines.substr(end));
    });
  }

  static std::string sha256_of(const std::vector<std::string>& files) {
    std::string bytes;
    for (const std::string& file : files) {
      if (!std::filesystem::is_regular_file(file)) return {};
      bytes += sha256(read_text(file));
    }
    return sha256(bytes);
  }

  std::vector<Point> plan(const std::vector<SweptScene>& loaded, const MachineAxes& axes) const {
    std::vector<Point> points;
    for (const SweptScene& scene : loaded) {
      for (const Screen& screen : parse_sizes(sizes, scene.scene.camera.screen)) {
        for (const SweptMachine& swept : axes.machines) {
          for (const EdgePolicy edge : parse_edges(edges)) {
            for (const int level : parse_levels(levels)) points.push_back({&scene, &swept, screen, level, edge});
          }
        }
      }
    }
    return points;
  }

  static void check(const Point& point) {
    check_addressable(point.screen, point.max_level);
    check_picture_fits({0, 0, point.screen.columns, point.screen.rows});
    hw::check_machine_holds(point.machine->spec, point.max_level, point.screen.columns);
  }

  /// For messages.
  std::string name_of(const Point& point, const MachineAxes& axes) const {
    std::string name =
        fmt::format("{} pixels, MAX_LEVEL {}, edge {}", point.size(), point.max_level, point.edge_name());
    if (scenes.size() > 1) name = excerpt(point.scene->name) + ", " + name;
    for (std::size_t k = 0; k < axes.paths.size(); ++k) {
      name += fmt::format(", {} {}", excerpt(axes.paths[k]), excerpt(point.machine->values[k]));
    }
    return name;
  }

  /// The fields that say what was run.
  /// What was run, in one line whatever names there are: so a line of the file is a row.
  std::vector<std::string> key(const Point& point) const {
    const hw::MachineSpec& spec = point.machine->spec;
    return {std::string(version()),
            one_line(point.scene->name),
            point.scene->sha256.empty() ? "unknown" : point.scene->sha256,
            one_line(spec.name),
            hw::settings_sha256(spec),
            one_line(point.machine->set),
            std::to_string(point.screen.columns),
            std::to_string(point.screen.rows),
            std::to_string(point.max_level),
            point.edge_name(),
            reference};
  }

  static Shared prepare(const Point& point, const std::optional<Method>& peer) {
    Shared shared{point.scene->scene, nullptr, {}};
    shared.scene.camera.screen = point.screen;
    shared.intersector = make_intersector(shared.scene);
    if (peer) shared.truth = render(shared.scene, *peer, {}, 0, progress_bar("reference"));
    stop_if_interrupted();
    return shared;
  }

  /// The point's lines: as CSV, and for people.
  std::string simulate(const Point& point, const Shared& shared, const MachineAxes& axes,
                       const Progress& progress) const {
    hw::SimulationOptions options;
    options.max_level = point.max_level;
    options.edge = point.edge;
    options.intersector = shared.intersector;
    options.max_cycles = machine.max_cycles;
    options.progress = progress;
    hw::Processor processor("processor", shared.scene, point.machine->spec, options);
    run_simulation();
    hw::require_finished(processor);
    std::optional<ImageError> error;
    if (shared.truth) error = image_error(processor.image(), shared.truth->image);
    return csv_line(point, shared, processor, error) + table_line(point, axes, processor, error);
  }

  std::string csv_line(const Point& point, const Shared& shared, const hw::Processor& processor,
                       const std::optional<ImageError>& error) const {
    const FrameStatistics frame = processor.statistics();
    std::vector<std::string> fields = key(point);
    for (const std::uint64_t count :
         {frame.primary_rays(), frame.subdivision_rays_traced(), frame.total_rays(), frame.subdivisions}) {
      fields.push_back(std::to_string(count));
    }
    fields.push_back(error ? fmt::format("{:.9g}", error->rmse) : "");
    fields.push_back(error ? fmt::format("{:.9g}", error->maximum) : "");
    fields.push_back(std::to_string(processor.cycles()));
    fields.push_back(fmt::format("{:.9g}", frames_per_second(processor)));
    fields.push_back(shared.truth ? std::to_string(shared.truth->statistics.total_rays()) : "");
    return csv_row(fields);
  }

  // What varies over the rows has a column: scenes and settings only where there are several.
  std::size_t scene_width() const {
    std::size_t width = 5;
    for (const std::string& name : scenes) width = std::max(width, excerpt(name).size());
    return width;
  }
  static std::size_t axis_width(const MachineAxes& axes, std::size_t axis) {
    std::size_t width = excerpt(axes.paths[axis]).size();
    for (const SweptMachine& swept : axes.machines) width = std::max(width, excerpt(swept.values[axis]).size());
    return width;
  }

  std::string table_header(const MachineAxes& axes) const {
    std::string text = scenes.size() > 1 ? fmt::format("{:<{}} ", "scene", scene_width()) : "";
    text += fmt::format("{:>11} {:>5} {:>4}", "size", "level", "edge");
    for (std::size_t k = 0; k < axes.paths.size(); ++k) {
      text += fmt::format(" {:>{}}", excerpt(axes.paths[k]), axis_width(axes, k));
    }
    return text + fmt::format(" {:>12} {:>12} {:>10} {:>10} {:>12} {:>9}\n", "rays", "subdivisions", "RMSE",
                              "max error", "cycles", "fps");
  }

  std::string table_line(const Point& point, const MachineAxes& axes, const hw::Processor& processor,
                         const std::optional<ImageError>& error) const {
    std::string text = scenes.size() > 1 ? fmt::format("{:<{}} ", excerpt(point.scene->name), scene_width()) : "";
    text += fmt::format("{:>11} {:>5} {:>4}", point.size(), point.max_level, point.edge_name());
    for (std::size_t k = 0; k < axes.paths.size(); ++k) {
      text += fmt::format(" {:>{}}", excerpt(point.machine->values[k]), axis_width(axes, k));
    }
    const FrameStatistics frame = processor.statistics();
    text += fmt::format(" {:>12} {:>12}", frame.total_rays(), frame.subdivisions);
    text += error ? fmt::format(" {:>10.3e} {:>10.3e}", error->rmse, error->maximum)
                  : fmt::format(" {:>10} {:>10}", "-", "-");
    return text + fmt::format(" {:>12} {:>9.1f}\n", processor.cycles(), frames_per_second(processor));
  }

  std::string last_lines(const std::optional<Method>& peer, std::size_t planned, std::size_t made) const {
    std::string text = peer ? fmt::format("errors: linear RGB against {}\n", peer->name()) : "";
    if (!resumed.empty()) {
      text += fmt::format("{} of {} rows were in {}\n", planned - made, planned, one_line(resumed));
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
  command.add_arguments("SCENE", options->scenes, "scene files (JSON)").required();
  command.add_text("--max-level", options->levels, "levels").type_name("FIRST:LAST|L,L,...").show_default();
  command.add_text("--size", options->sizes, "screens; the scene's without it").type_name("COLUMNSxROWS,...");
  command.add_text("--edge", options->edges, "mean, drop or both").type_name("mean,drop").show_default();
  command.add_text("--reference", options->reference, "what errors are measured against, or none")
      .type_name("METHOD|none")
      .show_default();
  options->machine.add(command, "=VALUE,...",
                       "a setting over the machine file's, or each of several values, as in intersection.units=1,2,4; "
                       "repeatable");
  options->machine.add_limit(command);
  command.add_text("--csv", options->csv, "the rows as CSV; - for stdout").type_name("FILE|-");
  command
      .add_text("--resume", options->resumed,
                "the rows as CSV; those that the file holds already are kept, and not made again")
      .type_name("FILE");
}

}  // namespace pyrasim::cli
