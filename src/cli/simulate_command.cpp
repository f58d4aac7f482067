// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/machine_options.h"
#include "cli/output_plan.h"
#include "cli/revisable_output.h"
#include "cli/run_simulation.h"
#include "cli/statistics_document.h"
#include "hw_model/report/deadlock.h"
#include "hw_model/trace/occupancies.h"
#include "hw_model/trace/vcd_trace.h"

namespace pyrasim::cli {
namespace {

struct SimulateCommand {
  FrameOptions frame;
  ImageOutput image;
  MachineOptions machine;
  hw::Engine engine = hw::Engine::decoupled;
  int threads = 0;
  std::string stats;
  std::string trace;

  void run() const {
    const Scene scene = frame.load();
    const hw::MachineSpec spec = machine.load();
    hw::SimulationOptions options;
    options.max_level = parse_max_level(frame.max_level, scene.camera.screen);
    options.edge = frame.edge;
    options.engine = engine;
    options.max_cycles = machine.max_cycles;
    options.threads = thread_count(threads);
    options.progress = progress_bar("simulating");
    check_addressable(scene.camera.screen, options.max_level);
    options.formats = frame.formats(scene.camera.screen, std::int64_t{1} << options.max_level);
    OutputPlan plan;
    plan.reads("SCENE", scene.files);
    plan.reads("--machine", machine.file);
    plan.writes("-o", image.file);
    plan.writes("--stats", stats);
    plan.writes("--trace", trace, ".vcd");
    PictureOutput picture(image);
    std::optional<TextOutput> statistics;
    if (!stats.empty()) statistics.emplace(stats);
    std::optional<RevisableOutput> vcd;
    if (!trace.empty()) vcd.emplace(trace);

    hw::Processor processor("processor", scene, spec, options);
    std::optional<hw::VcdTrace> vcd_trace;
    if (vcd) vcd_trace.emplace(processor, vcd->file());
    std::optional<hw::Occupancies> occupancies;
    if (statistics) occupancies.emplace(processor);
    run_interruptibly(run_simulation, [&] {
      return fmt::format("after {} cycles, {} of {} pixels stored", processor.cycles(),
                         processor.frame_buffer().stored(), processor.image().pixels().size());
    });
    hw::require_finished(processor);
    picture.write(processor.image());
    if (vcd) {
      vcd_trace->finish();
      vcd->commit();
    }
    if (statistics) {
      occupancies->end_frame(processor.cycles());
      statistics->write(
          text_of(simulation_document(frame.scene, scene.camera, options, processor, occupancies->fifos())));
    }
    plan.table() << simulation_table(frame.scene, scene.camera, options.max_level, processor);
  }
};

}  // namespace

void add_simulate_command(const Command& program) {
  auto options = std::make_shared<SimulateCommand>();
  const Command command =
      program.add_command("simulate", "Simulate a frame on a machine, cycle by cycle.", [options] { options->run(); });
  add_frame_options(command, options->frame);
  add_window_option(command, options->frame);
  add_scalar_option(command, options->frame.scalar);
  options->image.add(command);
  options->machine.add(command);
  options->machine.add_limit(command);
  command.add_choice<hw::Engine>("--engine", options->engine,
                                 {{"decoupled", hw::Engine::decoupled}, {"lockstep", hw::Engine::lockstep}},
                                 "decoupled is fast; lockstep is plain SystemC, with the same cycles");
  command
      .add_integer("--threads", options->threads, 0, 1024,
                   "0: one for each core; a second one traces ahead; results do not depend on it")
      .show_default();
  command.add_text("--stats", options->stats, "statistics as JSON; - for stdout").type_name("FILE|-");
  command.add_text("--trace", options->trace, "states of units and fill of FIFOs over time; - for stdout")
      .type_name("FILE.vcd|-");
}

}  // namespace pyrasim::cli
