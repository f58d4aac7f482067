// SPDX-License-Identifier: Apache-2.0
// The machine's wires, a line each: elaboration and the settings of FIFO depths follow.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <tuple>

#include "hw_model/plan/stage_list.h"

namespace pyrasim::hw {

/// A FIFO from a port of one stage to a port of another, built where both stages are, and the writer says that it is
/// `needed`. Where a stage has copies, each has its own, and the port at the other end is a FifoPorts.
template <class Out, class From, class In, class To>
struct WirePlan {
  /// The depth is a setting of the FIFO's name.
  constexpr WirePlan(Out From::*its_out, In To::*its_in, std::size_t FifoDepths::*its_depth,
                     bool (From::*is_needed)() const = nullptr)
      : out(its_out), in(its_in), depth(its_depth), needed(is_needed) {}
  /// The depth is a stage's setting.
  constexpr WirePlan(Out From::*its_out, In To::*its_in, std::size_t MachineSpec::*its_capacity,
                     bool (From::*is_needed)() const = nullptr)
      : out(its_out), in(its_in), capacity(its_capacity), needed(is_needed) {}

  std::size_t depth_on(const MachineSpec& spec) const { return depth == nullptr ? spec.*capacity : spec.fifos.*depth; }

  Out From::*out;
  In To::*in;
  std::size_t FifoDepths::*depth = nullptr;
  std::size_t MachineSpec::*capacity = nullptr;
  bool (From::*needed)() const = nullptr;
};

/// In data-flow order.
inline constexpr std::tuple wire_list{
    WirePlan{&PixelScan::view_vector_generator, &ViewVectorGenerator::pixel_scan,
             &FifoDepths::pixel_scan_to_view_vector_generator},
    WirePlan{&ViewVectorGenerator::intersection_units, &IntersectionUnit::view_vector_generator,
             &FifoDepths::view_vector_generator_to_intersection_unit},
    WirePlan{&IntersectionUnit::samples, &PyramidClassifier::samples,
             &FifoDepths::intersection_unit_to_pyramid_classifier, &IntersectionUnit::casts_no_shadows},
    WirePlan{&IntersectionUnit::samples, &ShadowUnit::intersection_unit, &FifoDepths::intersection_unit_to_shadow_unit},
    WirePlan{&ShadowUnit::pyramid_classifier, &PyramidClassifier::samples,
             &FifoDepths::shadow_unit_to_pyramid_classifier},
    WirePlan{&ViewVectorGenerator::issue_order_queue, &PyramidClassifier::issue_order_queue,
             &MachineSpec::issue_order_queue, &ViewVectorGenerator::chooses_unit},
    WirePlan{&PyramidClassifier::subdivision_controller, &SubdivisionController::pyramid_classifier,
             &FifoDepths::pyramid_classifier_to_subdivision_controller},
    WirePlan{&SubdivisionController::view_vector_generator, &ViewVectorGenerator::subdivision_controller,
             &FifoDepths::subdivision_controller_to_view_vector_generator},
    WirePlan{&SubdivisionController::parents, &PyramidClassifier::parents,
             &FifoDepths::subdivision_controller_to_pyramid_classifier},
    WirePlan{&PyramidClassifier::color_unit, &ColorUnit::pyramid_classifier,
             &FifoDepths::pyramid_classifier_to_color_unit},
    WirePlan{&ColorUnit::tree_accumulator, &TreeAccumulator::color_unit, &FifoDepths::color_unit_to_tree_accumulator},
    WirePlan{&TreeAccumulator::frame_buffer, &FrameBuffer::tree_accumulator,
             &FifoDepths::tree_accumulator_to_frame_buffer},
    WirePlan{&TreeAccumulator::pixel_scan, &PixelScan::tree_accumulator, &MachineSpec::pixels_in_flight},
};

/// visit(plan) for every wire.
template <class Visit>
void for_each_wire(const Visit& visit) {
  std::apply([&](const auto&... wire) { (visit(wire), ...); }, wire_list);
}

/// "writer_to_reader", without the numbers of copies: as settings say it.
template <class Out, class From, class In, class To>
std::string name_of(const WirePlan<Out, From, In, To>&) {
  return fmt::format("{}_to_{}", plan_of<From>.name, plan_of<To>.name);
}

}  // namespace pyrasim::hw
