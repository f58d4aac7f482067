// SPDX-License-Identifier: Apache-2.0
#include "run/simulation.h"

#include <fmt/format.h>

#include <chrono>

#include "run/collect_outcome.h"
#include "run/run_simulation.h"
#include "text/counted.h"

namespace pyrasim {
namespace {

Scene seen_by(const Run& run, Scene scene) {
  scene.camera.screen = run.screen;
  scene.camera.window = run.window;
  return scene;
}

hw::SimulationOptions options_of(const Run& run, const HostOptions& host,
                                 const std::shared_ptr<const Intersector>& intersector) {
  hw::SimulationOptions options;
  options.max_level = run.max_level;
  options.edge = run.edge;
  options.texture = run.texture;
  options.engine = run.engine;
  options.formats = run.formats;
  options.intersector = intersector;
  options.max_cycles = run.max_cycles;
  options.threads = host.threads;
  options.progress = host.progress;
  options.maps = host.maps;
  options.textures = host.textures;
  return options;
}

}  // namespace

Simulation::Simulation(const Run& run, const Scene& scene, const HostOptions& host)
    : Simulation(run, seen_by(run, scene), host, Seen()) {}

Simulation::Simulation(const Run& run, const Scene& seen, const HostOptions& host, Seen)
    : intersector_(host.intersector ? host.intersector : make_intersector(seen, run.formats.intersection)),
      processor_("processor", seen, run.machine, options_of(run, host, intersector_)) {
  if (host.work != nullptr) processor_.attach(*host.work);
  if (host.occupancies) occupancies_.emplace(processor_);
  if (host.critical_path) processor_.attach(critical_path_.emplace(processor_));
}

Outcome Simulation::run() {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  run_simulation();
  const std::chrono::duration<double> elapsed = Clock::now() - begin;
  Outcome outcome =
      collect_outcome(processor_, occupancies_ ? &*occupancies_ : nullptr, critical_path_ ? &*critical_path_ : nullptr);
  outcome.host_seconds = elapsed.count();
  return outcome;
}

std::string Simulation::how_far() const {
  return fmt::format("after {}, {} of {} stored", counted(processor_.cycles(), "cycle"),
                     processor_.frame_buffer().stored(), counted(image().pixels().size(), "pixel"));
}

Outcome simulate(const Run& run, const Scene& scene, const HostOptions& host, const Measure& measure) {
  Simulation simulation(run, scene, host);
  Outcome outcome = simulation.run();
  if (measure && outcome.unfinished.empty()) measure(simulation, outcome);
  return outcome;
}

}  // namespace pyrasim
