// SPDX-License-Identifier: Apache-2.0
#include "hw_model/report/deadlock.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "error.h"
#include "text/counted.h"

namespace pyrasim::hw {
namespace {

/// What `stage` waits for outside of itself.
std::string waits_line(const Start& start) {
  if (start.cause() == nullptr) return "has nothing to do";
  return fmt::format("waits for {} {}", start.cause()->starved ? "a token from" : "room in",
                     start.cause()->fifo.basename());
}

/// A node waits in the controller, and the banker's rule lets none go.
bool lacks_room(const SubdivisionController& controller) {
  return controller.pool_kept() + controller.pool_needed() > controller.pool_depth();
}

std::string stage_line(const Processor& processor, Stage& stage) {
  const Start start = stage.next_start();
  const SubdivisionController* controller = processor.controller();
  std::string what = waits_line(start);
  if (start.known()) {
    what = fmt::format("fires at {}", start.at());
  } else if (&stage == controller && lacks_room(*controller)) {
    what = fmt::format("has no room in its pool: {} of {} entries kept, {} more needed", controller->pool_kept(),
                       controller->pool_depth(), controller->pool_needed());
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
  for (Stage* stage : processor.stages()) text += stage_line(processor, *stage);
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

std::string why_unfinished(Processor& processor) {
  const Cycle limit = processor.max_cycles();
  if (processor.complete() && processor.cycles() <= limit) return "";
  std::string reason = fmt::format("the frame is not finished within {}", counted(limit, "cycle"));
  if (!processor.complete() && processor.at_rest()) {
    reason = "deadlock: no stage can go on";
    if (const std::string cycle = wait_for_cycle(processor); !cycle.empty()) reason += "; in a circle: " + cycle;
  }
  return reason + "\n" + machine_state(processor);
}

void require_finished(Processor& processor) {
  if (const std::string why = why_unfinished(processor); !why.empty()) throw LimitError(why);
}

}  // namespace pyrasim::hw
