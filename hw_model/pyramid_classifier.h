// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "hw_model/fifo/fifo_port.h"
#include "hw_model/fifo/fifo_ports.h"
#include "hw_model/fifo/fifo_writer.h"
#include "hw_model/message.h"
#include "hw_model/plan/frame_setup.h"
#include "hw_model/stage/stage_of.h"
#include "render/frame_statistics.h"

namespace pyrasim::hw {

/// Puts samples together to pyramids and decides their case. Takes the samples in the order in which their rays were
/// issued: from the units in turn, or as the issue-order queue says.
///
/// A corner of the raster completes at most one pixel, with three corners from one line buffer. Of the five
/// samples of a subdivision, the third completes the first subpixel, the fourth the second and the fifth the last two;
/// so a family takes six firings. Terminal nodes go to the colour unit, nodes to subdivide to the controller.
class PyramidClassifier final : public StageOf<PyramidClassifier> {
 public:
  FifoPorts<SampleMessage> samples;  ///< of each intersection unit, or of the shadow unit behind it
  OptionalFifoPort<UnitNumber> issue_order_queue{"issue_order_queue"};  ///< from the generator; only under first_free
  OptionalFifoPort<NodeMessage> parents{"parents"};  ///< the nodes whose five samples are under way, in order
  OptionalFifoPort<NodeMessage> subdivision_controller{"subdivision_controller"};
  FifoPort<TerminalMessage> color_unit{"color_unit"};

  PyramidClassifier(const sc_core::sc_module_name& name, const FrameSetup& frame);

  int max_level() const { return max_level_; }
  /// Counts of cases, subdivisions and terminal nodes.
  const FrameStatistics& counts() const { return counts_; }

 private:
  friend StageOf;
  /// A pyramid whose four corners are known. Made in place: copying what has just been stored in pieces stalls a
  /// processor.
  struct Node {
    /// The pixel that a corner completes, as its lower right one.
    Node(const PyramidClassifier& classifier, const SampleMessage& lower_right);
    /// Subpixel `child` of the classifier's parent, of which the lower right sample has not been taken yet.
    Node(const PyramidClassifier& classifier, std::size_t child, const Sample& lower_right);

    const PixelTag& tag;
    Cell cell;
    CornerSamples corners;
    PyramidCase which;
    bool subdivide;
    bool closes_family = false;
    bool to_controller() const { return subdivide || closes_family; }
  };
  /// What a firing does, known from the data alone.
  struct Plan {
    explicit Plan(Cycle ready) : start(ready) {}
    Start start;
    Fifo<SampleMessage>* samples = nullptr;  ///< that it reads a sample from; none where it reads none
    bool reads_parent = false;
    std::optional<Node> node;  ///< that is complete
  };
  struct Ends {
    FifoWriter<TerminalMessage> color_unit;
  };
  Ends ends() const { return {FifoWriter(*color_unit)}; }
  Plan next(const Ends& ends, Cycle ready) const;
  Cycle fire(Ends& ends, const Plan& plan);

  bool plan_sample(Plan& plan) const;
  void take_sample(Fifo<SampleMessage>& fifo, Cycle now);
  void emit(Ends& ends, const Node& node, Cycle now);

  StageTiming timing_;
  int max_level_;
  PixelWindow window_;
  std::uint32_t columns_;            ///< N_z of the window
  std::size_t unit_ = 0;             ///< that the next sample comes from, where the units take turns
  std::vector<Sample> line_buffer_;  ///< the newest corner sample of each of the N_z + 1 columns
  Sample upper_left_;                ///< and of the last column the one before
  std::uint32_t column_ = 0;         ///< of the next corner
  NodeMessage parent_;               ///< the node whose samples are arriving
  SubdivisionSamples middle_;        ///< its samples so far
  std::size_t samples_ = 0;          ///< how many of them; 5 while the last subpixel waits
  FrameStatistics counts_;
  CostMaps* maps_;  ///< or null
};

extern template class StageOf<PyramidClassifier>;

}  // namespace pyrasim::hw
