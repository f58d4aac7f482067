// SPDX-License-Identifier: Apache-2.0
#include "hw_model/trace/subjects.h"

#include <algorithm>

#include "hw_model/plan/is_one_of.h"
#include "hw_model/wire.h"

namespace pyrasim::hw {

Subjects::Subjects(const std::vector<Stage*>& stages, const std::vector<Wire>& wires, const PixelWindow& window,
                   int max_level)
    : at_stage_(stages.size()), window_(window), max_level_(max_level) {
  const auto place = [&](const Stage* stage) {
    return static_cast<std::size_t>(std::find(stages.begin(), stages.end(), stage) - stages.begin());
  };
  for (const Stage* stage : stages) originates_.push_back(is_one_of<PixelScan, SubdivisionController>(*stage));
  for (const Wire& wire : wires) {
    Fifo& fifo = fifos_.emplace_back();
    fifo.writer = place(wire.writer);
    fifo.reader = place(wire.reader);
    if (is_one_of<ViewVectorGenerator>(*wire.reader)) generator_ = fifo.reader;
    if (is_one_of<PixelScan>(*wire.writer)) {
      fifo.content = Content::corners;
    } else if (is_one_of<SubdivisionController>(*wire.writer)) {
      fifo.content = is_one_of<PyramidClassifier>(*wire.reader) ? Content::parents : Content::requests;
    } else if (is_one_of<PyramidClassifier, ColorUnit>(*wire.writer) || is_one_of<FrameBuffer>(*wire.reader)) {
      fifo.content = Content::nodes;
    } else if (!is_one_of<PixelScan>(*wire.reader)) {
      fifo.content = Content::rays;
    }
  }
}

void Subjects::tell(Event& event, std::span<const Event> following) {
  if (fifos_.empty()) return;
  switch (event.kind) {
    case Event::Kind::read:
      event.subject = read(fifos_[event.source]);
      break;
    case Event::Kind::firing:
      event.subject = fired(event, following);
      break;
    case Event::Kind::write:
      event.subject = written(fifos_[event.source], event.subject);
      break;
  }
}

Subject Subjects::fired(const Event& event, std::span<const Event> following) {
  Subject& its = at_stage_[event.source];
  if (event.source == generator_) its = issued();
  if (originates_[event.source]) {
    for (const Event& other : following) {
      if (other.at != event.at) break;
      if (other.kind != Event::Kind::write || fifos_[other.source].writer != event.source) continue;
      its = other.subject;
      if (its.is_node()) its = node(its, fifos_[other.source].writes);
      break;
    }
  }
  return its;
}

/// By the generator, which has read its request or corner by now.
Subject Subjects::issued() {
  if (of_request_ == 0) {
    corner_.ray = rays_++;
    return corner_;
  }
  const std::size_t point = subdivision_rays - of_request_--;
  return {.ray = rays_++,
          .request = request_.request,
          .point = subdivision_point({request_.point, request_.log2_side}, point),
          .pixel = request_.pixel};
}

/// On the cell that a message said.
Subject Subjects::node(const Subject& said, std::uint64_t request) const {
  Subject node = said;
  node.request = request;
  const std::uint32_t row = (said.point.row >> max_level_) - static_cast<std::uint32_t>(window_.row);
  const std::uint32_t column = (said.point.column >> max_level_) - static_cast<std::uint32_t>(window_.column);
  node.pixel = row * static_cast<std::uint32_t>(window_.columns) + column;
  return node;
}

Subject Subjects::written(Fifo& fifo, const Subject& said) const {
  Subject subject = at_stage_[fifo.writer];
  switch (fifo.content) {
    case Content::slots:
      return {};
    case Content::corners:
      subject = said;
      break;
    case Content::requests:
    case Content::parents:
      subject = node(said, fifo.writes++);
      break;
    case Content::nodes:
      if (said.is_node()) {
        const std::uint64_t completing = subject.ray;
        subject = node(said, subject.request);
        subject.ray = completing;
      }
      break;
    case Content::rays:
      subject.object = said.object;
      break;
  }
  fifo.inside.push_back(subject);
  return subject;
}

Subject Subjects::read(Fifo& fifo) {
  if (fifo.content == Content::slots) return {};
  const Subject subject = fifo.inside.front();
  fifo.inside.pop_front();
  switch (fifo.content) {
    case Content::corners:
      corner_ = subject;
      break;
    case Content::requests:
      request_ = subject;
      of_request_ = subdivision_rays;
      break;
    case Content::rays:
    case Content::nodes:
      at_stage_[fifo.reader] = subject;
      break;
    case Content::parents:
    case Content::slots:
      break;
  }
  return subject;
}

}  // namespace pyrasim::hw
