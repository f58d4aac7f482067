// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <iostream>
#include <memory>
#include <systemc>

#include "cli/command.h"
#include "cli/machine_options.h"
#include "cli/output_plan.h"
#include "cli/statistics_document.h"
#include "error.h"
#include "hw_model/report/deadlock.h"
#include "image/image_error.h"
#include "scene/load_scene.h"

namespace pyrasim::cli {
namespace {

/// One row of the sweep.
struct Point {
  Scene scene;  ///< on this point's screen
  int max_level;
  Leaf leaf;
  std::shared_ptr<const Tracer> tracer;  ///< shared by the points of one size
  std::unique_ptr<hw::Processor> processor;
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
    std::vector<Point> points = plan();
    OutputPlan outputs;
    outputs.reads("SCENE", points.front().scene.files);
    outputs.reads("--machine", machine.file);
    outputs.writes("--csv", csv);
    std::optional<TextOutput> table;
    if (!csv.empty()) table.emplace(csv);
    const Progress bar = progress_bar("simulating");
    const hw::MachineSpec spec = machine.load();
    for (std::size_t k = 0; k < points.size(); ++k) {
      hw::SimulationOptions options;
      options.max_level = points[k].max_level;
      options.leaf = points[k].leaf;
      options.tracer = points[k].tracer;
      options.max_cycles = machine.max_cycles;
      options.progress = [bar, k, all = points.size()](double share) {
        return bar((static_cast<double>(k) + share) / static_cast<double>(all));
      };
      points[k].processor =
          std::make_unique<hw::Processor>(fmt::format("point_{}", k).c_str(), points[k].scene, spec, options);
    }
    sc_core::sc_start();
    for (const Point& point : points) hw::require_finished(*point.processor);
    report(points, peer, table, outputs.table());
  }

  std::vector<Point> plan() const {
    const Scene loaded = load_scene(scene);
    print_warnings(loaded);
    std::vector<Point> points;
    for (const std::string& size : split(sizes, ',')) {
      Scene resized_scene = loaded;
      if (!sizes.empty()) {
        const auto [columns, rows] = parse_size(size);
        resized_scene.camera.screen = resized(loaded.camera.screen, columns, rows);
      }
      const std::shared_ptr<const Tracer> tracer = make_tracer(resized_scene);
      for (const std::string& leaf : split(leaves, ',')) {
        if (leaf != "mean" && leaf != "drop") throw UsageError("--leaf " + leaf + ": mean and drop are allowed");
        for (const int level : parse_levels()) {
          check_addressable(resized_scene.camera.screen, level);
          points.push_back({resized_scene, level, leaf == "mean" ? Leaf::mean : Leaf::drop, tracer, nullptr});
        }
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

  void report(const std::vector<Point>& points, const Method& peer, std::optional<TextOutput>& table,
              std::ostream& stream) const {
    std::string rows =
        "columns,rows,max_level,leaf,rays_primary,rays_subdivision,rays_total,subdivisions,rmse,max_error,cycles,"
        "frames_per_second,reference,reference_rays\n";
    std::string text = fmt::format("{:>11} {:>5} {:>4} {:>12} {:>12} {:>10} {:>10} {:>12} {:>9}\n", "size", "level",
                                   "leaf", "rays", "subdivisions", "RMSE", "max error", "cycles", "fps");
    Rendering truth;
    for (const Point& point : points) {
      const hw::Processor& processor = *point.processor;
      const Image& image = processor.image();
      if (truth.image.columns() != image.columns() || truth.image.rows() != image.rows()) {
        truth = render(point.scene, peer, {}, 0, progress_bar("reference"));
      }
      const ImageError error = image_error(image, truth.image);
      const FrameStatistics frame = processor.statistics();
      const char* leaf = point.leaf == Leaf::mean ? "mean" : "drop";
      rows += fmt::format("{},{},{},{},{},{},{},{},{:.9g},{:.9g},{},{:.9g},{},{}\n", image.columns(), image.rows(),
                          point.max_level, leaf, frame.primary_rays(), frame.subdivision_rays_traced(),
                          frame.total_rays(), frame.subdivisions, error.rmse, error.maximum, processor.cycles(),
                          frames_per_second(processor), peer.name(), truth.statistics.total_rays());
      text +=
          fmt::format("{:>11} {:>5} {:>4} {:>12} {:>12} {:>10.3e} {:>10.3e} {:>12} {:>9.1f}\n",
                      fmt::format("{}x{}", image.columns(), image.rows()), point.max_level, leaf, frame.total_rays(),
                      frame.subdivisions, error.rmse, error.maximum, processor.cycles(), frames_per_second(processor));
    }
    if (table) table->write(rows);
    text += fmt::format("errors: linear RGB against {}, {} rays at the last size\n", peer.name(),
                        truth.statistics.total_rays());
    stream << text;
  }
};

}  // namespace

void add_sweep_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<SweepCommand>();
  CLI::App* command = app.add_subcommand(
      "sweep", "Simulate every combination of level, size and leaf, and measure each against a reference.");
  command->add_option("SCENE", options->scene, "scene file (JSON)")->required();
  command->add_option("--max-level", options->levels, "levels")->type_name("FIRST:LAST|L,L,...")->capture_default_str();
  command->add_option("--size", options->sizes, "screens; the scene's without it")->type_name("COLUMNSxROWS,...");
  command->add_option("--leaf", options->leaves, "mean, drop or both")->type_name("mean,drop")->capture_default_str();
  command->add_option("--reference", options->reference, "what errors are measured against")
      ->type_name("METHOD")
      ->capture_default_str();
  options->machine.add(*command);
  command->add_option("--csv", options->csv, "the rows as CSV; - for stdout")->type_name("FILE|-");
  command->callback([&action, options] { action = [options] { options->run(); }; });
}

}  // namespace pyrasim::cli
