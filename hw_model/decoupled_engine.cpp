// SPDX-License-Identifier: Apache-2.0
#include "hw_model/decoupled_engine.h"

#include <algorithm>
#include <utility>

namespace pyrasim::hw {

DecoupledEngine::DecoupledEngine(std::vector<Stage*> stages, Boxes boxes, const MachineSpec& spec)
    : stages_(std::move(stages)),
      boxes_(std::move(boxes)),
      generator_latency_(spec.view_vector_generator.latency),
      unit_latency_(spec.intersection_cost.ray - 1 + spec.intersection_latency),
      request_latency_(spec.subdivision_controller.latency) {
  for (Stage* stage : stages_) stage->attach(work_);
}

void DecoupledEngine::run(const RunControl& control) {
  constexpr unsigned rounds_to_poll = 64;
  for (Stage* stage : stages_) stage->wake();
  bool at_rest = false;
  for (unsigned round = 1;; ++round) {
    if (round % rounds_to_poll == 0) control.poll();
    settle();
    const Start generator = boxes_.generator.next_start();
    const Cycle controller = controller_date();
    const Cycle first = std::min(generator.at(), controller);
    if (first == never || first > control.last) {
      // Stages that wait until their FIFO is full have to be asked once more.
      if (at_rest) return;
      for (Stage* stage : stages_) stage->wake();
      at_rest = true;
      continue;
    }
    at_rest = false;
    if (controller <= generator.at()) {
      boxes_.controller->fire_at(controller_);
      boxes_.controller->wake();
    } else if (boxes_.generator.chooses_unit()) {
      boxes_.generator.fire_at(generator);
    } else {
      run_generator(first);
    }
  }
}

/// Lets all stages fire that decide from data alone, as far as that can matter to the two that choose.
void DecoupledEngine::settle() {
  work_.run();
  if (boxes_.generator.sees_next_corner()) return;
  boxes_.scan.drain();
  if (boxes_.generator.sees_next_corner()) return;
  boxes_.accumulator.wake();  // the scan may wait for a slot
  work_.run();
  boxes_.scan.drain();
}

/// The controller's next firing changes only with what it is told of, and with its own firings.
Cycle DecoupledEngine::controller_date() {
  if (boxes_.controller != nullptr && boxes_.controller->awake()) {
    boxes_.controller->sleep();
    controller_ = boxes_.controller->next_start();
  }
  return controller_.at();
}

/// The earliest firing of the controller that a ray issued at `first` or a later one can make possible: samples are
/// taken in order, so none before this ray's. The classifier then reads the parent, whose cell is free a cycle later.
Cycle DecoupledEngine::echo(Cycle first) const {
  const Cycle ready = boxes_.units[boxes_.generator.next_unit()]->ready();
  return std::max(first + generator_latency_, ready) + unit_latency_ + 1;
}

void DecoupledEngine::run_generator(Cycle first) {
  const Cycle bound = echo(first);
  while (boxes_.generator.fire_before(std::min(bound, controller_date()) + request_latency_)) {
    if (boxes_.generator.sees_next_corner()) continue;
    boxes_.scan.drain();
    if (!boxes_.generator.sees_next_corner()) return;
  }
}

}  // namespace pyrasim::hw
