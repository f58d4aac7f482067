// SPDX-License-Identifier: Apache-2.0
#include "hw_model/trace/timeline.h"

#include <algorithm>

namespace pyrasim::hw {

Timeline::Timeline(Processor& processor, const TraceWindow& window, TraceWriter& writer, const OutputFile& output)
    : WindowedSink(processor, window), window_(window), writer_(writer), output_(output) {
  for (const Stage* stage : processor.stages()) units_.push_back({window.shows(stage->basename())});
  for (const FifoBase* fifo : processor.fifos())
    fifos_.push_back({window.shows(fifo->basename()), tokens_before(*fifo)});
  processor.attach(*this);
  if (!window.critical_path) return;
  processor.attach(critical_path_.emplace(processor, [this](const PathStretch& stretch) {
    if (stretch_ && stretch_->owed == stretch.owed && stretch_->place == stretch.place) {
      stretch_->end = stretch.end;
      return;
    }
    if (stretch_) show(*stretch_);
    stretch_ = stretch;
  }));
}

void Timeline::show(Span span) {
  span.begin = std::max(span.begin, window_.from);
  span.end = std::min(span.end, window_.to);
  if (span.begin < span.end) writer_.span(span);
}

void Timeline::take_shown(const Event& event) {
  window_.end_if_full(output_.size(), event.at);
  if (event.kind == Event::Kind::firing) {
    Unit& unit = units_[event.source];
    unit.until = event.until;
    if (!unit.shown || !window_.overlaps(event.since, event.until)) return;
    show({event.source, event.waited, event.since, event.at, {}});
    show({event.source, StageState::busy, event.at, event.until, event.subject});
    return;
  }
  Fill& fifo = fifos_[event.source];
  if (!fifo.shown) return;
  lose_before(event.source, event.at);
  if (event.kind == Event::Kind::read) {
    fifo.losses[fifo.losses[0] == never ? 0 : 1] = event.at + 1;
  } else if (fifo.losses[0] == event.at) {  // it gains one and loses one
    fifo.losses = {fifo.losses[1], never};
  } else {
    change(event.source, event.at, fifo.tokens + 1);
  }
}

void Timeline::show(const PathStretch& stretch) {
  const Cycle begin = std::max(stretch.begin, window_.from);
  const Cycle end = std::min(stretch.end, window_.to);
  if (begin < end) writer_.stretch({stretch.owed, stretch.place, begin, end});
}

void Timeline::lose_before(std::size_t fifo, Cycle date) {
  Fill& its = fifos_[fifo];
  while (its.losses[0] < date) {
    change(fifo, its.losses[0], its.tokens - 1);
    its.losses = {its.losses[1], never};
  }
}

/// The window begins with what was so before.
void Timeline::change(std::size_t fifo, Cycle at, std::size_t tokens) {
  Fill& its = fifos_[fifo];
  if (at > window_.from && !its.written) writer_.fill(fifo, window_.from, its.tokens);
  its.written |= at >= window_.from;
  its.tokens = tokens;
  if (at >= window_.from && at < window_.to) writer_.fill(fifo, at, tokens);
}

void Timeline::finish(Cycle cycles) {
  for (std::size_t k = 0; k < units_.size(); ++k) {
    if (units_[k].shown) show({k, StageState::idle, units_[k].until, cycles, {}});
  }
  for (std::size_t k = 0; k < fifos_.size(); ++k) {
    if (!fifos_[k].shown) continue;
    lose_before(k, never);
    if (!fifos_[k].written && window_.from < cycles) writer_.fill(k, window_.from, fifos_[k].tokens);
  }
  if (critical_path_) critical_path_->finish();
  if (stretch_) show(*stretch_);
  writer_.finish(std::min(cycles, window_.to));
}

}  // namespace pyrasim::hw
