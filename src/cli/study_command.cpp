// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <tuple>

#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/machine_options.h"
#include "cli/output_plan.h"
#include "cli/row_output.h"
#include "cli/run_apart.h"
#include "cli/run_simulation.h"
#include "error.h"
#include "hw_model/processor.h"
#include "hw_model/report/deadlock.h"
#include "image/image_error.h"
#include "render/method.h"
#include "render/picture_memory.h"
#include "study/format_plot.h"
#include "study/format_study.h"

namespace pyrasim::cli {
namespace {

/// What a frame in one format comes to, as the process that simulated it sends it.
struct Measured {
  std::uint64_t changed_pixels;
  double psnr;
  DecisionFlips flips;
  std::uint64_t rays;
  std::uint64_t cycles;
  ArithmeticEvents events;
};

/// What every format is measured against: the frame in double.
struct Reference {
  Image image;
  std::shared_ptr<const Intersector> intersector;
};

struct NumericsStudy {
  FrameOptions frame;
  MachineOptions machine;
  std::string formats;
  int threads = 0;
  std::string csv;
  std::string plot;

  void run() const {
    const Scene scene = frame.load();
    const int max_level = parse_max_level(frame.max_level, scene.camera.screen);
    check_addressable(scene.camera.screen, max_level);
    const std::vector<NumberFormat> list = chosen();
    check_picture_fits(scene.camera.rendered());
    const hw::MachineSpec spec = machine.load();
    hw::check_machine_holds(spec, max_level, scene.camera.screen.columns);
    OutputPlan plan;
    plan.reads("SCENE", scene.files);
    plan.reads("--machine", machine.file);
    plan.writes("--csv", csv);
    plan.writes("--plot", plot, ".svg");
    RowOutput output(csv, plan.table());
    std::optional<TextOutput> picture;
    if (!plot.empty()) picture.emplace(plot);
    output.header(format_csv_header(), format_table_header());
    const std::vector<FormatRow> rows = study(list, scene, spec, max_level, output);
    output.finish(format_verdict(rows));
    if (picture) {
      picture->write(format_plot(rows, fmt::format("{}, {}x{} pixels, MAX_LEVEL {}, against double", frame.scene,
                                                   scene.camera.screen.columns, scene.camera.screen.rows, max_level)));
    }
  }

  std::vector<FormatRow> study(const std::vector<NumberFormat>& list, const Scene& scene, const hw::MachineSpec& spec,
                               int max_level, RowOutput& output) const {
    std::vector<std::string> names;
    names.reserve(list.size());
    for (const NumberFormat& format : list) names.push_back(format.name());
    std::optional<Reference> reference;
    std::vector<FormatRow> rows;
    make_rows(names, [&](std::size_t k) {
      if (!reference) reference = make_reference(scene, max_level);
      FormatRow row;
      row.format = list[k];
      if (!can_address(list[k], scene, max_level)) {
        row.refused = "cannot address the screen";
      } else {
        const Progress bar = progress_bar(fmt::format("simulating {} of {}", k + 1, list.size()));
        const Measured measured =
            run_apart_for("its simulation", [&] { return measure(list[k], scene, spec, max_level, *reference, bar); });
        row.changed_pixels = measured.changed_pixels;
        row.psnr = measured.psnr;
        row.flips = measured.flips;
        row.rays = measured.rays;
        row.cycles = measured.cycles;
        row.events = measured.events;
      }
      output.row(format_csv_row(row), format_table_row(row));
      rows.push_back(row);
    });
    return rows;
  }

  /// The renderer's picture, which is the machine's bit for bit.
  Reference make_reference(const Scene& scene, int max_level) const {
    Method pyramids;
    pyramids.pyramids = {.max_level = max_level, .edge = frame.edge};
    Reference reference{render(scene, pyramids, {}, threads, progress_bar("rendering in double")).image,
                        make_intersector(scene)};
    stop_if_interrupted();
    return reference;
  }

  static bool can_address(const NumberFormat& format, const Scene& scene, int max_level) {
    try {
      check_addressing({format, format}, scene.camera.screen, std::int64_t{1} << max_level);
      return true;
    } catch (const UsageError&) {
      return false;
    }
  }

  Measured measure(const NumberFormat& format, const Scene& scene, const hw::MachineSpec& spec, int max_level,
                   const Reference& reference, const Progress& progress) const {
    hw::SimulationOptions options;
    options.max_level = max_level;
    options.edge = frame.edge;
    options.formats = {format, format};
    options.max_cycles = machine.max_cycles;
    options.progress = progress;
    options.intersector = make_intersector(scene, format);
    hw::Processor processor("processor", scene, spec, options);
    run_simulation();
    hw::require_finished(processor);
    const FrameStatistics statistics = processor.statistics();
    ArithmeticEvents events = statistics.arithmetic.view_vectors;
    events += statistics.arithmetic.intersection;
    return {changed_pixels(processor.image(), reference.image),
            psnr(processor.image(), reference.image),
            decision_flips(scene, {*reference.intersector, {}}, {*options.intersector, format}, max_level, threads),
            statistics.total_rays(),
            processor.cycles(),
            events};
  }

  /// The order of the table: floating point before fixed, then by precision, then by width.
  static bool finer(const NumberFormat& a, const NumberFormat& b) {
    const auto key = [](const NumberFormat& format) {
      const bool fixed = format.kind == NumberKind::fixed;
      return std::tuple(fixed, fixed ? -format.fraction_bits : -format.significand_bits, -format.bits);
    };
    return key(a) < key(b);
  }

  /// Double first: what the others are measured against.
  std::vector<NumberFormat> chosen() const {
    std::vector<NumberFormat> list(1);
    const auto add = [&](const NumberFormat& format) {
      if (std::find(list.begin(), list.end(), format) == list.end()) list.push_back(format);
    };
    if (formats.empty()) {
      std::vector<NumberFormat> all = number_formats();
      std::sort(all.begin(), all.end(), finer);
      for (const NumberFormat& format : all) add(format);
    } else {
      for (const std::string& name : split(formats, ',')) add(parse_number_format(name));
    }
    return list;
  }
};

}  // namespace

void add_study_command(const Command& program) {
  const Command study = program.add_group("study", "Measure what a choice costs, over all its values.");
  auto options = std::make_shared<NumericsStudy>();
  const Command command =
      study.add_command("numerics",
                        "Simulate a frame in every number format and measure each against double; a row is "
                        "written as soon as it is done.",
                        [options] { options->run(); });
  add_frame_options(command, options->frame);
  command.add_text("--formats", options->formats, "formats to study; all that pyrasim formats lists without it")
      .type_name("FORMAT,...");
  options->machine.add(command);
  options->machine.add_limit(command);
  command.add_integer("--threads", options->threads, 0, 1024, "0: one for each core; results do not depend on it")
      .show_default();
  command.add_text("--csv", options->csv, "the rows with every count as CSV; - for stdout").type_name("FILE|-");
  command.add_text("--plot", options->plot, "changed pixels and decisions against bits; - for stdout")
      .type_name("FILE.svg|-");
}

}  // namespace pyrasim::cli
