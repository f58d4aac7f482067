// SPDX-License-Identifier: Apache-2.0
#include "hw_model/view/frame_tables.h"

#include <array>
#include <nlohmann/json.hpp>
#include <string_view>

#include "hw_model/plan/is_one_of.h"

namespace pyrasim::hw {
namespace {

using nlohmann::ordered_json;

constexpr std::array<std::string_view, 4> content_names{"nothing", "corners", "rays", "nodes"};

/// Numbers that count from 1, where 0 is none.
std::uint64_t from_one(std::uint64_t number) { return number == no_number ? 0 : number + 1; }

}  // namespace

FrameTables::FrameTables(Processor& processor) : processor_(processor) {
  for (const Stage* stage : processor.stages()) {
    if (is_one_of<ViewVectorGenerator>(*stage)) generator_ = units_.size();
    const bool nodes = is_one_of<SubdivisionController, ColorUnit, TreeAccumulator, FrameBuffer>(*stage);
    units_.push_back({nodes ? Content::nodes : is_one_of<PixelScan>(*stage) ? Content::corners : Content::rays});
  }
  for (const auto& [fifo, writer, reader] : processor.wires()) {
    Content content = Content::rays;
    if (is_one_of<PixelScan>(*writer)) {
      content = Content::corners;
    } else if (is_one_of<PixelScan>(*reader)) {
      content = Content::nothing;
    } else if (is_one_of<PyramidClassifier, SubdivisionController, ColorUnit, TreeAccumulator>(*writer)) {
      content = Content::nodes;
    }
    fifos_.push_back({content, fifo->size()});
    fifos_.back().visible.resize(fifo->size());
  }
  processor.attach(*this);
}

void FrameTables::take(const Event& event) {
  switch (event.kind) {
    case Event::Kind::read: {
      Fifo& fifo = fifos_[event.source];
      fifo.stay.add(event.at - fifo.visible.front());
      fifo.visible.pop_front();
      ++fifo.read;
      break;
    }
    case Event::Kind::firing:
      take_firing(event);
      break;
    case Event::Kind::write:
      take_write(event);
      break;
  }
}

void FrameTables::take_firing(const Event& event) {
  if (event.source == generator_) add_ray(event.subject);
  Unit& unit = units_[event.source];
  unit.wait.add(event.at - event.since);
  unit.busy.add(event.until - event.at);
  unit.cause.add(event.at == event.since || event.cause == no_fifo ? 0 : event.cause + 1);
  unit.subject.add_difference(number_of(unit.content, event.subject, unit.firings));
  ++unit.firings;
}

void FrameTables::take_write(const Event& event) {
  Fifo& fifo = fifos_[event.source];
  fifo.at.add_difference(event.at);
  fifo.latency.add(event.until - event.at);
  fifo.visible.push_back(event.until);
  fifo.subject.add_difference(number_of(fifo.content, event.subject, fifo.written));
  ++fifo.written;
  if (fifo.content == Content::rays && event.subject.object != no_object) {
    objects_[event.subject.ray] = event.subject.object + 1;
  }
}

void FrameTables::add_ray(const Subject& ray) {
  ray_row_.add_difference(ray.point.row);
  ray_column_.add_difference(ray.point.column);
  ray_request_.add_difference(from_one(ray.request));
  objects_.push_back(0);
}

std::uint64_t FrameTables::number_of(Content content, const Subject& subject, std::uint64_t count) {
  if (content == Content::nodes) return number_of_node(subject);
  if (content == Content::rays) return subject.ray;
  return content == Content::corners ? count : 0;
}

/// The classifier's writes come first of all that is about a node.
std::uint64_t FrameTables::number_of_node(const Subject& node) {
  const Cell cell{node.point, node.log2_side};
  const auto [place, added] = nodes_.try_emplace(cell, static_cast<std::uint32_t>(nodes_.size()));
  if (added) {
    node_row_.add_difference(node.point.row);
    node_column_.add_difference(node.point.column);
    node_log2_side_.add_difference(node.log2_side);
    node_request_.add_difference(from_one(node.request));
    cases_.push_back(0);
  }
  if (node.which) cases_[place->second] = static_cast<std::uint8_t>(static_cast<unsigned>(*node.which) + 1);
  return place->second;
}

ordered_json FrameTables::description() const {
  const auto name = [](Content content) { return content_names[static_cast<std::size_t>(content)]; };
  const auto& stages = processor_.stages();
  ordered_json units = ordered_json::array();
  for (std::size_t k = 0; k < units_.size(); ++k) {
    units.push_back({{"name", stages[k]->basename()},
                     {"box", stages[k]->box()},
                     {"about", name(units_[k].content)},
                     {"firings", units_[k].firings}});
  }
  ordered_json fifos = ordered_json::array();
  for (std::size_t k = 0; k < fifos_.size(); ++k) {
    const auto& [fifo, writer, reader] = processor_.wires()[k];
    fifos.push_back({{"name", fifo->basename()},
                     {"depth", fifo->depth()},
                     {"writer", processor_.number_of(*writer)},
                     {"reader", processor_.number_of(*reader)},
                     {"about", name(fifos_[k].content)},
                     {"preloaded", fifos_[k].preloaded},
                     {"written", fifos_[k].written},
                     {"read", fifos_[k].read}});
  }
  return {{"units", units}, {"fifos", fifos}, {"rays", objects_.size()}, {"nodes", nodes_.size()}};
}

std::string FrameTables::bytes() const {
  std::string bytes;
  const auto add = [&bytes](const auto&... column) { ((bytes += column.bytes()), ...); };
  const auto add_numbers = [&bytes](const auto& numbers) {
    for (const auto number : numbers) append_varint(bytes, number);
  };
  for (const Unit& unit : units_) add(unit.wait, unit.busy, unit.cause, unit.subject);
  for (const Fifo& fifo : fifos_) add(fifo.at, fifo.latency, fifo.stay, fifo.subject);
  add(ray_row_, ray_column_, ray_request_);
  add_numbers(objects_);
  add(node_row_, node_column_, node_log2_side_, node_request_);
  add_numbers(cases_);
  return bytes;
}

}  // namespace pyrasim::hw
