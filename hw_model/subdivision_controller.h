// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <deque>
#include <vector>

#include "hw_model/fifo/fifo_port.h"
#include "hw_model/fifo/fifo_reader.h"
#include "hw_model/fifo/fifo_writer.h"
#include "hw_model/message.h"
#include "hw_model/plan/frame_setup.h"
#include "hw_model/stage/stage_of.h"

namespace pyrasim::hw {

/// Holds the nodes that wait for their subdivision and releases them, deepest and newest first.
///
/// A node that comes back from the loop always finds room: a request is issued only while the pool still holds its
/// whole subtree worked off depth first, 3 further entries a level (the banker's rule). Pixels wait in the slots of the
/// pixels in flight and take no entry of the pool; only when no subpixel waits does the next pixel's turn come.
/// In a firing the controller either accepts a node or issues a request; what is possible first goes first, accepting
/// before issuing.
class SubdivisionController final : public StageOf<SubdivisionController> {
 public:
  FifoPort<NodeMessage> pyramid_classifier{"pyramid_classifier"};
  FifoPort<SubdivisionRequest> view_vector_generator{"view_vector_generator"};
  FifoPort<NodeMessage> parents{"parents"};  ///< to the classifier, see there

  SubdivisionController(const sc_core::sc_module_name& name, const FrameSetup& frame);

  bool chooses_by_arrival() const override { return true; }

  /// Fires, once at least, before `horizon`, which next_start() has to be. Requires that nothing comes to be seen
  /// meanwhile that could be read before `horizon`.
  void fire_before(Cycle horizon);

  std::size_t pool_depth() const { return pool_; }
  std::size_t pool_max() const { return most_used_; }
  /// Entries in use or reserved.
  std::size_t pool_kept() const { return subpixels_.size() + reserved_; }
  /// Entries that have to be left for the next request to be issued; 0 where no node waits.
  std::size_t pool_needed() const;

 private:
  friend StageOf;
  /// A firing either accepts a node or issues a request.
  struct Plan {
    Start start;
    bool accepts;
  };
  struct Ends {
    FifoReader<NodeMessage> pyramid_classifier;
    FifoWriter<SubdivisionRequest> view_vector_generator;
    FifoWriter<NodeMessage> parents;
  };
  Ends ends() const {
    return {FifoReader(*pyramid_classifier), FifoWriter(*view_vector_generator), FifoWriter(*parents)};
  }
  Plan next(const Ends& ends, Cycle ready) const;
  Cycle fire(Ends& ends, const Plan& plan);
  bool can_issue() const;
  void accept(const NodeMessage& node);
  void issue(Ends& ends, Cycle now);
  /// The subpixels of a request may come back for subdivision.
  static bool family_returns(const Cell& request) { return request.log2_side > 1; }

  StageTiming timing_;
  std::size_t pool_;
  int max_level_;
  std::deque<NodeMessage> pixels_;      ///< pixels, in order of arrival
  std::vector<NodeMessage> subpixels_;  ///< the pool: parts of pixels, the newest last
  std::size_t reserved_ = 0;            ///< entries kept for subpixels under way
  std::size_t unsettled_ = 4;           ///< of them, those of the family that is coming in
  std::size_t most_used_ = 0;
};

}  // namespace pyrasim::hw
