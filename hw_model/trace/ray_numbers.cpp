// SPDX-License-Identifier: Apache-2.0
#include "hw_model/trace/ray_numbers.h"

#include <algorithm>

#include "hw_model/plan/stage_list.h"
#include "hw_model/wire.h"

namespace pyrasim::hw {
namespace {

template <class Kind>
bool is(const Stage* stage) {
  return stage->box() == box_of<Kind>();
}

}  // namespace

RayNumbers::RayNumbers(const std::vector<Stage*>& stages, const std::vector<Wire>& wires) : at_stage_(stages.size()) {
  const auto place = [&](const Stage* stage) {
    return static_cast<std::size_t>(std::find(stages.begin(), stages.end(), stage) - stages.begin());
  };
  for (const Wire& wire : wires) {
    Fifo& fifo = fifos_.emplace_back();
    fifo.writer = place(wire.writer);
    fifo.reader = place(wire.reader);
    if (is<ViewVectorGenerator>(wire.writer)) generator_ = fifo.writer;
    if (is<ViewVectorGenerator>(wire.writer) || is<IntersectionUnit>(wire.writer) || is<ShadowUnit>(wire.writer)) {
      fifo.content = Content::rays;
    }
    if (is<SubdivisionController>(wire.writer)) fifo.content = Content::requests;
  }
}

void RayNumbers::number(Event& event) {
  if (fifos_.empty()) return;
  Ray ray;
  if (event.kind == Event::Kind::firing) {
    if (event.source == generator_) at_stage_[generator_] = issued();
    ray = at_stage_[event.source];
  } else {
    Fifo& fifo = fifos_[event.source];
    if (fifo.content == Content::other) return;
    ray = event.kind == Event::Kind::write ? written(fifo) : read(fifo);
  }
  event.ray = ray.ray;
  event.parent = ray.parent;
}

/// By the generator, which has read its request by now.
RayNumbers::Ray RayNumbers::issued() {
  if (of_request_ == 0) return {rays_++, no_number};
  --of_request_;
  return {rays_++, request_};
}

RayNumbers::Ray RayNumbers::written(Fifo& fifo) const {
  fifo.inside.push_back(fifo.content == Content::rays ? at_stage_[fifo.writer] : Ray{no_number, fifo.writes++});
  return fifo.inside.back();
}

RayNumbers::Ray RayNumbers::read(Fifo& fifo) {
  const Ray ray = fifo.inside.front();
  fifo.inside.pop_front();
  if (fifo.content == Content::rays) {
    at_stage_[fifo.reader] = ray;
  } else if (fifo.reader == generator_) {
    request_ = ray.parent;
    of_request_ = subdivision_rays;
  }
  return ray;
}

}  // namespace pyrasim::hw
