// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/asked_run.h"
#include "cli/command.h"
#include "cli/machine_options.h"
#include "cli/map_outputs.h"
#include "cli/output_plan.h"
#include "cli/statistics_document.h"
#include "cli/trace_outputs.h"
#include "run/interrupt.h"
#include "run/run_document.h"
#include "run/simulation.h"

namespace pyrasim::cli {
namespace {

struct SimulateCommand {
  FrameOptions frame;
  ImageOutput image;
  MachineOptions machine;
  hw::Engine engine = hw::Engine::decoupled;
  int threads = 0;
  std::string stats;
  TraceOptions trace;
  std::vector<std::string> maps;
  bool explain = false;

  void run() const {
    auto [asked, scene] = asked_run(frame, machine);
    asked.engine = engine;
    OutputPlan plan;
    plan.reads("SCENE", scene->files);
    plan.reads("--machine", machine.file);
    plan.writes("-o", image.file);
    plan.writes_usually("--stats", stats, ".json");
    TraceOutputs traces(trace, asked.rendered(), plan);
    MapOutputs pictures_of_cost(maps, cost_map_names.size(), plan);
    PictureOutput picture(image);
    std::optional<TextOutput> statistics;
    if (!stats.empty()) statistics.emplace(stats);
    traces.open();
    pictures_of_cost.open();

    Simulation simulation(asked, *scene,
                          {.threads = thread_count(threads),
                           .progress = progress_bar("simulating"),
                           .maps = pictures_of_cost.begin(asked.rendered(), asked.max_level),
                           .occupancies = statistics.has_value(),
                           .critical_path = trace.window.critical_path});
    const hw::Processor& processor = simulation.processor();
    traces.begin(simulation.processor(), run_document(asked, *scene));
    Outcome outcome;
    run_interruptibly(
        [&] {
          outcome = simulation.run();
          traces.finish(processor.cycles());  // of a frame that was broken off, too
        },
        [&] { return simulation.how_far(); });
    require_finished(outcome);
    picture.write(processor.image());
    if (statistics) statistics->write(text_of(simulation_document(asked, outcome)));
    plan.table() << simulation_table(asked, outcome);
    if (explain) plan.table() << parts_table(outcome);
    pictures_of_cost.write(plan.table());
  }
};

}  // namespace

void add_simulate_command(const Command& program) {
  auto options = std::make_shared<SimulateCommand>();
  const Command command =
      program.add_command("simulate", "Simulate a frame on a machine, cycle by cycle.", [options] { options->run(); });
  add_frame_options(command, options->frame);
  add_texture_option(command, options->frame.texture);
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
  options->trace.add(command);
  add_map_option(command, options->maps, cost_map_names.size());
  command.add_flag(
      "--critical-path", options->trace.window.critical_path,
      "what the frame's time is owed to, by the chain of causes from its end; in the table, in --stats and in "
      "--trace of .pftrace and .json");
  command.add_flag("--explain", options->explain, "what of the machine was built, why, and what it costs");
}

}  // namespace pyrasim::cli
