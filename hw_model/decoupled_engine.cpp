// SPDX-License-Identifier: Apache-2.0
#include "hw_model/decoupled_engine.h"

namespace pyrasim::hw {

DecoupledEngine::DecoupledEngine(const std::vector<Stage*>& stages, PixelScan& scan, ViewVectorGenerator& generator,
                                 SubdivisionController* controller, Cycle round_trip, Cycle request_latency)
    : scan_(scan),
      generator_(generator),
      controller_(controller),
      round_trip_(round_trip),
      request_latency_(request_latency) {
  for (Stage* stage : stages) {
    stage->attach(&work_);
    stage->wake();
  }
}

void DecoupledEngine::run() {
  for (;;) {
    work_.run();
    const Start generator = generator_.next();
    const Cycle controller = controller_date();
    if (controller == never && !generator.known()) return;
    if (controller <= generator.at()) {
      controller_->Stage::fire(controller_->next());
    } else {
      run_generator(generator);
    }
  }
}

void DecoupledEngine::run_generator(const Start& first) {
  const Cycle echo = first.at() + round_trip_;
  Cycle horizon = std::min(echo, controller_date()) + request_latency_;
  for (Start start = first; start.known() && start.at() < horizon; start = generator_.next()) {
    generator_.account(start);
    generator_.ViewVectorGenerator::fire(start.at());
    if (generator_.begins_request()) {  // room for the controller's next request
      horizon = std::min(echo, controller_date()) + request_latency_;
    }
    if (generator_.sees_next_corner()) continue;
    scan_.drain();
    if (!generator_.sees_next_corner()) return;
  }
}

}  // namespace pyrasim::hw
