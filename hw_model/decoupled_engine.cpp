// SPDX-License-Identifier: Apache-2.0
#include "hw_model/decoupled_engine.h"

#include <algorithm>
#include <utility>

namespace pyrasim::hw {

DecoupledEngine::DecoupledEngine(std::vector<Stage*> stages, const std::vector<Wire>& wires, Boxes boxes,
                                 const MachineSpec& spec)
    : stages_(std::move(stages)),
      boxes_(std::move(boxes)),
      generator_latency_(spec.view_vector_generator.latency),
      unit_latency_(spec.intersection_cost.ray - 1 + spec.intersection_latency +
                    (boxes_.has_shadow_units ? spec.shadow_unit.latency : 0)),
      request_latency_(spec.subdivision_controller.latency) {
  for (Stage* stage : stages_) stage->attach(work_);
  for (const Wire& wire : wires) {  // only room and free slots come back from these
    if (wire.reader == &boxes_.color_unit || wire.reader == &boxes_.frame_buffer) wire.fifo->wake_reader_when_full();
  }
}

void DecoupledEngine::run(const RunControl& control, EventStream& events) {
  constexpr unsigned rounds_to_poll = 64;
  for (Stage* stage : stages_) stage->wake();
  bool at_rest = false;
  for (unsigned round = 1;; ++round) {
    if (round % rounds_to_poll == 0) control.poll();
    settle();
    if (events.due()) events.release(watermark());
    const auto generator = boxes_.generator.plan();
    const Cycle controller = controller_date();
    const Cycle first = std::min(generator.start.at(), controller);
    if (first == never || first > control.last) {
      // Stages that wait until their FIFO is full have to be asked once more.
      if (at_rest) break;
      for (Stage* stage : stages_) stage->wake();
      at_rest = true;
      continue;
    }
    at_rest = false;
    if (controller <= generator.start.at()) {
      run_controller(controller);
    } else if (boxes_.generator.chooses_unit()) {
      boxes_.generator.fire_planned(generator);
    } else {
      run_generator(first);
    }
  }
  events.release(never);
}

/// Lets all stages fire that decide from data alone, as far as that can matter to the two that choose.
void DecoupledEngine::settle() {
  work_.run();
  if (boxes_.generator.sees_next_corner()) return;
  boxes_.scan.drain();
  if (boxes_.generator.sees_next_corner()) return;
  boxes_.color_unit.wake();  // the scan may wait for a slot
  work_.run();
  boxes_.scan.drain();
}

/// Nothing will happen before it any more. The first of all firings that are still to come has what it needs already,
/// or another would have to come before it and bring that; so its stage knows its date. Those who wait until their FIFO
/// is full fire first, so as not to hold up the others' events.
Cycle DecoupledEngine::watermark() {
  for (Stage* stage : stages_) stage->wake();
  work_.run();
  Cycle first = never;
  for (const Stage* stage : stages_) first = std::min(first, stage->next_start().at());
  return first;
}

/// The controller's next firing changes only with what it is told of, and with its own firings.
Cycle DecoupledEngine::controller_date() {
  if (boxes_.controller != nullptr && boxes_.controller->awake()) {
    boxes_.controller->sleep();
    controller_date_ = boxes_.controller->next_start().at();
  }
  return controller_date_;
}

/// The earliest firing of the controller that a ray issued at `first` or a later one can make possible: samples are
/// taken in order, so none before this ray's. The classifier then reads the parent, whose cell is free a cycle later.
Cycle DecoupledEngine::lookahead(Cycle first) const {
  const Cycle ready = boxes_.units[boxes_.generator.next_unit()]->ready();
  return std::max(first + generator_latency_, ready) + unit_latency_ + 1;
}

/// What comes of a firing at `first` can be read two cycles later at the earliest: every hop takes one, and the way
/// back to the controller is two. Sooner, a cycle later, there can only be room for a request; and by then a node that
/// is there is accepted first.
void DecoupledEngine::run_controller(Cycle first) {
  boxes_.controller->fire_before(first + 2);
  boxes_.controller->wake();
}

void DecoupledEngine::run_generator(Cycle first) {
  const Cycle bound = lookahead(first);
  while (boxes_.generator.fire_before(std::min(bound, controller_date()) + request_latency_)) {
    if (boxes_.generator.sees_next_corner()) continue;
    boxes_.scan.drain();
    if (!boxes_.generator.sees_next_corner()) return;
  }
}

}  // namespace pyrasim::hw
