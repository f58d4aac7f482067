// SPDX-License-Identifier: Apache-2.0
#include "hw_model/report/critical_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <utility>

namespace pyrasim::hw {

CriticalPath::CriticalPath(const Processor& processor, Settled settled)
    : settled_(std::move(settled)), units_(processor.stages().size()) {
  for (const Wire& wire : processor.wires()) {
    const std::size_t tokens = wire.fifo->size();
    fifos_.push_back({processor.number_of(*wire.writer),
                      processor.number_of(*wire.reader),
                      wire.fifo->depth() - tokens,
                      std::deque<Number>(tokens, none),
                      {}});
  }
  for (auto& cycles : cycles_) cycles.resize(std::max(units_.size(), fifos_.size()));
}

void CriticalPath::take(const Event& event) {
  expire_before(event.at);
  if (event.kind == Event::Kind::firing) {
    const Number number = add(event);
    auto& [last, read] = units_[event.source];
    last = number;
    for (const std::size_t fifo : read) fifos_[fifo].cells.push_back(number);
    read.clear();
    return;
  }
  Fifo& fifo = fifos_[event.source];
  if (event.kind == Event::Kind::read) {
    fifo.newest = fifo.tokens.front();
    fifo.tokens.pop_front();
    units_[fifo.reader].read.push_back(event.source);
    return;
  }
  const Number writer = units_[fifo.writer].last;
  firings_[writer].term = std::max(firings_[writer].term, event.until);
  fifo.tokens.push_back(writer);
  if (fifo.unused > 0) {
    --fifo.unused;
  } else {
    fifo.cells.pop_front();
  }
}

/// What it has read is known by now; the cell that it writes is the one that has been free for longest.
CriticalPath::Number CriticalPath::cause_of(const Event& firing) const {
  if (firing.cause == no_fifo) return units_[firing.source].last;
  const Fifo& fifo = fifos_[firing.cause];
  return fifo.reader == firing.source ? fifo.newest : fifo.cells.front();
}

CriticalPath::Number CriticalPath::add(const Event& firing) {
  const Number cause = cause_of(firing);
  auto number = static_cast<Number>(firings_.size());
  if (unused_.empty()) {
    firings_.emplace_back();
  } else {
    number = unused_.back();
    unused_.pop_back();
  }
  firings_[number] = {.at = firing.at,
                      .until = firing.until,
                      .term = firing.until,
                      .stage = firing.source,
                      .fifo = firing.cause,
                      .starved = firing.cause != no_fifo && fifos_[firing.cause].reader == firing.source,
                      .cause = cause};
  terms_.push({firing.until, number});
  if (cause == none) {
    assert(root_ == none && firing.at == 0);
    root_ = number;
  } else {
    ++firings_[cause].effects;
    firings_[cause].sum_of_effects += number;
  }
  return number;
}

void CriticalPath::expire_before(Cycle date) {
  if (terms_.empty() || terms_.top().date >= date) return;
  while (!terms_.empty() && terms_.top().date < date) {
    const Number number = terms_.top().firing;
    terms_.pop();
    Firing& firing = firings_[number];
    if (firing.term >= date) {
      terms_.push({firing.term, number});
    } else {
      firing.waited_for = false;
      drop(number);
    }
  }
  settle_common();
}

/// Whom nobody waits for, or came from, is on no path; then the same may hold for its cause.
void CriticalPath::drop(Number firing) {
  while (firing != root_ && !firings_[firing].waited_for && firings_[firing].effects == 0) {
    const Number cause = firings_[firing].cause;
    --firings_[cause].effects;
    firings_[cause].sum_of_effects -= firing;
    unused_.push_back(firing);
    firing = cause;
  }
}

void CriticalPath::settle_common() {
  while (!firings_[root_].waited_for && firings_[root_].effects == 1) {
    const Number next = firings_[root_].sum_of_effects;
    settle(firings_[root_], firings_[next]);
    unused_.push_back(root_);
    root_ = next;
  }
}

void CriticalPath::settle(const Firing& cause, const Firing& effect) {
  if (effect.fifo == no_fifo) {
    settle(Owed::occupied, cause.stage, cause.at, effect.at);
  } else if (!effect.starved) {
    settle(Owed::room, effect.fifo, cause.at, effect.at);
  } else {
    const Cycle served = std::min(cause.until, effect.at);
    settle(Owed::service, cause.stage, cause.at, served);
    settle(Owed::latency, cause.stage, served, effect.at);
  }
}

void CriticalPath::settle(Owed owed, std::size_t place, Cycle begin, Cycle end) {
  if (begin == end) return;
  cycles_[static_cast<std::size_t>(owed)][place] += end - begin;
  if (settled_) settled_({owed, place, begin, end});
}

void CriticalPath::finish() {
  if (root_ == none) return;
  Number last = none;
  for (; !terms_.empty(); terms_.pop()) {
    const Number firing = terms_.top().firing;
    if (last == none || firings_[firing].until > firings_[last].until) last = firing;
  }
  std::vector<Number> rest;
  for (Number firing = last; firing != root_; firing = firings_[firing].cause) rest.push_back(firing);
  for (; !rest.empty(); rest.pop_back()) settle(firings_[firings_[rest.back()].cause], firings_[rest.back()]);
  settle(Owed::service, firings_[last].stage, firings_[last].at, firings_[last].until);
}

std::vector<PathShare> CriticalPath::shares() const {
  std::vector<PathShare> shares;
  for (std::size_t owed = 0; owed < cycles_.size(); ++owed) {
    for (std::size_t place = 0; place < cycles_[owed].size(); ++place) {
      if (cycles_[owed][place] > 0) shares.push_back({static_cast<Owed>(owed), place, cycles_[owed][place]});
    }
  }
  std::stable_sort(shares.begin(), shares.end(), [](const auto& a, const auto& b) { return a.cycles > b.cycles; });
  return shares;
}

std::string place_name(const Processor& processor, Owed owed, std::size_t place) {
  return owed == Owed::room ? processor.fifos()[place]->basename() : processor.stages()[place]->basename();
}

std::string owed_text(std::string_view owed, std::string_view place) {
  if (owed == owed_names[static_cast<std::size_t>(Owed::occupied)]) return fmt::format("{} {}", place, owed);
  const bool room = owed == owed_names[static_cast<std::size_t>(Owed::room)];
  return fmt::format("{} {} {}", owed, room ? "in" : "of", place);
}

std::string text_of(const Processor& processor, const PathStretch& stretch) {
  return owed_text(owed_names[static_cast<std::size_t>(stretch.owed)],
                   place_name(processor, stretch.owed, stretch.place));
}

}  // namespace pyrasim::hw
