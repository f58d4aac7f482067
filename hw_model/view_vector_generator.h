// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "camera/view_vector.h"
#include "hw_model/fifo/fifo_port.h"
#include "hw_model/fifo/fifo_ports.h"
#include "hw_model/fifo/fifo_reader.h"
#include "hw_model/message.h"
#include "hw_model/plan/frame_setup.h"
#include "hw_model/stage/stage_of.h"
#include "intersect/datapath_formats.h"

namespace pyrasim::hw {

/// Computes view vectors by formulas (2) to (5): one for a corner of the raster, five for a subdivision request, one a
/// firing; and deals the rays out to the intersection units, as the dispatch policy says. Requests go before corners,
/// so that a pixel that is begun is finished; a request's five rays stay together.
class ViewVectorGenerator final : public StageOf<ViewVectorGenerator> {
 public:
  FifoPort<CornerRequest> pixel_scan{"pixel_scan"};
  OptionalFifoPort<SubdivisionRequest> subdivision_controller{"subdivision_controller"};
  FifoPorts<RayMessage> intersection_units;
  OptionalFifoPort<UnitNumber> issue_order_queue{"issue_order_queue"};  ///< to the classifier; only under first_free

  ViewVectorGenerator(const sc_core::sc_module_name& name, const FrameSetup& frame);

  bool chooses_by_arrival() const override { return true; }

  /// Whether no token that is still unseen could be a corner that goes first.
  bool sees_next_corner() const { return rays_left_ > 0 || !pixel_scan->empty(); }
  /// Whether the unit that a ray goes to depends on what has room first.
  bool chooses_unit() const { return dispatch_ == Dispatch::first_free; }
  /// Fires before `horizon`: until the next corner is not seen, or a request has been read that makes room where there
  /// was none. Returns whether it fired at all. Requires that whatever could still come to be seen comes later
  /// than next_start().
  bool fire_before(Cycle horizon);
  /// That the next ray goes to, where the generator does not choose.
  std::size_t next_unit() const { return unit_; }
  /// Rays issued to form subpixels of each level; [0] are the corners of the raster.
  const std::array<std::uint64_t, max_level_limit + 1>& rays_by_level() const { return rays_by_level_; }
  /// Of the arithmetic, where the constructor was told to count; costs a little.
  const ArithmeticEvents& events() const { return events_; }

 private:
  friend StageOf;
  /// The next ray.
  struct Plan {
    Start start;
    bool reads_request;  ///< it is the first of a request
    std::size_t unit;    ///< that it goes to
  };
  struct Ends {
    FifoReader<CornerRequest> pixel_scan;
    bool made_room = false;  ///< for a request, where there was none
  };
  Ends ends() const { return {FifoReader(*pixel_scan), false}; }
  Plan next(const Ends& ends, Cycle ready) const;
  Cycle fire(Ends& ends, const Plan& plan);
  bool request_goes_first(const Ends& ends, Cycle ready) const;
  Start with_room(Start start) const;
  std::size_t following(std::size_t unit) const { return unit + 1 == intersection_units.size() ? 0 : unit + 1; }
  std::size_t earliest_unit() const;
  std::size_t free_unit(Cycle now) const;
  glm::dvec3 view_vector(GridPoint point);
  void issue(GridPoint point, std::uint32_t level, const PixelTag& tag, const Plan& plan);

  StageTiming timing_;
  Dispatch dispatch_;
  ViewVectors view_vectors_;
  bool count_events_;
  int max_level_;
  Cell request_;               ///< whose rays are being issued
  std::size_t rays_left_ = 0;  ///< of request_
  std::size_t unit_ = 0;       ///< that the next ray goes to, or from which first_free counts on
  std::array<std::uint64_t, max_level_limit + 1> rays_by_level_{};
  ArithmeticEvents events_;
};

}  // namespace pyrasim::hw
