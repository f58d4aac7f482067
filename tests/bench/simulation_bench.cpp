// SPDX-License-Identifier: Apache-2.0
// Renderer, simulator and plain SystemC in one run, taken in turns so that all see the same machine:
//     simulation_bench SCENE MAX_LEVEL ROUNDS COLUMNSxROWS [machine settings]
// Prints one line of JSON; times are the fastest of the rounds, in nanoseconds.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "../hw_model/cycle_loop.h"
#include "hw_model/processor.h"
#include "render/pyramid_renderer.h"
#include "scene/load_scene.h"

namespace {

using namespace pyrasim;

constexpr int transfers = 200'000;

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// The yardstick: tokens through an sc_fifo between two SC_THREADs, one a nanosecond of simulated time.
struct FifoYardstick : sc_core::sc_module {
  sc_core::sc_fifo<int> fifo{"fifo", 8};
  sc_core::sc_time begin{1, sc_core::SC_SEC};  ///< after everything else is over
  double started = 0;
  double seconds = 0;

  explicit FifoYardstick(const sc_core::sc_module_name& name) : sc_module(name) {
    sc_core::sc_spawn([this] { write(); }, "writer");
    sc_core::sc_spawn([this] { read(); }, "reader");
  }
  void write() {
    sc_core::wait(begin);
    started = seconds_now();
    for (int k = 0; k < transfers; ++k) {
      fifo.write(k);
      sc_core::wait(1, sc_core::SC_NS);
    }
  }
  void read() {
    for (int k = 0; k < transfers; ++k) {
      fifo.read();
      sc_core::wait(1, sc_core::SC_NS);
    }
    seconds = seconds_now() - started;
  }
};

struct Times {
  double render = 1e9;
  double render_two_threads = 1e9;
  double decoupled = 1e9;
  double decoupled_two_threads = 1e9;
  double lockstep = 1e9;
  double cycle_loop = 1e9;
};

void keep_fastest(double& best, double seconds) { best = std::min(best, seconds); }

int run(const std::string& file, int max_level, int rounds, const std::string& size,
        const std::vector<std::string>& settings) {
  Scene scene = load_scene(file);
  const std::size_t cross = size.find('x');
  scene.camera.screen =
      resized(scene.camera.screen, std::stoi(size.substr(0, cross)), std::stoi(size.substr(cross + 1)));
  const hw::MachineSpec spec = hw::load_machine(std::nullopt, settings);
  const SceneIntersector<double> intersector(scene);
  Times times;
  FrameStatistics frame;
  double begun = 0;
  const auto render = [&](int threads, double& best) {
    const double start = seconds_now();
    frame = render_pyramids(scene, intersector, {max_level, EdgePolicy::mean, Reuse::none, threads}).statistics;
    keep_fastest(best, seconds_now() - start);
    begun = seconds_now();
  };
  std::vector<std::unique_ptr<hw::Processor>> processors;
  const auto until_end = [&](double& time) {
    return [&](double share) {
      if (share >= 1) keep_fastest(time, seconds_now() - begun);
      return true;
    };
  };
  hw::SimulationOptions options;
  options.max_level = max_level;
  for (int round = 0; round < rounds; ++round) {
    sc_core::sc_spawn([&] {
      render(2, times.render_two_threads);
      render(1, times.render);
    });
    options.progress = until_end(times.decoupled);
    processors.push_back(
        std::make_unique<hw::Processor>(fmt::format("decoupled_{}", round).c_str(), scene, spec, options));
    options.progress = until_end(times.decoupled_two_threads);
    options.threads = 2;
    sc_core::sc_spawn([&] { begun = seconds_now(); });
    processors.push_back(
        std::make_unique<hw::Processor>(fmt::format("two_threads_{}", round).c_str(), scene, spec, options));
    options.threads = 1;
  }
  options.engine = hw::Engine::lockstep;
  options.progress = until_end(times.lockstep);
  sc_core::sc_spawn([&] { begun = seconds_now(); });
  processors.push_back(std::make_unique<hw::Processor>("lockstep", scene, spec, options));
  FifoYardstick yardstick("yardstick");
  sc_core::sc_start();

  const double loop_begun = seconds_now();
  const hw::Timeline timeline = hw::run_cycle_loop(scene, spec, max_level);
  keep_fastest(times.cycle_loop, seconds_now() - loop_begun);
  if (timeline.cycles != processors.front()->cycles()) std::cerr << "the cycle loop disagrees\n";

  const auto rays = static_cast<double>(frame.total_rays());
  std::cout << fmt::format(
      "{{\"scene\": \"{}\", \"max_level\": {}, \"units\": {}, \"rays\": {}, \"cycles\": {}, \"render\": {:.1f}, "
      "\"render_two_threads\": {:.1f}, \"decoupled\": {:.1f}, \"decoupled_two_threads\": {:.1f}, \"lockstep\": {:.1f}, "
      "\"cycle_loop\": {:.1f}, "
      "\"sc_fifo_transfer\": {:.1f}}}\n",
      file, max_level, spec.intersection_units, frame.total_rays(), processors.front()->cycles(),
      times.render / rays * 1e9, times.render_two_threads / rays * 1e9, times.decoupled / rays * 1e9,
      times.decoupled_two_threads / rays * 1e9, times.lockstep / rays * 1e9, times.cycle_loop / rays * 1e9,
      yardstick.seconds / transfers * 1e9);
  return 0;
}

}  // namespace

int sc_main(int argc, char** argv) {
  if (argc < 5) {
    std::cerr << "usage: simulation_bench SCENE MAX_LEVEL ROUNDS COLUMNSxROWS [PATH=VALUE]...\n";
    return 2;
  }
  return run(argv[1], std::atoi(argv[2]), std::atoi(argv[3]), argv[4], {argv + 5, argv + argc});
}

int main(int argc, char** argv) {
  setenv("SYSTEMC_DISABLE_COPYRIGHT_MESSAGE", "1", 1);
  return sc_core::sc_elab_and_sim(argc, argv);
}
