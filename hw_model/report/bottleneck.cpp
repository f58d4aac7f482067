// SPDX-License-Identifier: Apache-2.0
#include "hw_model/report/bottleneck.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace pyrasim::hw {

std::vector<Wait> waits(const Processor& processor, const Stage& stage) {
  std::vector<Wait> waits;
  for (const Wire& wire : processor.wires()) {
    const FifoStatistics& fifo = wire.fifo->statistics();
    if (wire.reader == &stage && fifo.starved > 0) waits.push_back({wire.fifo, true, fifo.starved});
    if (wire.writer == &stage && fifo.blocked > 0) waits.push_back({wire.fifo, false, fifo.blocked});
  }
  std::stable_sort(waits.begin(), waits.end(), [](const Wait& a, const Wait& b) { return a.cycles > b.cycles; });
  return waits;
}

namespace {

/// Stages that do the same work side by side.
struct Box {
  Cycle stages = 0;
  Cycle busy = 0;                                       ///< sum over the stages
  std::map<std::pair<std::string, bool>, Cycle> waits;  ///< for another box's tokens (true) or room
};

std::map<std::string, Box> boxes_of(const Processor& processor) {
  std::map<std::string, Box> boxes;
  for (const Stage* stage : processor.stages()) {
    Box& box = boxes[stage->box()];
    ++box.stages;
    box.busy += stage->statistics(processor.cycles()).busy;
  }
  for (const Wire& wire : processor.wires()) {
    const FifoStatistics& fifo = wire.fifo->statistics();
    boxes[wire.reader->box()].waits[{wire.writer->box(), true}] += fifo.starved;
    boxes[wire.writer->box()].waits[{wire.reader->box(), false}] += fifo.blocked;
  }
  return boxes;
}

}  // namespace

std::vector<BottleneckLink> bottleneck_chain(const Processor& processor) {
  const std::map<std::string, Box> boxes = boxes_of(processor);
  const auto share = [&](const Box& box, Cycle cycles) {
    return static_cast<double>(cycles) / (static_cast<double>(box.stages) * static_cast<double>(processor.cycles()));
  };
  double most_busy = 0;
  for (const auto& [name, box] : boxes) most_busy = std::max(most_busy, share(box, box.busy));

  std::vector<BottleneckLink> chain;
  std::string name = processor.tree_accumulator().basename();
  for (bool closed = false; !closed;) {
    closed = std::any_of(chain.begin(), chain.end(), [&](const BottleneckLink& link) { return link.unit == name; });
    const Box& box = boxes.at(name);
    chain.push_back({name, share(box, box.busy)});
    const auto longest = std::max_element(box.waits.begin(), box.waits.end(),
                                          [](const auto& a, const auto& b) { return a.second < b.second; });
    const bool cause = chain.back().busy == most_busy && box.busy >= longest->second;
    if (closed || cause || longest->second == 0) return chain;
    chain.back().waited = share(box, longest->second);
    std::tie(name, chain.back().starved) = longest->first;
  }
  return chain;
}

bool closes_loop(const std::vector<BottleneckLink>& chain) {
  return std::any_of(chain.begin(), chain.end() - 1,
                     [&](const BottleneckLink& link) { return link.unit == chain.back().unit; });
}

std::string cause_text(const std::vector<BottleneckLink>& chain) {
  return fmt::format("{}{}, busy {:.1f} %", closes_loop(chain) ? "the latency of a loop through " : "",
                     chain.back().unit, 100 * chain.back().busy);
}

std::string bottleneck_text(const std::vector<BottleneckLink>& chain) {
  std::string text;
  for (const BottleneckLink& link : chain) {
    text += fmt::format("{} busy {:.1f} %", link.unit, 100 * link.busy);
    if (link.waited > 0)
      text += fmt::format(", {} {:.1f} % <- ", link.starved ? "starved" : "blocked", 100 * link.waited);
  }
  return text;
}

LowerBound lower_bound(const Processor& processor) {
  LowerBound bound{"", 0};
  Cycle most_stages = 0;
  for (const auto& [name, box] : boxes_of(processor)) {
    const Cycle shared = (box.busy + box.stages - 1) / box.stages;
    if (std::tie(shared, box.stages) <= std::tie(bound.cycles, most_stages)) continue;
    bound = {name, shared};
    most_stages = box.stages;
  }
  return bound;
}

}  // namespace pyrasim::hw
