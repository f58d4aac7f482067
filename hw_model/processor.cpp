// SPDX-License-Identifier: Apache-2.0
#include "hw_model/processor.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "hw_model/stage/kernel_time.h"
#include "render/picture_memory.h"

namespace pyrasim::hw {
namespace {

MachineSpec checked(const MachineSpec& spec, const Scene& scene, const SimulationOptions& options) {
  const PixelWindow window = scene.camera.rendered();
  if (options.check_machine) check_machine_holds(spec, options.max_level, window.columns);
  check_picture_fits(window);
  return spec;
}

}  // namespace

Processor::Processor(const sc_core::sc_module_name& name, const Scene& scene, const MachineSpec& spec,
                     const SimulationOptions& options)
    : sc_module(name),
      max_cycles_(std::min(options.max_cycles, longest_frame)),
      control_{max_cycles_, [this] { frame_buffer_.report(); }},
      spec_(checked(spec, scene, options)),
      window_(scene.camera.rendered()),
      formats_(options.formats),
      intersector_(options.intersector ? options.intersector : make_intersector(scene, formats_.intersection)),
      view_vectors_(scene.camera.screen, std::int64_t{1} << options.max_level, formats_.view_vectors),
      contents_(intersector_->contents()),
      pixel_scan_("pixel_scan", spec.pixel_scan, window_, options.max_level),
      view_vector_generator_("view_vector_generator", spec.view_vector_generator, spec.intersection_units,
                             spec.dispatch, view_vectors_, formats_.counts_events(), options.max_level),
      pyramid_classifier_("pyramid_classifier", spec.pyramid_classifier, spec.intersection_units, window_,
                          options.max_level),
      color_unit_("color_unit", spec.color_unit, scene, options.edge),
      tree_accumulator_("tree_accumulator", spec.tree_accumulator, spec.pixels_in_flight, options.max_level),
      frame_buffer_("frame_buffer", spec.frame_buffer_interval, window_.columns, window_.rows,
                    stopping(options.progress)) {
  for (std::size_t k = 0; k < spec.intersection_units; ++k) {
    intersection_units_.push_back(std::make_unique<IntersectionUnit>(fmt::format("intersection_unit_{}", k).c_str(),
                                                                     spec.intersection_latency, spec.intersection_cost,
                                                                     *intersector_, formats_.counts_events()));
  }
  if (options.max_level > 0 && !scene.objects.empty()) {
    controller_ = std::make_unique<SubdivisionController>("subdivision_controller", spec.subdivision_controller,
                                                          spec.subdivision_pool, options.max_level);
  }
  bind();
  list_omitted();
  if (options.engine == Engine::lockstep) {
    for (Stage* stage : stages_) stage->run_in_lockstep(control_);
    return;
  }
  DecoupledEngine::Boxes boxes{pixel_scan_, view_vector_generator_, {}, controller_.get(), color_unit_, frame_buffer_};
  for (const auto& unit : intersection_units_) boxes.units.push_back(unit.get());
  engine_ = std::make_unique<DecoupledEngine>(stages_, wires_, std::move(boxes), spec);
  sc_core::sc_spawn(
      [this, threads = options.threads] {
        run_decoupled(threads);
        sc_core::wait(kernel_time(cycles()));  // the kernel's clock shows the frame's end
      },
      "decoupled");
}

void Processor::run_decoupled(int threads) {
  std::optional<CornersAhead> corners;
  if (threads > 1 && !formats_.counts_events()) {
    corners.emplace(*intersector_, view_vectors_, window_, std::uint32_t{1} << pyramid_classifier_.max_level(),
                    intersection_units_.size() * spec_.fifos.view_vector_generator_to_intersection_unit);
  }
  for (const auto& unit : intersection_units_) unit->take_corners(corners ? &*corners : nullptr);
  engine_->run(control_);
}

/// `progress`, heeded: the machine stops where it says so.
Progress Processor::stopping(const Progress& progress) {
  if (!progress) return {};
  return [this, progress](double share) {
    const bool go_on = progress(share);
    if (!go_on) control_.last = 0;
    return go_on;
  };
}

template <class Message, class Writer, class Reader, class Out, class In>
Fifo<Message>& Processor::connect(const char* name, std::size_t depth, Writer& writer, Out&& out, Reader& reader,
                                  In&& in) {
  auto fifo = std::make_unique<Fifo<Message>>(name, depth);
  out(*fifo);
  in(*fifo);
  fifo->connect(writer, reader);
  Fifo<Message>& channel = *fifo;
  fifos_.push_back(&channel);
  wires_.push_back({&channel, &writer, &reader});
  channels_.push_back(std::move(fifo));
  return channel;
}

/// All of the machine's wires, in data-flow order.
void Processor::bind() {
  const FifoDepths& depths = spec_.fifos;
  connect<CornerRequest>("pixel_scan_to_view_vector_generator", depths.pixel_scan_to_view_vector_generator, pixel_scan_,
                         pixel_scan_.view_vector_generator, view_vector_generator_, view_vector_generator_.pixel_scan);
  stages_ = {&pixel_scan_, &view_vector_generator_};
  for (std::size_t k = 0; k < intersection_units_.size(); ++k) {
    IntersectionUnit& unit = *intersection_units_[k];
    connect<RayMessage>(fmt::format("view_vector_generator_to_intersection_unit_{}", k).c_str(),
                        depths.view_vector_generator_to_intersection_unit, view_vector_generator_,
                        view_vector_generator_.intersection_units.port(k), unit, unit.view_vector_generator);
    connect<SampleMessage>(fmt::format("intersection_unit_{}_to_pyramid_classifier", k).c_str(),
                           depths.intersection_unit_to_pyramid_classifier, unit, unit.pyramid_classifier,
                           pyramid_classifier_, pyramid_classifier_.intersection_units.port(k));
    stages_.push_back(&unit);
  }
  if (view_vector_generator_.chooses_unit()) {
    connect<UnitNumber>("view_vector_generator_to_pyramid_classifier", spec_.issue_order_queue, view_vector_generator_,
                        view_vector_generator_.issue_order_queue, pyramid_classifier_,
                        pyramid_classifier_.issue_order_queue);
  }
  stages_.push_back(&pyramid_classifier_);
  if (controller_) bind_controller();
  connect<TerminalMessage>("pyramid_classifier_to_color_unit", depths.pyramid_classifier_to_color_unit,
                           pyramid_classifier_, pyramid_classifier_.color_unit, color_unit_,
                           color_unit_.pyramid_classifier);
  connect<ColorMessage>("color_unit_to_tree_accumulator", depths.color_unit_to_tree_accumulator, color_unit_,
                        color_unit_.tree_accumulator, tree_accumulator_, tree_accumulator_.color_unit);
  connect<PixelMessage>("tree_accumulator_to_frame_buffer", depths.tree_accumulator_to_frame_buffer, tree_accumulator_,
                        tree_accumulator_.frame_buffer, frame_buffer_, frame_buffer_.tree_accumulator);
  auto& credits = connect<SlotCredit>("tree_accumulator_to_pixel_scan", spec_.pixels_in_flight, tree_accumulator_,
                                      tree_accumulator_.pixel_scan, pixel_scan_, pixel_scan_.tree_accumulator);
  for (std::uint32_t slot = 0; slot < spec_.pixels_in_flight; ++slot) credits.preload({slot});
  stages_.push_back(&color_unit_);
  stages_.push_back(&tree_accumulator_);
  stages_.push_back(&frame_buffer_);
}

void Processor::bind_controller() {
  const FifoDepths& depths = spec_.fifos;
  SubdivisionController& controller = *controller_;
  connect<NodeMessage>("pyramid_classifier_to_subdivision_controller",
                       depths.pyramid_classifier_to_subdivision_controller, pyramid_classifier_,
                       pyramid_classifier_.subdivision_controller, controller, controller.pyramid_classifier);
  connect<SubdivisionRequest>("subdivision_controller_to_view_vector_generator",
                              depths.subdivision_controller_to_view_vector_generator, controller,
                              controller.view_vector_generator, view_vector_generator_,
                              view_vector_generator_.subdivision_controller);
  connect<NodeMessage>("subdivision_controller_to_pyramid_classifier",
                       depths.subdivision_controller_to_pyramid_classifier, controller, controller.parents,
                       pyramid_classifier_, pyramid_classifier_.parents);
  stages_.push_back(&controller);
}

void Processor::list_omitted() {
  if (!controller_) {
    omitted_.push_back({"subdivision_controller", pyramid_classifier_.max_level() == 0
                                                      ? "MAX_LEVEL is 0: nothing is subdivided"
                                                      : "the scene has no objects: nothing is subdivided"});
  }
  if (contents_.inner_nodes == 0) {
    omitted_.push_back({"intersection_unit.hierarchy_walker", "the scene has fewer than two bounded surfaces"});
  }
  for (std::size_t kind = 0; kind < surface_kinds; ++kind) {
    if (contents_.surfaces[kind] > 0) continue;
    omitted_.push_back({fmt::format("intersection_unit.{}_tester", surface_kind_names[kind]),
                        fmt::format("the scene has no {}", surface_kind_names[kind])});
  }
}

Cycle Processor::cycles() const {
  Cycle end = 0;
  for (const Stage* stage : stages_) end = std::max(end, stage->ready());
  return end;
}

FrameStatistics Processor::statistics() const {
  FrameStatistics statistics = pyramid_classifier_.counts();
  statistics.rays_by_level = view_vector_generator_.rays_by_level();
  statistics.arithmetic.view_vectors = view_vector_generator_.events();
  for (const auto& unit : intersection_units_) {
    statistics.work += unit->work();
    statistics.arithmetic.intersection += unit->events();
  }
  return statistics;
}

std::pair<int, int> Processor::place_of(std::uint32_t pixel) const {
  const auto columns = static_cast<std::uint32_t>(window_.columns);
  return {window_.row + static_cast<int>(pixel / columns), window_.column + static_cast<int>(pixel % columns)};
}

bool Processor::at_rest() const {
  return std::none_of(stages_.begin(), stages_.end(), [](Stage* stage) { return stage->next_start().known(); });
}

const Wire& Processor::wire_of(const FifoBase& fifo) const {
  return *std::find_if(wires_.begin(), wires_.end(), [&](const Wire& wire) { return wire.fifo == &fifo; });
}

}  // namespace pyrasim::hw
