// SPDX-License-Identifier: Apache-2.0
// How fast has the memory behind the frame buffer to be? A stage and two sinks of one's own beside a machine that knows
// nothing of them. The frame buffer does not wait for the memory; the example shows how much would have to.
// Usage: memory_port SCENE.json CYCLES_A_PIXEL [decoupled|lockstep]
#include <algorithm>
#include <charconv>
#include <iostream>
#include <string_view>
#include <systemc>

#include "error.h"
#include "hw_model/processor.h"
#include "hw_model/report/deadlock.h"
#include "memory_port.h"
#include "scene/load_scene.h"
#include "sinks.h"

namespace {

using namespace pyrasim;

void simulate(const char* scene_file, hw::Cycle interval, hw::Engine engine) {
  const Scene scene = load_scene(scene_file);
  hw::SimulationOptions options;
  options.engine = engine;
  hw::Processor processor("processor", scene, hw::load_machine({}), options);

  // Wires and stages of one's own: every stage outside the processor runs in lockstep, whatever the processor does.
  hw::Fifo<StoredPixel> queue("queue", processor.image().pixels().size());
  MemoryPort port("memory_port", interval);
  port.pixels(queue);
  queue.connect(port, port);  // whom to wake; nobody waits for room
  const hw::RunControl control{hw::longest_frame, [] {}};
  port.run_in_lockstep(control);

  const std::size_t last_stage = processor.stages().size() - 1;
  const hw::Stage& frame_buffer = *processor.stages()[last_stage];
  const auto to_frame_buffer = std::find_if(processor.wires().begin(), processor.wires().end(),
                                            [&](const hw::Wire& wire) { return wire.reader == &frame_buffer; });
  StoredPixels stored(static_cast<std::size_t>(to_frame_buffer - processor.wires().begin()), queue);
  LongestWait wait(last_stage);
  processor.attach(stored);
  processor.attach(wait);

  sc_core::sc_start();
  hw::require_finished(processor);

  const hw::Cycle end = std::max(processor.cycles(), port.ready());
  std::cout << "frame " << processor.cycles() << " cycles, memory " << port.ready() << " cycles\n"
            << "pixels " << port.statistics(end).firings << ", most waiting " << queue.statistics(end).max << '\n'
            << "longest wait of " << frame_buffer.basename() << ' ' << wait.cycles() << " cycles\n";
}

}  // namespace

int sc_main(int argc, char** argv) {
  const std::string_view engine = argc == 4 ? argv[3] : "decoupled";
  const std::string_view cycles = argc >= 3 ? argv[2] : "";
  hw::Cycle interval = 0;
  std::from_chars(cycles.data(), cycles.data() + cycles.size(), interval);
  if (argc > 4 || interval < 1 || (engine != "decoupled" && engine != "lockstep")) {
    std::cerr << "usage: memory_port SCENE.json CYCLES_A_PIXEL [decoupled|lockstep]\n";
    return exit_usage;
  }
  try {
    simulate(argv[1], interval, engine == "lockstep" ? hw::Engine::lockstep : hw::Engine::decoupled);
    return exit_ok;
  } catch (const Error& error) {
    std::cerr << "memory_port: " << error.what() << '\n';
    return error.exit_code();
  }
}
