// SPDX-License-Identifier: Apache-2.0
#include "hw_model/report/deadlock.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "error.h"

namespace pyrasim::hw {
namespace {

std::string stage_line(Stage& stage) {
  const Start start = stage.next_start();
  std::string what = "has nothing to do";
  if (start.known()) {
    what = fmt::format("fires at {}", start.at());
  } else if (start.cause() != nullptr) {
    what = fmt::format("waits for {} {}", start.cause()->starved ? "a token from" : "room in",
                       start.cause()->fifo.basename());
  }
  return fmt::format("  {}: ready at {}, {}\n", stage.basename(), stage.ready(), what);
}

/// The stage that has to fire before `stage` can; none where it waits for nothing.
Stage* waits_for(const Processor& processor, Stage& stage) {
  const Start start = stage.next_start();
  if (start.known() || start.cause() == nullptr) return nullptr;
  const Wire& wire = processor.wire_of(start.cause()->fifo);
  return start.cause()->starved ? wire.writer : wire.reader;
}

}  // namespace

std::string machine_state(Processor& processor) {
  std::string text;
  for (Stage* stage : processor.stages()) text += stage_line(*stage);
  for (const FifoBase* fifo : processor.fifos()) {
    text += fmt::format("  {}: {} of {}\n", fifo->basename(), fifo->size(), fifo->statistics().depth);
  }
  return text;
}

std::string wait_for_cycle(Processor& processor) {
  for (Stage* first : processor.stages()) {
    std::vector<Stage*> path;
    Stage* stage = first;
    while (stage != nullptr && std::find(path.begin(), path.end(), stage) == path.end()) {
      path.push_back(stage);
      stage = waits_for(processor, *stage);
    }
    if (stage == nullptr) continue;
    std::string text = stage->basename();
    for (auto link = std::find(path.begin(), path.end(), stage) + 1; link != path.end(); ++link) {
      text += fmt::format(" -> {}", (*link)->basename());
    }
    return text + " -> " + stage->basename();
  }
  return "";
}

void require_finished(Processor& processor) {
  const Cycle limit = processor.max_cycles();
  if (processor.complete() && processor.cycles() <= limit) return;
  std::string reason = fmt::format("the frame is not finished within {} cycles", limit);
  if (!processor.complete() && processor.at_rest()) {
    reason = "deadlock: no stage can go on";
    if (const std::string cycle = wait_for_cycle(processor); !cycle.empty()) reason += "; in a circle: " + cycle;
  }
  throw LimitError(reason + "\n" + machine_state(processor));
}

}  // namespace pyrasim::hw
