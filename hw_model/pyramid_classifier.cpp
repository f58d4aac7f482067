// SPDX-License-Identifier: Apache-2.0
#include "hw_model/pyramid_classifier.h"

namespace pyrasim::hw {

PyramidClassifier::PyramidClassifier(const sc_core::sc_module_name& name, StageTiming timing, std::size_t units,
                                     const Scene& scene, Leaf leaf, int max_level)
    : StageOf(name),
      intersection_units("intersection_unit", units),
      timing_(timing),
      palette_(scene),
      leaf_(leaf),
      max_level_(max_level),
      columns_(static_cast<std::uint32_t>(scene.camera.screen.columns)),
      corner_row_(static_cast<std::size_t>(columns_) + 2) {}

Start PyramidClassifier::next(Ends& ends, Cycle ready) {
  if (!step_.known) plan();
  Start start(ready);
  if (!step_.known) return await_sample(start);
  if (step_.reads_sample) {
    if (reorder_buffer.bound()) start.needs_token(*reorder_buffer);
    start.needs_token(*intersection_units[unit_]);
  }
  if (step_.reads_parent) start.needs_token(*parents);
  if (step_.to_controller()) start.needs_room(*subdivision_controller);
  if (step_.to_accumulator()) start.needs_room(ends.tree_accumulator);
  return start;
}

/// Nothing is known until the next sample is seen.
Start PyramidClassifier::await_sample(Start start) const {
  if (reorder_buffer.bound() && reorder_buffer->empty()) return start.needs_token(*reorder_buffer);
  return start.needs_token(*intersection_units[unit_]);
}

void PyramidClassifier::plan() {
  step_.reads_sample = step_.reads_parent = step_.has_node = false;
  if (samples_ == subdivision_rays) {
    step_.known = true;
    plan_subpixel(3);
    return;
  }
  if (reorder_buffer.bound()) {
    if (reorder_buffer->empty()) return;
    unit_ = reorder_buffer->front().unit;
  }
  if (intersection_units[unit_]->empty()) return;
  step_.known = true;
  step_.reads_sample = true;
  const SampleMessage& message = intersection_units[unit_]->front();
  if (!message.subdivision) {
    plan_corner(message);
    return;
  }
  step_.reads_parent = samples_ == 0;
  middle_[samples_] = message.sample;
  if (samples_ >= center) plan_subpixel(samples_ - center);
}

void PyramidClassifier::plan_corner(const SampleMessage& message) {
  if (message.tag.pixel == no_pixel) return;
  const std::size_t last = corner_row_.size() - 1;
  const Sample& upper_left = corner_row_[corner_];  // the oldest
  const Sample& upper_right = corner_row_[corner_ == last ? 0 : corner_ + 1];
  const Sample& lower_left = corner_row_[corner_ == 0 ? last : corner_ - 1];  // the newest
  step_.has_node = true;
  step_.node.tag = message.tag;
  step_.node.corners = {upper_left, upper_right, lower_left, message.sample};
  step_.node.pyramid = {};
  step_.node.closes_family = false;
  classify_node();
  if (!step_.node.subdivide) return;
  const std::uint32_t mu = message.tag.pixel / columns_;
  const std::uint32_t nu = message.tag.pixel % columns_;
  step_.node.pyramid.corner = {mu << max_level_, nu << max_level_};
}

void PyramidClassifier::plan_subpixel(std::size_t child) {
  step_.has_node = true;
  step_.node.tag = parent_.tag;
  step_.node.pyramid = subpixel(parent_.pyramid, child, max_level_);
  step_.node.corners = subpixel_corners(parent_.corners, middle_, child);
  classify_node();
  // The controller keeps room for a family that can be subdivided further, until it hears of the last one.
  step_.node.closes_family = child == 3 && step_.node.pyramid.level < static_cast<std::uint32_t>(max_level_);
}

void PyramidClassifier::classify_node() {
  step_.which = classify(step_.node.corners);
  step_.node.subdivide = subdivides(step_.which, step_.node.pyramid.level, max_level_);
}

Cycle PyramidClassifier::fire(Ends& ends, Cycle now) {
  if (step_.reads_parent) parent_ = parents->read(now);
  if (step_.reads_sample) {
    take_sample(now);
  } else {
    samples_ = 0;
  }
  if (step_.has_node) emit(ends, now);
  step_.known = false;
  return timing_.interval;
}

void PyramidClassifier::take_sample(Cycle now) {
  Fifo<SampleMessage>& samples = *intersection_units[unit_];
  if (samples.front().subdivision) {
    ++samples_;
  } else {
    corner_row_[corner_] = samples.front().sample;
    if (++corner_ == corner_row_.size()) corner_ = 0;
  }
  samples.pop(now);
  if (reorder_buffer.bound()) reorder_buffer->pop(now);
  if (++unit_ == intersection_units.size()) unit_ = 0;
}

void PyramidClassifier::emit(Ends& ends, Cycle now) {
  const NodeMessage& node = step_.node;
  counts_.count(step_.which, node.pyramid.level);
  if (node.subdivide) ++counts_.subdivisions;
  if (step_.to_controller()) subdivision_controller->write(node, now, timing_.latency);
  if (!step_.to_accumulator()) return;
  ++counts_.terminal_nodes;
  ends.tree_accumulator.write_made(
      [&] {
        return TerminalMessage{palette_.terminal_color(step_.which, node.corners, leaf_), node.tag, node.pyramid.level};
      },
      now, timing_.latency);
}

template class StageOf<PyramidClassifier>;

}  // namespace pyrasim::hw
