// SPDX-License-Identifier: Apache-2.0
#include "hw_model/view_vector_generator.h"

namespace pyrasim::hw {

ViewVectorGenerator::ViewVectorGenerator(const sc_core::sc_module_name& name, StageTiming timing, std::size_t units,
                                         Dispatch dispatch, const ViewVectors& view_vectors, bool count_events,
                                         int max_level)
    : StageOf(name),
      intersection_units("intersection_unit", units),
      timing_(timing),
      dispatch_(units == 1 ? Dispatch::round_robin : dispatch),
      view_vectors_(view_vectors),
      count_events_(count_events),
      max_level_(max_level) {}

Start ViewVectorGenerator::next(Ends& ends, Cycle ready) {
  Start start(ready);
  if (rays_left_ == 0) {
    reads_request_ = request_goes_first(ends, ready);
    if (reads_request_) {
      start.needs_token(*subdivision_controller);
    } else {
      start.needs_token(ends.pixel_scan);
    }
  }
  return with_room(start);
}

/// A request goes first that is there no later than the corner, or than anything at all could be issued.
bool ViewVectorGenerator::request_goes_first(Ends& ends, Cycle ready) {
  if (!subdivision_controller.bound() || subdivision_controller->empty()) return false;
  const Cycle request = subdivision_controller->token();
  return request <= ends.pixel_scan.token() || request <= with_room(Start(ready)).at();
}

/// `start`, once there is room for the ray; under first_free this settles which unit it goes to.
Start ViewVectorGenerator::with_room(Start start) {
  return chooses_unit() ? with_free_unit(start) : start.needs_room(*intersection_units[unit_]);
}

Start ViewVectorGenerator::with_free_unit(Start start) {
  const auto following = [&](std::size_t unit) { return unit + 1 == intersection_units.size() ? 0 : unit + 1; };
  std::size_t earliest = unit_;
  for (std::size_t unit = following(unit_); unit != unit_; unit = following(unit)) {
    if (intersection_units[unit]->room() < intersection_units[earliest]->room()) earliest = unit;
  }
  start.needs_room(*intersection_units[earliest]).needs_room(*reorder_buffer);
  free_unit_ = unit_;
  while (start.known() && intersection_units[free_unit_]->room() > start.at()) free_unit_ = following(free_unit_);
  return start;
}

[[gnu::flatten]] bool ViewVectorGenerator::fire_before(Cycle horizon) {
  if (books_singly()) return fire_one(horizon);
  return fire_in_a_row(horizon, [this](const Ends& ends) {
    return (rays_left_ > 0 || !ends.pixel_scan.empty()) && rays_left_ != subdivision_rays - 1;
  });
}

Cycle ViewVectorGenerator::fire(Ends& ends, Cycle now) {
  if (reads_request_) {
    request_ = subdivision_controller->read(now).pyramid;
    rays_left_ = subdivision_rays;
    reads_request_ = false;
  }
  if (rays_left_ > 0) {
    issue(subdivision_point(request_, subdivision_rays - rays_left_, max_level_), request_.level + 1, {}, now);
    --rays_left_;
  } else {
    const CornerRequest& corner = ends.pixel_scan.front();
    issue(corner.point, 0, corner.tag, now);
    ends.pixel_scan.pop(now);
  }
  return timing_.interval;
}

glm::dvec3 ViewVectorGenerator::view_vector(GridPoint point) {
  if (count_events_) return counting_events(events_, [&] { return view_vectors_(point); });
  return view_vectors_(point);
}

void ViewVectorGenerator::issue(GridPoint point, std::uint32_t level, const PixelTag& tag, Cycle now) {
  ++rays_by_level_[level];
  if (dispatch_ == Dispatch::first_free) {
    unit_ = free_unit_;
    reorder_buffer->write({static_cast<std::uint32_t>(unit_)}, now, timing_.latency);
  }
  intersection_units[unit_]->write_made(
      [&] {
        return RayMessage{view_vector(point), point, tag, level > 0};
      },
      now, timing_.latency);
  if (++unit_ == intersection_units.size()) unit_ = 0;
}

}  // namespace pyrasim::hw
