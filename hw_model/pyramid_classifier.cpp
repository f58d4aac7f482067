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
      window_(scene.camera.rendered()),
      columns_(static_cast<std::uint32_t>(window_.columns)),
      corner_row_(static_cast<std::size_t>(columns_) + 1) {}

Start PyramidClassifier::next(Ends& ends, Cycle ready) {
  Step& step = ends.step;
  plan(step);
  Start start(ready);
  if (!step.known) return await_sample(start);
  if (step.samples != nullptr) {
    if (reorder_buffer.bound()) start.needs_token(*reorder_buffer);
    start.needs_token(*step.samples);
  }
  if (step.reads_parent) start.needs_token(*parents);
  if (step.to_controller()) start.needs_room(*subdivision_controller);
  if (step.to_accumulator()) start.needs_room(ends.tree_accumulator);
  return start;
}

/// Nothing is known until the next sample is seen.
Start PyramidClassifier::await_sample(Start start) const {
  if (reorder_buffer.bound() && reorder_buffer->empty()) return start.needs_token(*reorder_buffer);
  return start.needs_token(*intersection_units[unit_]);
}

void PyramidClassifier::plan(Step& step) {
  step.samples = nullptr;
  step.reads_parent = false;
  step.node = nullptr;
  step.known = samples_ == subdivision_rays;
  if (step.known) {
    plan_subpixel(step, 3);
    return;
  }
  if (reorder_buffer.bound()) {
    if (reorder_buffer->empty()) return;
    unit_ = reorder_buffer->front().unit;
  }
  Fifo<SampleMessage>& samples = *intersection_units[unit_];
  if (samples.empty()) return;
  step.known = true;
  step.samples = &samples;
  const SampleMessage& message = samples.front();
  if (!message.subdivision) {
    plan_corner(step, message);
    return;
  }
  step.reads_parent = samples_ == 0;
  middle_[samples_] = message.sample;
  if (samples_ >= center) plan_subpixel(step, samples_ - center);
}

void PyramidClassifier::plan_corner(Step& step, const SampleMessage& message) const {
  if (message.tag.pixel == no_pixel) return;
  const Sample* const upper_right = &corner_row_[column_];
  const Sample* const lower_left = upper_right - 1;
  step.node = &message.tag;
  step.corners = {upper_left_, *upper_right, *lower_left, message.sample};
  step.pyramid = {};
  step.closes_family = false;
  classify_node(step);
  if (!step.subdivide) return;
  const std::uint32_t mu = message.tag.pixel / columns_;
  const std::uint32_t nu = message.tag.pixel % columns_;
  step.pyramid.corner = pixel_corner(window_, mu, nu, max_level_);
}

void PyramidClassifier::plan_subpixel(Step& step, std::size_t child) const {
  step.node = &parent_.tag;
  step.pyramid = subpixel(parent_.pyramid, child, max_level_);
  step.corners = subpixel_corners(parent_.corners, middle_, child);
  classify_node(step);
  // The controller keeps room for a family that can be subdivided further, until it hears of the last one.
  step.closes_family = child == 3 && step.pyramid.level < static_cast<std::uint32_t>(max_level_);
}

void PyramidClassifier::classify_node(Step& step) const {
  step.which = classify(step.corners);
  step.subdivide = subdivides(step.which, step.pyramid.level, max_level_);
}

Cycle PyramidClassifier::fire(Ends& ends, Cycle now) {
  const Step& step = ends.step;
  if (!step.known) plan(ends.step);
  if (step.node != nullptr) emit(ends, now);
  if (step.reads_parent) parent_ = parents->read(now);
  if (step.samples != nullptr) {
    take_sample(*step.samples, now);
  } else {
    samples_ = 0;
  }
  return timing_.interval;
}

void PyramidClassifier::take_sample(Fifo<SampleMessage>& samples, Cycle now) {
  const SampleMessage& message = samples.front();
  if (message.subdivision) {
    ++samples_;
  } else {
    upper_left_ = corner_row_[column_];
    corner_row_[column_] = message.sample;
    if (++column_ > columns_) column_ = 0;
  }
  samples.pop(now);
  if (reorder_buffer.bound()) reorder_buffer->pop(now);
  if (++unit_ == intersection_units.size()) unit_ = 0;
}

void PyramidClassifier::emit(Ends& ends, Cycle now) {
  const Step& step = ends.step;
  counts_.count(step.which, step.pyramid.level);
  if (step.subdivide) ++counts_.subdivisions;
  if (step.to_controller()) {
    subdivision_controller->write_made(
        [&] {
          return NodeMessage{step.pyramid, *step.node, step.corners, step.subdivide, step.closes_family};
        },
        now, timing_.latency);
  }
  if (!step.to_accumulator()) return;
  ++counts_.terminal_nodes;
  ends.tree_accumulator.write_made(
      [&] {
        return TerminalMessage{palette_.terminal_color(step.which, step.corners, leaf_), *step.node,
                               step.pyramid.level};
      },
      now, timing_.latency);
}

template class StageOf<PyramidClassifier>;

}  // namespace pyrasim::hw
