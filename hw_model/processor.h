// SPDX-License-Identifier: Apache-2.0
// The top of the machine: builds what the scene requires, binds it, runs it, and keeps the results.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "hw_model/decoupled_engine.h"
#include "hw_model/frame_buffer.h"
#include "hw_model/intersection_unit.h"
#include "hw_model/machine_spec.h"
#include "hw_model/pixel_scan.h"
#include "hw_model/pyramid_classifier.h"
#include "hw_model/run_control.h"
#include "hw_model/subdivision_controller.h"
#include "hw_model/tree_accumulator.h"
#include "hw_model/view_vector_generator.h"
#include "hw_model/wire.h"

namespace pyrasim::hw {

enum class Engine : std::uint8_t {
  decoupled,  ///< stages run ahead in their own time; fast
  lockstep,   ///< every advance of time is a wait on the SystemC kernel; slow, and the oracle
};

struct SimulationOptions {
  int max_level = 3;
  EdgePolicy edge = EdgePolicy::mean;
  Engine engine = Engine::decoupled;
  DatapathFormats formats;
  /// Of the scene in formats.intersection; none: the machine makes its own.
  std::shared_ptr<const Intersector> intersector;
  Cycle max_cycles = never;   ///< the machine stops once it cannot end within so many
  int threads = 1;            ///< of the host: from 2 on, one traces corners ahead for the decoupled engine
  bool check_machine = true;  ///< refuse a machine that cannot hold the frame; off only to see it deadlock
  Progress progress;
};

/// A box of the block diagram that was left out, and why.
struct OmittedUnit {
  std::string name;
  std::string reason;
  friend bool operator==(const OmittedUnit&, const OmittedUnit&) = default;
};

/// One machine, rendering one frame. Several may be elaborated side by side before the simulation starts. Elaborate,
/// call sc_core::sc_start(), then read the results. Throws InputError where the machine cannot hold a pixel's tree,
/// LimitError where the picture is too large.
class Processor final : public sc_core::sc_module {
 public:
  Processor(const sc_core::sc_module_name& name, const Scene& scene, const MachineSpec& spec,
            const SimulationOptions& options);

  /// Whether every pixel has been stored. If not once the simulation is over, the machine is deadlocked, or was stopped
  /// at max_cycles() or by its progress. See report/deadlock.h.
  bool complete() const { return frame_buffer_.complete(); }
  /// No frame is finished after it: options.max_cycles, or longest_frame.
  Cycle max_cycles() const { return max_cycles_; }
  const FrameBuffer& frame_buffer() const { return frame_buffer_; }
  /// Whether no stage can fire.
  bool at_rest() const;

  /// The frame's cycles: from 0 until the last pixel is stored and every stage is at rest.
  Cycle cycles() const;
  const Image& image() const { return frame_buffer_.image(); }
  FrameStatistics statistics() const;

  const MachineSpec& spec() const { return spec_; }
  /// In data-flow order, of what was built.
  const std::vector<Stage*>& stages() const { return stages_; }
  const std::vector<FifoBase*>& fifos() const { return fifos_; }
  const std::vector<Wire>& wires() const { return wires_; }
  const Wire& wire_of(const FifoBase& fifo) const;
  /// Row and column on the screen of a pixel that is numbered inside the window.
  std::pair<int, int> place_of(std::uint32_t pixel) const;
  const TreeAccumulator& tree_accumulator() const { return tree_accumulator_; }
  const SceneContents& contents() const { return contents_; }
  const std::vector<OmittedUnit>& omitted() const { return omitted_; }
  const SubdivisionController* controller() const { return controller_.get(); }

 private:
  template <class Message, class Writer, class Reader, class Out, class In>
  Fifo<Message>& connect(const char* name, std::size_t depth, Writer& writer, Out&& out, Reader& reader, In&& in);
  void bind();
  void bind_controller();
  void list_omitted();
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
  PixelScan pixel_scan_;
  ViewVectorGenerator view_vector_generator_;
  std::vector<std::unique_ptr<IntersectionUnit>> intersection_units_;
  PyramidClassifier pyramid_classifier_;
  std::unique_ptr<SubdivisionController> controller_;  ///< none where nothing is subdivided
  TreeAccumulator tree_accumulator_;
  FrameBuffer frame_buffer_;
  std::vector<std::unique_ptr<FifoBase>> channels_;
  std::vector<Stage*> stages_;
  std::vector<FifoBase*> fifos_;
  std::vector<Wire> wires_;
  std::vector<OmittedUnit> omitted_;
  std::unique_ptr<DecoupledEngine> engine_;
};

}  // namespace pyrasim::hw
