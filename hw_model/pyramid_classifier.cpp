// SPDX-License-Identifier: Apache-2.0
#include "hw_model/pyramid_classifier.h"

namespace pyrasim::hw {

PyramidClassifier::PyramidClassifier(const sc_core::sc_module_name& name, const FrameSetup& frame)
    : StageOf(name),
      samples("intersection_unit", frame.spec.intersection_units),
      timing_(frame.spec.pyramid_classifier),
      max_level_(frame.options.max_level),
      window_(frame.window),
      columns_(static_cast<std::uint32_t>(window_.columns)),
      line_buffer_(static_cast<std::size_t>(columns_) + 1),
      maps_(frame.options.maps) {}

PyramidClassifier::Plan PyramidClassifier::next(const Ends& ends, Cycle ready) const {
  Plan plan(ready);
  if (samples_ == subdivision_rays) {
    plan.node.emplace(*this, std::size_t{3}, parent_.corners[3]);
  } else if (!plan_sample(plan)) {
    return plan;
  }
  if (plan.reads_parent) plan.start.needs_token(*parents);
  if (plan.node) {
    if (plan.node->to_controller()) plan.start.needs_room(*subdivision_controller);
    if (!plan.node->subdivide) plan.start.needs_room(ends.color_unit);
  }
  return plan;
}

/// Returns whether the next sample is there: until then nothing is known.
bool PyramidClassifier::plan_sample(Plan& plan) const {
  std::size_t unit = unit_;
  if (issue_order_queue.bound()) {
    plan.start.needs_token(*issue_order_queue);
    if (issue_order_queue->empty()) return false;
    unit = issue_order_queue->front().unit;
  }
  plan.samples = &samples[unit];
  plan.start.needs_token(*plan.samples);
  if (plan.samples->empty()) return false;
  const SampleMessage& message = plan.samples->front();
  if (message.subdivision) {
    plan.reads_parent = samples_ == 0;
    if (samples_ >= center) plan.node.emplace(*this, samples_ - center, message.sample);
  } else if (message.tag.pixel != no_pixel) {
    plan.node.emplace(*this, message);
  }
  return true;
}

PyramidClassifier::Node::Node(const PyramidClassifier& classifier, const SampleMessage& lower_right)
    : tag(lower_right.tag),
      cell(pixel_cell(classifier.window_, tag.pixel / classifier.columns_, tag.pixel % classifier.columns_,
                      classifier.max_level_)),
      corners{classifier.upper_left_, classifier.line_buffer_[classifier.column_],
              classifier.line_buffer_[classifier.column_ - 1], lower_right.sample},
      which(classify(corners)),
      subdivide(subdivides(which, cell)) {}

PyramidClassifier::Node::Node(const PyramidClassifier& classifier, std::size_t child, const Sample& lower_right)
    : tag(classifier.parent_.tag),
      cell(subpixel(classifier.parent_.cell, child)),
      corners(subpixel_corners(classifier.parent_.corners, classifier.middle_, child)) {
  corners[3] = lower_right;
  which = classify(corners);
  subdivide = subdivides(which, cell);
  // The controller keeps room for a family that can be subdivided further, until it hears of the last one.
  closes_family = child == 3 && cell.log2_side > 0;
}

Cycle PyramidClassifier::fire(Ends& ends, const Plan& plan) {
  const Cycle now = plan.start.at();
  if (plan.node) emit(ends, *plan.node, now);
  if (plan.reads_parent) {
    parent_ = parents->front();
    parents->pop(now);
  }
  if (plan.samples != nullptr) {
    take_sample(*plan.samples, now);
  } else {
    samples_ = 0;
  }
  return timing_.interval;
}

void PyramidClassifier::take_sample(Fifo<SampleMessage>& fifo, Cycle now) {
  const SampleMessage& message = fifo.front();
  if (message.subdivision) {
    middle_[samples_++] = message.sample;
  } else {
    upper_left_ = line_buffer_[column_];
    line_buffer_[column_] = message.sample;
    if (++column_ > columns_) column_ = 0;
  }
  fifo.pop(now);
  if (issue_order_queue.bound()) {
    issue_order_queue->pop(now);
  } else if (++unit_ == samples.size()) {
    unit_ = 0;
  }
}

void PyramidClassifier::emit(Ends& ends, const Node& node, Cycle now) {
  counts_.count(node.which, level_of(node.cell.log2_side, max_level_));
  if (node.subdivide) ++counts_.subdivisions;
  if (node.to_controller()) {
    subdivision_controller->write_made(
        [&] {
          return NodeMessage{node.cell, node.tag, node.corners, node.subdivide, node.closes_family};
        },
        now, timing_.latency);
  }
  if (node.subdivide) return;
  ++counts_.terminal_nodes;
  if (maps_ != nullptr) maps_->add_terminal_node(node.tag.pixel, node.which, node.cell.log2_side);
  ends.color_unit.write_made(
      [&] {
        return TerminalMessage{node.cell, node.tag, node.corners, node.which};
      },
      now, timing_.latency);
}

template class StageOf<PyramidClassifier>;

}  // namespace pyrasim::hw
