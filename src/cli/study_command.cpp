// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <systemc>
#include <tuple>

#include "cli/command.h"
#include "cli/machine_options.h"
#include "cli/output_plan.h"
#include "cli/whole_number.h"
#include "error.h"
#include "hw_model/processor.h"
#include "hw_model/report/deadlock.h"
#include "image/image_error.h"
#include "render/picture_memory.h"
#include "study/format_plot.h"
#include "study/format_study.h"

namespace pyrasim::cli {
namespace {

/// A format, and the machine that renders the frame in it; none where the screen cannot be addressed.
struct Candidate {
  NumberFormat format;
  std::string refused;
  std::shared_ptr<const Tracer> tracer;
  std::unique_ptr<hw::Processor> processor;
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
    std::vector<Candidate> candidates = chosen();
    check_picture_fits(scene.camera.rendered(), physical_memory(), candidates.size());
    OutputPlan outputs;
    outputs.reads("SCENE", scene.files);
    outputs.reads("--machine", machine.file);
    outputs.writes("--csv", csv);
    outputs.writes("--plot", plot, ".svg");
    std::optional<TextOutput> table;
    if (!csv.empty()) table.emplace(csv);
    std::optional<TextOutput> picture;
    if (!plot.empty()) picture.emplace(plot);
    simulate(candidates, scene, max_level);
    const std::vector<FormatRow> rows = compare(candidates, scene, max_level);
    if (table) table->write(format_csv(rows));
    if (picture) {
      picture->write(format_plot(rows, fmt::format("{}, {}x{} pixels, MAX_LEVEL {}, against double", frame.scene,
                                                   scene.camera.screen.columns, scene.camera.screen.rows, max_level)));
    }
    outputs.table() << format_table(rows);
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
  std::vector<Candidate> chosen() const {
    std::vector<Candidate> candidates(1);
    const auto add = [&](const NumberFormat& format) {
      const auto is_it = [&](const Candidate& candidate) { return candidate.format == format; };
      if (std::none_of(candidates.begin(), candidates.end(), is_it))
        candidates.push_back({format, {}, nullptr, nullptr});
    };
    if (formats.empty()) {
      std::vector<NumberFormat> all = number_formats();
      std::sort(all.begin(), all.end(), finer);
      for (const NumberFormat& format : all) add(format);
    } else {
      for (const std::string& name : split(formats, ',')) add(parse_number_format(name));
    }
    return candidates;
  }

  void simulate(std::vector<Candidate>& candidates, const Scene& scene, int max_level) const {
    const Progress bar = progress_bar("simulating");
    const hw::MachineSpec spec = machine.load();
    for (std::size_t k = 0; k < candidates.size(); ++k) {
      hw::SimulationOptions options;
      options.max_level = max_level;
      options.leaf = frame.leaf;
      options.formats = {candidates[k].format, candidates[k].format};
      options.max_cycles = machine.max_cycles;
      options.progress = [bar, k, all = candidates.size()](double share) {
        return bar((static_cast<double>(k) + share) / static_cast<double>(all));
      };
      try {
        check_addressing(options.formats, scene.camera.screen, std::int64_t{1} << max_level);
      } catch (const UsageError& error) {
        candidates[k].refused = "cannot address the screen";
        continue;
      }
      candidates[k].tracer = options.tracer = make_tracer(scene, candidates[k].format);
      candidates[k].processor =
          std::make_unique<hw::Processor>(fmt::format("format_{}", k).c_str(), scene, spec, options);
    }
    sc_core::sc_start();
    for (const Candidate& candidate : candidates) {
      if (candidate.processor) hw::require_finished(*candidate.processor);
    }
  }

  std::vector<FormatRow> compare(const std::vector<Candidate>& candidates, const Scene& scene, int max_level) const {
    const Progress bar = progress_bar("comparing");
    const hw::Processor& reference = *candidates.front().processor;
    const Tracer& exact = *candidates.front().tracer;
    std::vector<FormatRow> rows;
    for (const Candidate& candidate : candidates) {
      FormatRow& row = rows.emplace_back();
      row.format = candidate.format;
      row.refused = candidate.refused;
      bar(static_cast<double>(rows.size()) / static_cast<double>(candidates.size()));
      if (!candidate.processor) continue;
      const FrameStatistics statistics = candidate.processor->statistics();
      row.changed_pixels = changed_pixels(candidate.processor->image(), reference.image());
      row.psnr = psnr(candidate.processor->image(), reference.image());
      row.flips = decision_flips(scene, {exact, {}}, {*candidate.tracer, candidate.format}, max_level, threads);
      row.rays = statistics.total_rays();
      row.cycles = candidate.processor->cycles();
      row.events = statistics.arithmetic.view_vectors;
      row.events += statistics.arithmetic.intersection;
    }
    return rows;
  }
};

}  // namespace

void add_study_command(CLI::App& app, Action& action) {
  CLI::App* study = app.add_subcommand("study", "Measure what a choice costs, over all its values.");
  study->require_subcommand(0, 1);  // so that the name of an unknown one shows
  study->callback([study] {
    if (study->get_subcommands().empty()) throw CLI::RequiredError("study: numerics");
  });
  auto options = std::make_shared<NumericsStudy>();
  CLI::App* command =
      study->add_subcommand("numerics", "Simulate a frame in every number format and measure each against double.");
  add_frame_options(*command, options->frame);
  command->add_option("--formats", options->formats, "formats to study; all without it")->type_name("FORMAT,...");
  options->machine.add(*command);
  add_threads_option(*command, options->threads);
  command->add_option("--csv", options->csv, "the rows with every count as CSV; - for stdout")->type_name("FILE|-");
  command->add_option("--plot", options->plot, "changed pixels and decisions against bits; - for stdout")
      ->type_name("FILE.svg|-");
  command->callback([&action, options] { action = [options] { options->run(); }; });
}

}  // namespace pyrasim::cli
