// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <iostream>
#include <memory>

#include "cli/asked_run.h"
#include "cli/command.h"
#include "cli/frame_table.h"
#include "cli/machine_options.h"
#include "cli/pixel_report.h"
#include "run/interrupt.h"
#include "run/simulation.h"
#include "text/printable.h"

namespace pyrasim::cli {
namespace {

struct PixelCommand {
  FrameOptions frame;
  MachineOptions machine;
  std::string pixel;

  void run() const {
    const auto [asked, scene] = asked_run(frame, machine);
    const auto [row, column] = parse_pixel(pixel, asked.rendered(), "PIXEL");
    Simulation simulation(asked, *scene, {.progress = progress_bar("simulating")});
    hw::Processor& processor = simulation.processor();
    hw::PixelHistory history(processor, processor.pixel_at(row, column).value());
    SeenPoints seen;
    processor.attach(history);
    processor.attach(seen);
    Outcome outcome;
    run_interruptibly([&] { outcome = simulation.run(); }, [&] { return simulation.how_far(); });
    require_finished(outcome);
    std::cout << fmt::format("row {}, column {} of {}, MAX_LEVEL {}, on machine {}\n\n", row, column,
                             frame_title(asked.scene.name, asked.screen, asked.window), asked.max_level,
                             excerpt(asked.machine.title()))
              << pixel_report(*scene, processor, history, seen);
  }
};

}  // namespace

void add_pixel_command(const Command& program) {
  auto options = std::make_shared<PixelCommand>();
  const Command command = program.add_command("pixel",
                                              "One pixel of a simulated frame: its trace tree with what each ray sees, "
                                              "when it was issued, served and seen, and "
                                              "what the pixel waited for.",
                                              [options] { options->run(); });
  add_frame_options(command, options->frame);
  command.add_text("PIXEL", options->pixel, "which one, counted on the screen from 0: its row, and its column")
      .type_name("ROW,COLUMN")
      .required();
  add_texture_option(command, options->frame.texture);
  add_window_option(command, options->frame);
  add_scalar_option(command, options->frame.scalar);
  options->machine.add(command);
  options->machine.add_limit(command);
}

}  // namespace pyrasim::cli
