// SPDX-License-Identifier: Apache-2.0
#include "hw_model/trace/kanata_trace.h"

#include <fmt/format.h>

#include "hw_model/plan/stage_list.h"
#include "hw_model/wire.h"

namespace pyrasim::hw {

KanataTrace::KanataTrace(Processor& processor, const TraceWindow& window, OutputFile& output)
    : processor_(processor), window_(window), output_(output) {
  const auto& stages = processor.stages();
  for (std::size_t k = 0; k < stages.size(); ++k) {
    names_.emplace_back(stages[k]->basename());
    if (stages[k]->box() == box_of<ViewVectorGenerator>()) generator_ = k;
    if (stages[k]->box() == box_of<PyramidClassifier>()) classifier_ = k;
  }
  for (std::size_t k = 0; k < processor.fifos().size(); ++k) {
    const Wire& wire = processor.wires()[k];
    names_.emplace_back(processor.fifos()[k]->basename());
    const bool of_unit_numbers = wire.writer == stages[generator_] && wire.reader == stages[classifier_];
    readers_.push_back(of_unit_numbers ? nowhere : processor.number_of(*wire.reader));
  }
  for (const std::string& name : names_) shown_.push_back(window.shows(name));
  output_.write("Kanata\t0004\n");
  processor.attach(*this);
}

void KanataTrace::take(const Event& event) {
  write_before(event.at);
  window_.end_if_full(output_.size(), event.at);
  if (event.subject.ray == no_number) return;
  if (event.kind == Event::Kind::firing) {
    take_firing(event);
  } else if (readers_[event.source] == nowhere) {
    return;
  } else if (event.kind == Event::Kind::write) {
    go(event.subject.ray, event.until, processor_.stages().size() + event.source);
  } else {
    go(event.subject.ray, event.at, readers_[event.source]);
  }
}

/// A row begins where the generator fires, and ends with the firing of the classifier that takes its sample.
void KanataTrace::take_firing(const Event& event) {
  if (event.source == classifier_) go(event.subject.ray, event.until, nowhere);
  if (event.source != generator_ || event.at < window_.from || event.at >= window_.to) return;
  const std::uint64_t row = rows_begun_++;
  write_date(event.at);
  output_.write(
      fmt::format("I\t{0}\t{1}\t0\nL\t{0}\t0\tray {1}{2}\n", row, event.subject.ray,
                  event.subject.request == no_number ? "" : fmt::format(" of request {}", event.subject.request)));
  rows_.emplace(event.subject.ray, Row{row, nowhere});
  write({event.at, 0, event.subject.ray, generator_});
}

void KanataTrace::go(std::uint64_t ray, Cycle at, std::size_t place) {
  if (rows_.contains(ray)) agenda_.push({at, order_++, ray, place});
}

void KanataTrace::write_before(Cycle date) {
  for (; !agenda_.empty() && agenda_.top().at < date; agenda_.pop()) write(agenda_.top());
}

void KanataTrace::write(const Item& item) {
  const auto found = rows_.find(item.ray);
  if (found == rows_.end()) return;  // the classifier fires more than once for some
  Row& row = found->second;
  write_date(item.at);
  leave(row);
  row.place = item.place;
  if (shows(row.place)) output_.write(fmt::format("S\t{}\t0\t{}\n", row.number, names_[row.place]));
  if (item.place != nowhere) return;
  output_.write(fmt::format("R\t{}\t{}\t0\n", row.number, rows_ended_++));
  rows_.erase(found);
}

void KanataTrace::leave(const Row& row) {
  if (shows(row.place)) output_.write(fmt::format("E\t{}\t0\t{}\n", row.number, names_[row.place]));
}

void KanataTrace::write_date(Cycle at) {
  if (!written_) {
    output_.write(fmt::format("C=\t{}\n", at));
  } else if (*written_ != at) {
    output_.write(fmt::format("C\t{}\n", at - *written_));
  }
  written_ = at;
}

/// Rays that are still under way when a frame is broken off leave where they are.
void KanataTrace::finish(Cycle cycles) {
  write_before(never);
  if (rows_.empty()) return;
  if (cycles > *written_) write_date(cycles);
  for (const auto& [ray, row] : rows_) {
    leave(row);
    output_.write(fmt::format("R\t{}\t{}\t1\n", row.number, rows_ended_++));
  }
  rows_.clear();
}

}  // namespace pyrasim::hw
