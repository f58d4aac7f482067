// SPDX-License-Identifier: Apache-2.0
// The top of the machine: builds what the scene requires, binds it, runs it, and keeps the results.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "hw_model/decoupled_engine.h"
#include "hw_model/plan/stage_list.h"
#include "hw_model/plan/wire_list.h"
#include "hw_model/record/work_sink.h"
#include "hw_model/run_control.h"
#include "hw_model/simulation_options.h"
#include "hw_model/trace/event_stream.h"
#include "hw_model/wire.h"

namespace pyrasim::hw {

/// A box of the block diagram, or a part of one.
struct MachinePart {
  std::string box;
  std::string part;       ///< of the box; empty: the box itself
  std::size_t units = 0;  ///< side by side; 0: it was left out
  std::string reason;     ///< why it was built, or left out
  Cycle busy = 0;         ///< sum over the units

  std::string name() const { return part.empty() ? box : box + "." + part; }
  friend bool operator==(const MachinePart&, const MachinePart&) = default;
};

/// One machine, rendering one frame. Several may be elaborated side by side before the simulation starts. Elaborate,
/// call sc_core::sc_start(), then read the results. Throws InputError where the machine cannot hold a pixel's tree,
/// LimitError where the picture is too large.
class Processor final : public sc_core::sc_module {
 public:
  Processor(const sc_core::sc_module_name& name, const Scene& scene, const MachineSpec& spec,
            const SimulationOptions& options);

  /// `sink` takes the machine's events; before the simulation starts. It has to outlive it.
  void attach(EventSink& sink);
  /// `sink` takes the work of rays and nodes, likewise; one of them.
  void attach(WorkSink& sink);
  const EventStream& events() const { return events_; }

  /// Whether every pixel has been stored. If not once the simulation is over, the machine is deadlocked, or was stopped
  /// at max_cycles() or by its progress. See report/deadlock.h.
  bool complete() const { return the<FrameBuffer>().complete(); }
  /// No frame is finished after it: options.max_cycles, or longest_frame.
  Cycle max_cycles() const { return max_cycles_; }
  const FrameBuffer& frame_buffer() const { return the<FrameBuffer>(); }
  /// Whether no stage can fire.
  bool at_rest() const;

  /// The frame's cycles: from 0 until the last pixel is stored and every stage is at rest.
  Cycle cycles() const;
  const Image& image() const { return the<FrameBuffer>().image(); }
  FrameStatistics statistics() const;

  const MachineSpec& spec() const { return spec_; }
  /// In data-flow order, of what was built.
  const std::vector<Stage*>& stages() const { return stages_; }
  /// In stages().
  std::size_t number_of(const Stage& stage) const;
  const std::vector<FifoBase*>& fifos() const { return fifos_; }
  const std::vector<Wire>& wires() const { return wires_; }  ///< of fifos(), one by one
  const Wire& wire_of(const FifoBase& fifo) const;
  /// Row and column on the screen of a pixel that is numbered inside the window.
  std::pair<int, int> place_of(std::uint32_t pixel) const;
  /// The number inside the window of the pixel at a place on the screen; none where that is not rendered.
  std::optional<std::uint32_t> pixel_at(int row, int column) const;
  int max_level() const { return the<PyramidClassifier>().max_level(); }
  const TreeAccumulator& tree_accumulator() const { return the<TreeAccumulator>(); }
  const SceneContents& contents() const { return contents_; }
  /// In data-flow order, each box followed by its parts, built or not; cycles are known after the frame.
  std::vector<MachinePart> parts() const;
  /// None where nothing is subdivided.
  const SubdivisionController* controller() const { return optional<SubdivisionController>(); }

 private:
  template <class Stage>
  using Built = std::vector<std::unique_ptr<Stage>>;
  template <class... Stage>
  static std::tuple<Built<Stage>...> none_of(const std::tuple<StagePlan<Stage>...>& stages);

  template <class Stage>
  const Built<Stage>& all() const {
    return std::get<Built<Stage>>(built_);
  }
  /// A stage of which there is one in every machine.
  template <class Stage>
  Stage& the() const {
    return *all<Stage>().front();
  }
  /// A stage that is left out of some.
  template <class Stage>
  Stage* optional() const {
    return all<Stage>().empty() ? nullptr : all<Stage>().front().get();
  }

  template <class Stage>
  void build(const StagePlan<Stage>& plan, const FrameSetup& frame);
  template <class Out, class Writer, class In, class Reader>
  void connect(const WirePlan<Out, Writer, In, Reader>& plan);
  template <class Stage>
  void list(const StagePlan<Stage>& plan, const Need& need, std::vector<MachinePart>& parts) const;
  Progress stopping(const Progress& progress);
  void run_decoupled(int threads);

  Cycle max_cycles_;
  RunControl control_;
  MachineSpec spec_;
  PixelWindow window_;
  DatapathFormats formats_;
  std::shared_ptr<const Intersector> intersector_;
  ViewVectors view_vectors_;
  SceneContents contents_;
  decltype(none_of(stage_list)) built_;
  std::vector<std::unique_ptr<FifoBase>> channels_;
  std::vector<Stage*> stages_;
  std::vector<FifoBase*> fifos_;
  std::vector<Wire> wires_;
  std::vector<Need> needs_;                  ///< of the list's stages, one by one
  std::unique_ptr<DecoupledEngine> engine_;  ///< none in lockstep
  EventStream events_;
};

}  // namespace pyrasim::hw
