// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "hw_model/processor.h"
#include "hw_model/record/work_sink.h"
#include "hw_model/report/critical_path.h"
#include "hw_model/trace/occupancies.h"
#include "image/image.h"
#include "run/outcome.h"
#include "run/run.h"

namespace pyrasim {

/// What a run is made with. No result depends on it.
struct HostOptions {
  std::shared_ptr<const Intersector> intersector = {};  ///< of the scene in the run's format; none: it is made
  int threads = 1;                                      ///< from 2 on, one traces ahead for the machine
  Progress progress = {};
  CostMaps* maps = nullptr;  ///< of what the run renders, to be filled
  /// As in hw::SimulationOptions.
  std::shared_ptr<const hw::RecordedTextures> textures = {};
  hw::WorkSink* work = nullptr;  ///< takes what rays and nodes take
  bool occupancies = false;      ///< the outcome says how full FIFOs were over time
  bool critical_path = false;    ///< and what the frame's time was owed to; costs as much as a trace
};

/// A run in this process, in which there can be one: SystemC elaborates once a process. Throws as hw::Processor does.
class Simulation {
 public:
  /// `scene` is that of the run, seen through whatever camera.
  Simulation(const Run& run, const Scene& scene, const HostOptions& host);

  /// For sinks of its events, before run(), and for the picture afterwards.
  hw::Processor& processor() { return processor_; }
  const Image& image() const { return processor_.image(); }
  const Intersector& intersector() const { return *intersector_; }
  /// Throws as run_simulation() does.
  Outcome run();
  /// How far it came, for who interrupts it: "after 20 cycles, 3 of 12 pixels stored".
  std::string how_far() const;

 private:
  struct Seen {};  ///< the scene's camera is the run's
  Simulation(const Run& run, const Scene& seen, const HostOptions& host, Seen);

  std::shared_ptr<const Intersector> intersector_;
  hw::Processor processor_;
  std::optional<hw::Occupancies> occupancies_;
  std::optional<hw::CriticalPath> critical_path_;
};

/// Adds to the outcome of a finished frame what is to be known of it beside.
using Measure = std::function<void(const Simulation& finished, Outcome& outcome)>;

/// Makes a run in this process, and measures it where the frame is finished. Throws as Simulation does.
Outcome simulate(const Run& run, const Scene& scene, const HostOptions& host, const Measure& measure = {});

}  // namespace pyrasim
