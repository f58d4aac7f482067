// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "cli/command.h"
#include "cli/output_plan.h"
#include "cli/revisable_output.h"
#include "error.h"
#include "hw_model/view/page.h"
#include "run/interrupt.h"
#include "run/process_pool.h"
#include "run/recorded_run.h"
#include "run/run_document.h"
#include "run/simulation.h"
#include "text/counted.h"

namespace pyrasim::cli {
namespace {

/// The recorded frame, made again and followed, as the page holds it.
std::string page_run_of(const std::string& file, const Progress& progress) {
  const RecordedRun recorded = load_recorded_run(file);
  const Task task = recorded.on(recorded.run.machine);
  Simulation simulation(task.run, *task.scene,
                        {.intersector = task.intersector, .progress = progress, .textures = task.textures});
  const hw::FrameTables tables(simulation.processor());
  const Outcome outcome = simulation.run();
  require_finished(outcome);
  require_same_cycles(file, recorded, outcome);
  return hw::page_run(simulation.processor(), tables, outcome.cycles, run_document(recorded.run, *recorded.scene), file,
                      recorded.picture);
}

struct ViewCommand {
  static constexpr std::size_t most_runs = 2;

  std::vector<std::string> files;
  std::string output;

  void run() const {
    OutputPlan plan;
    for (const std::string& file : files) plan.reads("RUN", file);
    plan.writes("-o", output, {".html"});
    if (files.size() > most_runs) {
      throw UsageError(fmt::format("RUN: {} are given; a page shows one or two side by side", files.size()));
    }
    RevisableOutput page(output);
    std::vector<std::string> runs;
    JobList jobs{.size = files.size(), .what = "a run of the page"};
    jobs.prepare = [&](std::size_t k) -> Job {
      return [file = files[k]](const Progress& progress) { return page_run_of(file, progress); };
    };
    jobs.take = [&](std::size_t, const std::string& result) { runs.push_back(result); };
    jobs.progress = [](std::size_t) { return progress_bar("simulating"); };
    run_interruptibly(
        [&] {
          ProcessPool::run(jobs, most_runs);
          hw::write_page(page.file(), runs);
        },
        [&] { return fmt::format("with {} of {} simulated", runs.size(), counted(files.size(), "run")); });
    page.commit();
  }
};

}  // namespace

void add_view_command(const Command& program) {
  auto options = std::make_shared<ViewCommand>();
  const Command command = program.add_command(
      "view", "Make a page for browsers of a recorded frame, or of two side by side: picture, timeline, trace trees.",
      [options] { options->run(); });
  command.add_arguments("RUN", options->files, "the recorded frame, of simulate --trace RUN.ptrace; or two").required();
  command.add_text("-o,--output", options->output, "the page; - for stdout").type_name("FILE.html|-").required();
}

}  // namespace pyrasim::cli
