// SPDX-License-Identifier: Apache-2.0
#include "hw_model/view_vector_generator.h"

namespace pyrasim::hw {

ViewVectorGenerator::ViewVectorGenerator(const sc_core::sc_module_name& name, StageTiming timing, std::size_t units,
                                         const Datapath& datapath, int max_level)
    : StageOf(name),
      intersection_units("intersection_unit", units),
      timing_(timing),
      datapath_(datapath),
      max_level_(max_level) {}

Start ViewVectorGenerator::corner_start() const {
  return Start(ready()).needs_token(pixel_scan).needs_room(intersection_units[unit_]);
}

Start ViewVectorGenerator::request_start() const {
  if (subdivision_controller.size() == 0) return Start(never);
  return Start(ready()).needs_token(subdivision_controller).needs_room(intersection_units[unit_]);
}

Start ViewVectorGenerator::next() {
  if (rays_left_ > 0) return Start(ready()).needs_room(intersection_units[unit_]);
  const Start request = request_start();
  const Start corner = corner_start();
  return request.known() && request.at() <= corner.at() ? request : corner;
}

void ViewVectorGenerator::fire(Cycle now) {
  if (rays_left_ == 0 && request_start().at() == now) {
    request_ = subdivision_controller->read(now).pyramid;
    rays_left_ = subdivision_rays;
  }
  if (rays_left_ > 0) {
    issue(subdivision_point(request_, subdivision_rays - rays_left_, max_level_), request_.level + 1, {}, now);
    --rays_left_;
  } else {
    const CornerRequest corner = pixel_scan->read(now);
    issue(corner.point, 0, corner.tag, now);
  }
  occupy(now, timing_.interval);
}

void ViewVectorGenerator::issue(GridPoint point, std::uint32_t level, const PixelTag& tag, Cycle now) {
  ++rays_by_level_[level];
  intersection_units[unit_]->write({datapath_.view_vector(point), tag, level > 0}, now, timing_.latency);
  unit_ = unit_ + 1 == intersection_units.size() ? 0 : unit_ + 1;
}

}  // namespace pyrasim::hw
