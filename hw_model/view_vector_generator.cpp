// SPDX-License-Identifier: Apache-2.0
#include "hw_model/view_vector_generator.h"

namespace pyrasim::hw {

ViewVectorGenerator::ViewVectorGenerator(const sc_core::sc_module_name& name, const FrameSetup& frame)
    : StageOf(name),
      intersection_units("intersection_unit", frame.spec.intersection_units),
      timing_(frame.spec.view_vector_generator),
      dispatch_(intersection_units.size() == 1 ? Dispatch::round_robin : frame.spec.dispatch),
      view_vectors_(frame.view_vectors),
      count_events_(frame.options.formats.counts_events()),
      max_level_(frame.options.max_level) {}

ViewVectorGenerator::Plan ViewVectorGenerator::next(const Ends& ends, Cycle ready) const {
  Start start(ready);
  const bool reads_request = rays_left_ == 0 && request_goes_first(ends, ready);
  if (reads_request) {
    start.needs_token(*subdivision_controller);
  } else if (rays_left_ == 0) {
    start.needs_token(ends.pixel_scan);
  }
  start = with_room(start);
  return {start, reads_request, chooses_unit() && start.known() ? free_unit(start.at()) : unit_};
}

/// A request goes first that is there no later than the corner, or than anything at all could be issued.
bool ViewVectorGenerator::request_goes_first(const Ends& ends, Cycle ready) const {
  if (!subdivision_controller.bound() || subdivision_controller->empty()) return false;
  const Cycle request = subdivision_controller->token_at();
  return request <= ends.pixel_scan.token_at() || request <= with_room(Start(ready)).at();
}

/// `start`, once there is room for the ray.
Start ViewVectorGenerator::with_room(Start start) const {
  if (!chooses_unit()) return start.needs_room(intersection_units[unit_]);
  return start.needs_room(intersection_units[earliest_unit()]).needs_room(*issue_order_queue);
}

/// The unit that has room first.
std::size_t ViewVectorGenerator::earliest_unit() const {
  std::size_t earliest = unit_;
  for (std::size_t unit = following(unit_); unit != unit_; unit = following(unit)) {
    if (intersection_units[unit].room_at() < intersection_units[earliest].room_at()) earliest = unit;
  }
  return earliest;
}

/// The first unit, counting on from unit_, of those that have room at `now`; one has to.
std::size_t ViewVectorGenerator::free_unit(Cycle now) const {
  std::size_t unit = unit_;
  while (intersection_units[unit].room_at() > now) unit = following(unit);
  return unit;
}

[[gnu::flatten]] bool ViewVectorGenerator::fire_before(Cycle horizon) {
  if (books_singly()) return fire_one(horizon);
  return fire_in_a_row(
      horizon, [this](const Ends& ends) { return (rays_left_ > 0 || !ends.pixel_scan.empty()) && !ends.made_room; });
}

Cycle ViewVectorGenerator::fire(Ends& ends, const Plan& plan) {
  if (plan.reads_request) {
    ends.made_room = subdivision_controller->full();
    request_ = subdivision_controller->read(plan.start.at()).cell;
    rays_left_ = subdivision_rays;
  }
  if (rays_left_ > 0) {
    issue(subdivision_point(request_, subdivision_rays - rays_left_), level_of(request_.log2_side - 1, max_level_), {},
          plan);
    --rays_left_;
  } else {
    const CornerRequest& corner = ends.pixel_scan.front();
    issue(corner.point, 0, corner.tag, plan);
    ends.pixel_scan.pop(plan.start.at());
  }
  return timing_.interval;
}

glm::dvec3 ViewVectorGenerator::view_vector(GridPoint point) {
  if (count_events_) return counting_events(events_, [&] { return view_vectors_(point); });
  return view_vectors_(point);
}

void ViewVectorGenerator::issue(GridPoint point, std::uint32_t level, const PixelTag& tag, const Plan& plan) {
  const Cycle now = plan.start.at();
  ++rays_by_level_[level];
  intersection_units[plan.unit].write_made(
      [&] {
        return RayMessage{view_vector(point), point, tag, level > 0};
      },
      now, timing_.latency);
  if (chooses_unit()) issue_order_queue->write({static_cast<std::uint32_t>(plan.unit)}, now, timing_.latency);
  unit_ = following(plan.unit);
}

}  // namespace pyrasim::hw
