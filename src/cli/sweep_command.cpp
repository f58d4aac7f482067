// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <optional>
#include <systemc>

#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/machine_options.h"
#include "cli/output_plan.h"
#include "cli/row_output.h"
#include "cli/run_apart.h"
#include "cli/statistics_document.h"
#include "error.h"
#include "hw_model/report/deadlock.h"
#include "image/image_error.h"
#include "render/picture_memory.h"
#include "scene/load_scene.h"

namespace pyrasim::cli {
namespace {

/// One row of the sweep.
struct Point {
  Screen screen;
  int max_level;
  Leaf leaf;

  const char* leaf_name() const { return leaf == Leaf::mean ? "mean" : "drop"; }
  std::string size() const { return fmt::format("{}x{}", screen.columns, screen.rows); }
  std::string name() const { return fmt::format("{} pixels, MAX_LEVEL {}, leaf {}", size(), max_level, leaf_name()); }
};

/// What the points of one screen share.
struct Shared {
  Scene scene;
  std::shared_ptr<const Tracer> tracer;
  Rendering truth;  ///< by the reference
};

struct SweepCommand {
  std::string scene;
  std::string levels = "0:5";
  std::string sizes;
  std::string leaves = "mean";
  std::string reference = "grid:32";
  MachineOptions machine;
  std::string csv;

  void run() const {
    const Method peer = parse_method(reference);
    const Scene loaded = load_scene(scene);
    print_warnings(loaded);
    const std::vector<Point> points = plan(loaded.camera.screen);
    const hw::MachineSpec spec = machine.load();
    std::vector<std::string> names;
    for (const Point& point : points) {
      check_addressable(point.screen, point.max_level);
      check_picture_fits({0, 0, point.screen.columns, point.screen.rows});
      hw::check_machine_holds(spec, point.max_level, point.screen.columns);
      names.push_back(point.name());
    }
    OutputPlan outputs;
    outputs.reads("SCENE", loaded.files);
    outputs.reads("--machine", machine.file);
    outputs.writes("--csv", csv);
    RowOutput output(csv, outputs.table());
    output.header(
        "columns,rows,max_level,leaf,rays_primary,rays_subdivision,rays_total,subdivisions,rmse,max_error,cycles,"
        "frames_per_second,reference,reference_rays\n",
        fmt::format("{:>11} {:>5} {:>4} {:>12} {:>12} {:>10} {:>10} {:>12} {:>9}\n", "size", "level", "leaf", "rays",
                    "subdivisions", "RMSE", "max error", "cycles", "fps"));
    std::optional<Shared> shared;
    make_rows(names, [&](std::size_t k) {
      const Screen& screen = points[k].screen;
      if (k == 0 || screen.columns != points[k - 1].screen.columns || screen.rows != points[k - 1].screen.rows) {
        shared.reset();
        shared = prepare(loaded, screen, peer);
      }
      const std::string counted = fmt::format("simulating {} of {}", k + 1, points.size());
      const std::string lines =
          run_apart("its simulation", [&] { return simulate(points[k], *shared, spec, peer, progress_bar(counted)); });
      const std::size_t end = lines.find('\n') + 1;
      output.row(lines.substr(0, end), lines.substr(end));
    });
    output.finish(fmt::format("errors: linear RGB against {}, {} rays at the last size\n", peer.name(),
                              shared->truth.statistics.total_rays()));
  }

  static Shared prepare(const Scene& loaded, const Screen& screen, const Method& peer) {
    Shared shared{loaded, nullptr, {}};
    shared.scene.camera.screen = screen;
    shared.tracer = make_tracer(shared.scene);
    shared.truth = render(shared.scene, peer, {}, 0, progress_bar("reference"));
    stop_if_interrupted();
    return shared;
  }

  /// The point's lines: as CSV, and for people.
  std::string simulate(const Point& point, const Shared& shared, const hw::MachineSpec& spec, const Method& peer,
                       const Progress& progress) const {
    hw::SimulationOptions options;
    options.max_level = point.max_level;
    options.leaf = point.leaf;
    options.tracer = shared.tracer;
    options.max_cycles = machine.max_cycles;
    options.progress = progress;
    hw::Processor processor("processor", shared.scene, spec, options);
    sc_core::sc_start();
    hw::require_finished(processor);
    const ImageError error = image_error(processor.image(), shared.truth.image);
    const FrameStatistics frame = processor.statistics();
    return fmt::format("{},{},{},{},{},{},{},{},{:.9g},{:.9g},{},{:.9g},{},{}\n", point.screen.columns,
                       point.screen.rows, point.max_level, point.leaf_name(), frame.primary_rays(),
                       frame.subdivision_rays_traced(), frame.total_rays(), frame.subdivisions, error.rmse,
                       error.maximum, processor.cycles(), frames_per_second(processor), peer.name(),
                       shared.truth.statistics.total_rays()) +
           fmt::format("{:>11} {:>5} {:>4} {:>12} {:>12} {:>10.3e} {:>10.3e} {:>12} {:>9.1f}\n", point.size(),
                       point.max_level, point.leaf_name(), frame.total_rays(), frame.subdivisions, error.rmse,
                       error.maximum, processor.cycles(), frames_per_second(processor));
  }

  std::vector<Point> plan(const Screen& screen) const {
    std::vector<Point> points;
    for (const std::string& size : split(sizes, ',')) {
      Screen asked = screen;
      if (!sizes.empty()) {
        const auto [columns, rows] = parse_size(size);
        asked = resized(screen, columns, rows);
      }
      for (const std::string& leaf : split(leaves, ',')) {
        if (leaf != "mean" && leaf != "drop") throw UsageError("--leaf " + leaf + ": mean and drop are allowed");
        for (const int level : parse_levels())
          points.push_back({asked, level, leaf == "mean" ? Leaf::mean : Leaf::drop});
      }
    }
    return points;
  }

  /// "0:5" or "0,2,3".
  std::vector<int> parse_levels() const {
    std::vector<int> list;
    const std::size_t colon = levels.find(':');
    if (colon == std::string::npos) {
      for (const std::string& level : split(levels, ',')) {
        list.push_back(parse_number(level, 0, max_level_limit, "--max-level"));
      }
      return list;
    }
    const int first = parse_number(levels.substr(0, colon), 0, max_level_limit, "--max-level");
    const int last = parse_number(levels.substr(colon + 1), first, max_level_limit, "--max-level");
    for (int level = first; level <= last; ++level) list.push_back(level);
    return list;
  }
};

}  // namespace

void add_sweep_command(const Command& program) {
  auto options = std::make_shared<SweepCommand>();
  const Command command = program.add_command(
      "sweep",
      "Simulate every combination of level, size and leaf, and measure each against a reference; a row is written as "
      "soon as it is done.",
      [options] { options->run(); });
  command.add_text("SCENE", options->scene, "scene file (JSON)").required();
  command.add_text("--max-level", options->levels, "levels").type_name("FIRST:LAST|L,L,...").show_default();
  command.add_text("--size", options->sizes, "screens; the scene's without it").type_name("COLUMNSxROWS,...");
  command.add_text("--leaf", options->leaves, "mean, drop or both").type_name("mean,drop").show_default();
  command.add_text("--reference", options->reference, "what errors are measured against")
      .type_name("METHOD")
      .show_default();
  options->machine.add(command);
  command.add_text("--csv", options->csv, "the rows as CSV; - for stdout").type_name("FILE|-");
}

}  // namespace pyrasim::cli
