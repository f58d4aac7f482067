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

template <class Message, sc_core::sc_port_policy policy>
void bind_port(FifoPort<Message, policy>& port, std::size_t, Fifo<Message>& fifo) {
  port(fifo);
}
/// One of several: that for the neighbour of that number.
template <class Message>
void bind_port(FifoPorts<Message>& ports, std::size_t number, Fifo<Message>& fifo) {
  ports.port(number)(fifo);
}

}  // namespace

Processor::Processor(const sc_core::sc_module_name& name, const Scene& scene, const MachineSpec& spec,
                     const SimulationOptions& options)
    : sc_module(name),
      max_cycles_(std::min(options.max_cycles, longest_frame)),
      control_{max_cycles_, [this] { the<FrameBuffer>().report(); }},
      spec_(checked(spec, scene, options)),
      window_(scene.camera.rendered()),
      formats_(options.formats),
      intersector_(options.intersector ? options.intersector : make_intersector(scene, formats_.intersection)),
      view_vectors_(scene.camera.screen, std::int64_t{1} << options.max_level, formats_.view_vectors),
      contents_(intersector_->contents()) {
  const FrameSetup frame{spec_, scene, options, window_, *intersector_, view_vectors_, stopping(options.progress)};
  for_each_stage([&](const auto& plan) { build(plan, frame); });
  for_each_wire([&](const auto& plan) { connect(plan); });
  for (std::size_t k = 0; k < all<ShadowUnit>().size(); ++k) {
    all<ShadowUnit>()[k]->account_for(all<IntersectionUnit>()[k]->work().shadow);
  }
  Fifo<SlotCredit>& slots = *the<PixelScan>().tree_accumulator;
  for (std::uint32_t slot = 0; slot < slots.depth(); ++slot) slots.preload({slot});
  if (options.engine == Engine::lockstep) {
    for (Stage* stage : stages_) stage->run_in_lockstep(control_);
    return;
  }
  DecoupledEngine::Boxes boxes{the<PixelScan>(),           the<ViewVectorGenerator>(),        {},
                               !all<ShadowUnit>().empty(), optional<SubdivisionController>(), the<ColorUnit>(),
                               the<FrameBuffer>()};
  for (const auto& unit : all<IntersectionUnit>()) boxes.units.push_back(unit.get());
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
    corners.emplace(*intersector_, view_vectors_, window_, std::uint32_t{1} << max_level(),
                    all<IntersectionUnit>().size() * spec_.fifos.view_vector_generator_to_intersection_unit);
  }
  for (const auto& unit : all<IntersectionUnit>()) unit->take_corners(corners ? &*corners : nullptr);
  engine_->run(control_, events_);
}

void Processor::attach(EventSink& sink) {
  for (std::size_t k = 0; k < fifos_.size(); ++k) fifos_[k]->report_to({events_, k});
  if (sink.in_order() && !events_.has_sinks_in_order()) {
    for (std::size_t k = 0; k < stages_.size(); ++k) stages_[k]->report_to({events_, k});
    events_.follow({stages_, wires_, window_, max_level()});
    if (!engine_) events_.follow_kernel();
  }
  events_.attach(sink);
}

