// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "hw_model/machine_spec.h"
#include "hw_model/message.h"
#include "hw_model/stage.h"
#include "render/frame_statistics.h"

namespace pyrasim::hw {

/// Puts samples together to pyramids and decides their case. Takes the samples in the order in which their rays were
/// issued: from the units in turn, or as the reorder buffer says.
///
/// A corner of the raster completes at most one pixel, with three corners from one row of corner samples. Of the five
/// samples of a subdivision, the third completes the first subpixel, the fourth the second and the fifth the last two;
/// so a family takes six firings. Terminal nodes go to the tree accumulator, nodes to subdivide to the controller.
class PyramidClassifier final : public StageOf<PyramidClassifier> {
 public:
  sc_core::sc_vector<FifoPort<SampleMessage>> intersection_units;
  OptionalFifoPort<UnitNumber> reorder_buffer{"reorder_buffer"};  ///< from the generator; only under first_free
  OptionalFifoPort<NodeMessage> parents{"parents"};  ///< the nodes whose five samples are under way, in order
  OptionalFifoPort<NodeMessage> subdivision_controller{"subdivision_controller"};
  FifoPort<TerminalMessage> tree_accumulator{"tree_accumulator"};

  PyramidClassifier(const sc_core::sc_module_name& name, StageTiming timing, std::size_t units, const Scene& scene,
                    Leaf leaf, int max_level);

  int max_level() const { return max_level_; }
  /// Counts of cases, subdivisions and terminal nodes.
  const FrameStatistics& counts() const { return counts_; }

 private:
  friend StageOf;
  struct Ends {
    FifoWriter<TerminalMessage> tree_accumulator;
  };
  Ends ends() { return {FifoWriter(*tree_accumulator)}; }
  Start next(Ends& ends, Cycle ready);
  Cycle fire(Ends& ends, Cycle now);

  /// What the next firing does, known from the data alone.
  struct Step {
    bool known = false;
    bool reads_sample = false;
    bool reads_parent = false;
    bool has_node = false;  ///< a pyramid is complete
    NodeMessage node;       ///< the pyramid, and whether it is subdivided
    PyramidCase which = PyramidCase::empty;
    bool to_controller() const { return has_node && (node.subdivide || node.closes_family); }
    bool to_accumulator() const { return has_node && !node.subdivide; }
  };

  Start await_sample(Start start) const;
  void plan();
  void plan_corner(const SampleMessage& message);
  void plan_subpixel(std::size_t child);
  void classify_node();
  void take_sample(Cycle now);
  void emit(Ends& ends, Cycle now);

  StageTiming timing_;
  Palette palette_;
  Leaf leaf_;
  int max_level_;
  std::uint32_t columns_;
  std::size_t unit_ = 0;            ///< that the next sample comes from
  std::vector<Sample> corner_row_;  ///< the last N_z + 2 corner samples: one row and one more
  std::size_t corner_ = 0;          ///< where the next corner goes in the ring corner_row_
  NodeMessage parent_;              ///< the node whose samples are arriving
  SubdivisionSamples middle_;       ///< its samples so far
  std::size_t samples_ = 0;         ///< how many of them; 5 while the last subpixel waits
  Step step_;                       ///< planned as soon as its data is there
  FrameStatistics counts_;
};

extern template class StageOf<PyramidClassifier>;

}  // namespace pyrasim::hw
