// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <tuple>

#include "cli/asked_run.h"
#include "cli/command.h"
#include "cli/machine_options.h"
#include "cli/output_plan.h"
#include "cli/row_output.h"
#include "error.h"
#include "image/image_error.h"
#include "render/method.h"
#include "render/picture_memory.h"
#include "run/executor.h"
#include "run/interrupt.h"
#include "study/format_plot.h"
#include "study/format_study.h"

namespace pyrasim::cli {
namespace {

/// What every format is measured against: the frame in double, by the renderer, whose picture is the machine's bit for
/// bit.
struct DoubleFrame {
  Image image;
  std::unique_ptr<Intersector> intersector;
};

FormatRow row_of(const NumberFormat& format, const std::optional<Outcome>& outcome) {
  FormatRow row;
  row.format = format;
  if (!outcome) {
    row.refused = "cannot address the screen";
    return row;
  }
  row.changed_pixels = outcome->format_error->changed_pixels;
  row.psnr = outcome->format_error->psnr;
  row.flips = outcome->format_error->flips;
  row.rays = outcome->counts.total_rays();
  row.cycles = outcome->cycles;
  row.events = outcome->counts.arithmetic.view_vectors;
  row.events += outcome->counts.arithmetic.intersection;
  return row;
}

struct NumericsStudy {
  FrameOptions frame;
  MachineOptions machine;
  std::string formats;
  int threads = 0;
  JobOption jobs;
  std::string csv;
  std::string plot;

  void run() const {
    const auto [asked, scene] = asked_run(frame, machine);
    const std::vector<NumberFormat> list = chosen();
    const int at_once = std::min(jobs.at_once(), static_cast<int>(list.size()));
    check_pictures_fit(std::vector(list.size(), asked.rendered()), {asked.rendered()}, at_once);
    OutputPlan plan;
    plan.reads("SCENE", scene->files);
    plan.reads("--machine", machine.file);
    plan.writes_usually("--csv", csv, ".csv");
    plan.writes("--plot", plot, {".svg"});
    RowOutput output(csv, plan.table());
    std::optional<TextOutput> picture;
    if (!plot.empty()) picture.emplace(plot);
    output.header(format_csv_header(), format_table_header());
    const std::vector<FormatRow> rows = study(list, asked, scene, at_once, output);
    output.finish(format_verdict(rows));
    if (picture) {
      picture->write(format_plot(rows, fmt::format("{}, {}x{} pixels, MAX_LEVEL {}, against double", frame.scene,
                                                   asked.screen.columns, asked.screen.rows, asked.max_level)));
    }
  }

  std::vector<FormatRow> study(const std::vector<NumberFormat>& list, const Run& asked,
                               const std::shared_ptr<const Scene>& scene, int at_once, RowOutput& output) const {
    std::vector<std::string> names;
    names.reserve(list.size());
    for (const NumberFormat& format : list) names.push_back(format.name());
    std::shared_ptr<const DoubleFrame> reference;
    std::vector<FormatRow> rows;
    const auto prepare = [&](std::size_t k) -> std::optional<Task> {
      if (!reference) reference = in_double(*scene, asked);
      if (!can_address(list[k], asked)) return std::nullopt;
      return task(list[k], asked, scene, reference, std::max(1, thread_count(threads) / at_once));
    };
    make_rows(names, at_once, prepare, [&](std::size_t k, const std::optional<Outcome>& outcome) {
      rows.push_back(row_of(list[k], outcome));
      output.row(format_csv_row(rows.back()), format_table_row(rows.back()));
    });
    return rows;
  }

  std::shared_ptr<const DoubleFrame> in_double(const Scene& scene, const Run& asked) const {
    Method pyramids;
    pyramids.pyramids = {.max_level = asked.max_level, .edge = asked.edge};
    auto reference = std::make_shared<DoubleFrame>();
    reference->image = render(scene, pyramids, {}, threads, progress_bar("rendering in double")).image;
    reference->intersector = make_intersector(scene);
    stop_if_interrupted();
    return reference;
  }

  static bool can_address(const NumberFormat& format, const Run& asked) {
    try {
      check_addressing({format, format}, asked.screen, std::int64_t{1} << asked.max_level);
      return true;
    } catch (const UsageError&) {
      return false;
    }
  }

  /// The frame in one format; decisions are compared on so many threads.
  static Task task(const NumberFormat& format, const Run& asked, const std::shared_ptr<const Scene>& scene,
                   const std::shared_ptr<const DoubleFrame>& reference, int threads_each) {
    Task task{asked, scene};
    task.run.formats = {format, format};
    task.run.reference = "double";
    task.measure = [=, max_level = asked.max_level](const Simulation& finished, Outcome& outcome) {
      outcome.format_error = {changed_pixels(finished.image(), reference->image),
                              psnr(finished.image(), reference->image),
                              decision_flips(*scene, {*reference->intersector, {}}, {finished.intersector(), format},
                                             max_level, threads_each)};
    };
    return task;
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
                        "Simulate a frame in each of a list of number formats and measure it against double; a row is "
                        "written as soon as it is done.",
                        [options] { options->run(); });
  add_frame_options(command, options->frame);
  command.add_text("--formats", options->formats, "formats to study; all that pyrasim formats lists without it")
      .type_name("FORMAT,...");
  options->machine.add(command);
  options->machine.add_limit(command);
  command.add_integer("--threads", options->threads, 0, 1024, "0: one for each core; results do not depend on it")
      .show_default();
  options->jobs.add(command);
  command.add_text("--csv", options->csv, "the rows with every count as CSV; - for stdout").type_name("FILE|-");
  command.add_text("--plot", options->plot, "changed pixels and decisions against bits; - for stdout")
      .type_name("FILE.svg|-");
}

}  // namespace pyrasim::cli