void Processor::attach(WorkSink& sink) {
  for (const auto& unit : all<IntersectionUnit>()) unit->report_work_to(sink);
  the<ColorUnit>().report_work_to(sink);
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

template <class Stage>
void Processor::build(const StagePlan<Stage>& plan, const FrameSetup& frame) {
  needs_.push_back(plan.need(frame));
  if (!needs_.back().built) return;
  const std::size_t copies = plan.copies == nullptr ? 1 : spec_.*plan.copies;
  for (std::size_t k = 0; k < copies; ++k) {
    auto stage = std::make_unique<Stage>(name_of<Stage>(k).c_str(), frame);
    stage->belongs_to(box_of<Stage>());
    stages_.push_back(stage.get());
    std::get<Built<Stage>>(built_).push_back(std::move(stage));
  }
}

template <class Out, class Writer, class In, class Reader>
void Processor::connect(const WirePlan<Out, Writer, In, Reader>& plan) {
  const auto& writers = all<Writer>();
  const auto& readers = all<Reader>();
  if (writers.empty() || readers.empty()) return;
  if (plan.needed != nullptr && !(*writers.front().*plan.needed)()) return;
  for (std::size_t k = 0; k < std::max(writers.size(), readers.size()); ++k) {
    Writer& writer = *writers[k % writers.size()];
    Reader& reader = *readers[k % readers.size()];
    auto fifo = std::make_unique<Fifo<typename Out::Token>>(
        fmt::format("{}_to_{}", name_of<Writer>(k), name_of<Reader>(k)).c_str(), plan.depth_on(spec_));
    bind_port(writer.*plan.out, k, *fifo);
    bind_port(reader.*plan.in, k, *fifo);
    fifo->connect(writer, reader);
    fifos_.push_back(fifo.get());
    wires_.push_back({fifo.get(), &writer, &reader});
    channels_.push_back(std::move(fifo));
  }
}

template <class Stage>
void Processor::list(const StagePlan<Stage>& plan, const Need& need, std::vector<MachinePart>& parts) const {
  const auto& units = all<Stage>();
  MachinePart box{std::string(plan.name), "", units.size(), need.reason, 0};
  std::vector<MachinePart> inside;
  for (const auto& unit : units) {
    box.busy += unit->statistics(cycles()).busy;
    if constexpr (requires { unit->parts(); }) {
      const std::vector<StagePart> own = unit->parts();
      for (std::size_t k = 0; k < own.size(); ++k) {
        const auto& [name, need_of_part, busy] = own[k];
        if (k == inside.size()) {
          inside.push_back({box.box, name, need_of_part.built ? units.size() : 0, need_of_part.reason, 0});
        }
        inside[k].busy += busy;
      }
    }
  }
  parts.push_back(std::move(box));
  parts.insert(parts.end(), inside.begin(), inside.end());
}

std::size_t Processor::number_of(const Stage& stage) const {
  return static_cast<std::size_t>(std::find(stages_.begin(), stages_.end(), &stage) - stages_.begin());
}

std::vector<MachinePart> Processor::parts() const {
  std::vector<MachinePart> parts;
  auto need = needs_.begin();
  for_each_stage([&](const auto& plan) { list(plan, *need++, parts); });
  return parts;
}

Cycle Processor::cycles() const {
  Cycle end = 0;
  for (const Stage* stage : stages_) end = std::max(end, stage->ready());
  return end;
}

FrameStatistics Processor::statistics() const {
  FrameStatistics statistics = the<PyramidClassifier>().counts();
  statistics.rays_by_level = the<ViewVectorGenerator>().rays_by_level();
  statistics.lights_with_shadows = contents_.lights_with_shadows;
  statistics.texture = the<ColorUnit>().work();
  statistics.arithmetic.view_vectors = the<ViewVectorGenerator>().events();
  for (const auto& unit : all<IntersectionUnit>()) {
    statistics.work += unit->work();
    statistics.arithmetic.intersection += unit->events();
  }
  return statistics;
}

std::pair<int, int> Processor::place_of(std::uint32_t pixel) const {
  const auto columns = static_cast<std::uint32_t>(window_.columns);
  return {window_.row + static_cast<int>(pixel / columns), window_.column + static_cast<int>(pixel % columns)};
}

std::optional<std::uint32_t> Processor::pixel_at(int row, int column) const {
  const int down = row - window_.row;
  const int right = column - window_.column;
  if (down < 0 || down >= window_.rows || right < 0 || right >= window_.columns) return std::nullopt;
  return static_cast<std::uint32_t>(down * window_.columns + right);
}

bool Processor::at_rest() const {
  return std::none_of(stages_.begin(), stages_.end(), [](Stage* stage) { return stage->next_start().known(); });
}

const Wire& Processor::wire_of(const FifoBase& fifo) const {
  return *std::find_if(wires_.begin(), wires_.end(), [&](const Wire& wire) { return wire.fifo == &fifo; });
}

}  // namespace pyrasim::hw
