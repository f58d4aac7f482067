// SPDX-License-Identifier: Apache-2.0
#include "hw_model/report/pixel_history.h"

#include <algorithm>
#include <tuple>

#include "hw_model/plan/is_one_of.h"
#include "hw_model/wire.h"

namespace pyrasim::hw {

PixelHistory::PixelHistory(const Processor& processor, std::uint32_t pixel)
    : processor_(processor),
      pixel_(pixel),
      served_(processor.stages().size()),
      unread_(processor.fifos().size()),
      frame_buffer_(processor.number_of(processor.frame_buffer())) {
  const auto [row, column] = processor.place_of(pixel);
  cell_ = pixel_cell({}, static_cast<std::uint32_t>(row), static_cast<std::uint32_t>(column), processor.max_level());
  for (const Wire& wire : processor.wires()) {
    writers_.push_back(processor.number_of(*wire.writer));
    readers_.push_back(processor.number_of(*wire.reader));
  }
}

bool PixelHistory::is_about(const Subject& subject) const {
  if (subject.pixel == pixel_) return true;
  if (subject.is_node() || subject.ray == no_number || subject.request != no_number) return false;
  for (std::size_t corner = 0; corner < 4; ++corner) {
    if (corner_of(cell_, corner) == subject.point) return true;
  }
  return false;
}

void PixelHistory::take(const Event& event) {
  if (event.kind == Event::Kind::firing) {
    served_[event.source] = event.until;
    if (event.source == frame_buffer_ && event.subject.pixel == pixel_) stored_ = event.until;
    return;
  }
  if (!is_about(event.subject)) return;
  std::deque<std::size_t>& unread = unread_[event.source];
  if (event.kind == Event::Kind::read) {
    hops_[unread.front()].read = event.at;
    unread.pop_front();
    return;
  }
  unread.push_back(hops_.size());
  const Cycle served = std::min(served_[writers_[event.source]], event.until);
  hops_.push_back({event.source, event.subject, event.at, served, event.until});
}

/// The pixel's own token that a firing took.
const Hop* PixelHistory::read_by(std::size_t stage, Cycle at) const {
  const Hop* found = nullptr;
  for (const Hop& hop : hops_) {
    if (hop.read != at || readers_[hop.fifo] != stage || hop.subject.pixel != pixel_) continue;
    // with its first ray the classifier reads a node that has long been split
    if (found == nullptr || !hop.subject.is_node()) found = &hop;
  }
  return found;
}

/// What `stage` had read of which it made `hop` in a later firing.
const Hop* PixelHistory::held_for(const Hop& hop, std::size_t stage) const {
  const Hop* found = nullptr;
  for (const Hop& other : hops_) {
    if (other.read >= hop.written || readers_[other.fifo] != stage || other.subject.pixel != pixel_) continue;
    const bool same_node = other.subject.is_node() == hop.subject.is_node() &&
                           other.subject.point == hop.subject.point && other.subject.log2_side == hop.subject.log2_side;
    const bool of_request = other.subject.request != no_number && other.subject.request == hop.subject.request;
    const bool is_controller = is_one_of<SubdivisionController>(*processor_.stages()[stage]);
    if (is_controller ? !same_node : !of_request) continue;
    // of two that were read together, a ray and the unit that it went to, the one that came last
    if (found == nullptr || std::tie(found->read, found->visible) < std::tie(other.read, other.visible)) found = &other;
  }
  return found;
}

std::vector<LifeStep> PixelHistory::life() const {
  std::vector<LifeStep> steps;  // backwards
  const auto add = [&](LifeStep::Kind kind, std::size_t place, Cycle begin, Cycle end) {
    if (begin < end) steps.push_back({kind, place, begin, end});
  };
  const auto last = std::find_if(hops_.begin(), hops_.end(), [&](const Hop& hop) {
    return readers_[hop.fifo] == frame_buffer_ && hop.read != never;
  });
  if (last == hops_.end()) return steps;
  for (const Hop* hop = &*last; hop != nullptr;) {
    const std::size_t stage = writers_[hop->fifo];
    if (hop != &*last) add(LifeStep::Kind::waiting, hop->fifo, hop->visible, hop->read);
    add(LifeStep::Kind::latency, stage, hop->served, hop->visible);
    add(LifeStep::Kind::service, stage, hop->written, hop->served);
    const Hop* before = read_by(stage, hop->written);
    if (before == nullptr) {
      before = held_for(*hop, stage);
      if (before != nullptr) add(LifeStep::Kind::held, stage, before->read, hop->written);
    }
    hop = before;
  }
  std::reverse(steps.begin(), steps.end());
  return steps;
}

}  // namespace pyrasim::hw
