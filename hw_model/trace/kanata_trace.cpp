// SPDX-License-Identifier: Apache-2.0
#include "hw_model/trace/kanata_trace.h"

#include <fmt/format.h>

#include "hw_model/plan/is_one_of.h"
#include "hw_model/wire.h"

namespace pyrasim::hw {

KanataTrace::KanataTrace(Processor& processor, const TraceWindow& window, OutputFile& output)
    : WindowedSink(processor, window), processor_(processor), window_(window), output_(output) {
  const auto& stages = processor.stages();
  for (std::size_t k = 0; k < stages.size(); ++k) {
    names_.emplace_back(stages[k]->basename());
    if (is_one_of<ViewVectorGenerator>(*stages[k])) generator_ = k;
    if (is_one_of<PyramidClassifier>(*stages[k])) classifier_ = k;
    if (is_one_of<SubdivisionController>(*stages[k])) controller_ = k;
    if (is_one_of<FrameBuffer>(*stages[k])) frame_buffer_ = k;
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

void KanataTrace::take_shown(const Event& event) {
  write_before(event.at);
  window_.end_if_full(output_.size(), event.at);
  if (event.kind == Event::Kind::firing) {
    take_firing(event);
  } else if (event.subject.is_node()) {
    if (event.kind == Event::Kind::write) take_node(event);
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
  if (event.source == frame_buffer_) completed_.erase(event.subject.pixel);
  if (event.source == classifier_) go(event.subject.ray, event.until, nowhere);
  if (event.source == generator_ && event.at >= window_.from && event.at < window_.to)
    begin_row(event.subject, event.at);
}

/// On its way from the classifier to the controller, or from there as a request.
void KanataTrace::take_node(const Event& event) {
  const Subject& node = event.subject;
  if (readers_[event.source] == controller_) {
    const auto row = rows_.find(node.ray);
    if (row != rows_.end()) completed_[node.pixel].push_back({node.point, node.log2_side, row->second.number});
  } else if (readers_[event.source] == generator_) {
    const auto completed = completed_.find(node.pixel);
    if (completed == completed_.end()) return;
    for (Completed& its : completed->second) {
      if (its.corner == node.point && its.log2_side == node.log2_side) its.request = node.request;
    }
  }
}

void KanataTrace::begin_row(const Subject& ray, Cycle at) {
  const std::uint64_t row = rows_begun_++;
  write_date(at);
  const std::string of = ray.request == no_number ? "" : fmt::format(" of request {}", ray.request);
  output_.write(fmt::format("I\t{0}\t{1}\t0\nL\t{0}\t0\tray {1}{2}\n", row, ray.ray, of));
  rows_.emplace(ray.ray, Row{row, nowhere});
  write({at, 0, ray.ray, generator_});
  const auto completed = completed_.find(ray.pixel);
  if (ray.request == no_number || completed == completed_.end()) return;
  for (const Completed& node : completed->second) {
    if (node.request == ray.request) output_.write(fmt::format("W\t{}\t{}\t0\n", row, node.row));
  }
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
  if (shows(row.place)) output_.write(fmt::format("S\t{}\t{}\t{}\n", row.number, lane(row.place), names_[row.place]));
  if (item.place != nowhere) return;
  output_.write(fmt::format("R\t{}\t{}\t0\n", row.number, rows_ended_++));
  rows_.erase(found);
}

void KanataTrace::leave(const Row& row) {
  if (shows(row.place)) output_.write(fmt::format("E\t{}\t{}\t{}\n", row.number, lane(row.place), names_[row.place]));
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
