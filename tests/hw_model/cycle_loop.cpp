// SPDX-License-Identifier: Apache-2.0
// Written from docs/machine.md alone. A cycle has two phases. First every box decides, from the state at the beginning
// of the cycle, whether it fires; what it reads and writes is only noted in the FIFOs. Then all FIFOs take that over.
#include "cycle_loop.h"

#include <algorithm>
#include <deque>
#include <memory>
#include <numeric>
#include <optional>
#include <stdexcept>

#include "camera/view_vector.h"
#include "hw_model/message.h"
#include "intersect/intersector.h"
#include "pyramid/classifier.h"

namespace pyrasim::hw {
namespace {

struct AnyFifo {
  FifoDates dates;
  virtual ~AnyFifo() = default;
  virtual bool empty() const = 0;
  virtual void take_effect() = 0;
};

template <class Token>
class Fifo final : public AnyFifo {
 public:
  Fifo(std::size_t depth, Cycle latency) : depth_(depth), latency_(latency) {}

  // What a box sees: the state at the beginning of the cycle.
  bool readable(Cycle now) const { return !cells_.empty() && cells_.front().readable_from <= now; }
  bool has_room() const { return cells_.size() < depth_; }
  const Token& head() const { return cells_.front().token; }

  // What a box does: noted, until all boxes have decided.
  Token read(Cycle now) {
    dates.reads.push_back(now);
    is_read_ = true;
    return head();
  }
  void write(Cycle now, const Token& token, Cycle delay = 0) {
    dates.writes.push_back(now);
    written_ = Cell{token, now + latency_ + delay};
  }
  void preload(const Token& token) { cells_.push_back({token, 0}); }

  bool empty() const override { return cells_.empty(); }
  void take_effect() override {
    if (is_read_) cells_.pop_front();
    if (written_) cells_.push_back(*written_);
    is_read_ = false;
    written_.reset();
  }

 private:
  struct Cell {
    Token token;
    Cycle readable_from;
  };
  std::size_t depth_;
  Cycle latency_;
  std::deque<Cell> cells_;
  bool is_read_ = false;
  std::optional<Cell> written_;
};

/// The FIFOs between the boxes, and what all boxes know of the frame. What a frame does not need is here too, but stays
/// unused and is not in the Timeline.
struct Board {
  MachineSpec spec;
  PixelWindow window;
  int max_level;
  ViewVectors view_vectors;
  std::unique_ptr<Intersector> intersector;
  bool has_controller;
  bool has_shadow_units;
  Palette palette;
  bool has_issue_order_queue = spec.dispatch == Dispatch::first_free && spec.intersection_units > 1;

  Fifo<CornerRequest> corners{spec.fifos.pixel_scan_to_view_vector_generator, spec.pixel_scan.latency};
  std::vector<Fifo<RayMessage>> rays{
      spec.intersection_units,
      {spec.fifos.view_vector_generator_to_intersection_unit, spec.view_vector_generator.latency}};
  std::vector<Fifo<SampleMessage>> seen{///< from the intersection units to their shadow units
                                        spec.intersection_units,
                                        {spec.fifos.intersection_unit_to_shadow_unit, spec.intersection_latency}};
  std::vector<Fifo<SampleMessage>> samples{///< to the classifier
                                           spec.intersection_units,
                                           {has_shadow_units ? spec.fifos.shadow_unit_to_pyramid_classifier
                                                             : spec.fifos.intersection_unit_to_pyramid_classifier,
                                            has_shadow_units ? spec.shadow_unit.latency : spec.intersection_latency}};
  Fifo<std::size_t> order{spec.issue_order_queue, spec.view_vector_generator.latency};  ///< the issue-order queue
  Fifo<NodeMessage> nodes{spec.fifos.pyramid_classifier_to_subdivision_controller, spec.pyramid_classifier.latency};
  Fifo<SubdivisionRequest> requests{spec.fifos.subdivision_controller_to_view_vector_generator,
                                    spec.subdivision_controller.latency};
  Fifo<NodeMessage> parents{spec.fifos.subdivision_controller_to_pyramid_classifier,
                            spec.subdivision_controller.latency};
  Fifo<TerminalMessage> terminals{spec.fifos.pyramid_classifier_to_color_unit, spec.pyramid_classifier.latency};
  Fifo<ColorMessage> colors{spec.fifos.color_unit_to_tree_accumulator, spec.color_unit.latency};
  Fifo<PixelMessage> pixels{spec.fifos.tree_accumulator_to_frame_buffer, spec.tree_accumulator.latency};
  Fifo<SlotCredit> slots{spec.pixels_in_flight, spec.tree_accumulator.latency};
};

struct Box {
  explicit Box(Board& its_board) : board(its_board) {}
  virtual ~Box() = default;
  /// Fires if it can. Returns the cycles that it is busy for: 0 where it does not fire.
  virtual Cycle fire(Cycle now) = 0;

  Board& board;
  Cycle busy_until = 0;
};

struct PixelScan final : Box {
  using Box::Box;
  int row = 0, column = 0;

  Cycle fire(Cycle now) override {
    const PixelWindow& window = board.window;
    const bool completes_pixel = row > 0 && column > 0;
    if (row > window.rows || !board.corners.has_room()) return 0;
    if (completes_pixel && !board.slots.readable(now)) return 0;
    CornerRequest corner{{static_cast<std::uint32_t>(window.row + row) << board.max_level,
                          static_cast<std::uint32_t>(window.column + column) << board.max_level},
                         {}};
    if (completes_pixel) {
      const int pixel = (row - 1) * window.columns + column - 1;
      corner.tag = {static_cast<std::uint32_t>(pixel), board.slots.read(now).slot};
    }
    board.corners.write(now, corner);
    if (++column > window.columns) {
      column = 0;
      ++row;
    }
    return board.spec.pixel_scan.interval;
  }
};

struct ViewVectorGenerator final : Box {
  using Box::Box;
  Cell family{};          ///< of the request under way
  std::size_t point = 0;  ///< its next; 0: no request is under way
  std::size_t turn = 0;   ///< the unit after the one that got the last ray

  Cycle fire(Cycle now) override {
    const bool of_request = point > 0 || board.requests.readable(now);
    if (!of_request && !board.corners.readable(now)) return 0;
    const std::optional<std::size_t> unit = free_unit();
    if (!unit) return 0;
    board.rays[*unit].write(now, of_request ? request_ray(now) : corner_ray(now));
    if (board.has_issue_order_queue) board.order.write(now, *unit);
    turn = (*unit + 1) % board.rays.size();
    return board.spec.view_vector_generator.interval;
  }

  std::optional<std::size_t> free_unit() const {
    if (board.has_issue_order_queue && !board.order.has_room()) return {};
    const std::size_t candidates = board.has_issue_order_queue ? board.rays.size() : 1;
    for (std::size_t k = 0; k < candidates; ++k) {
      const std::size_t unit = (turn + k) % board.rays.size();
      if (board.rays[unit].has_room()) return unit;
    }
    return {};
  }

  RayMessage request_ray(Cycle now) {
    if (point == 0) family = board.requests.read(now).cell;
    const GridPoint at = subdivision_point(family, point);
    point = (point + 1) % subdivision_rays;
    return {board.view_vectors(at), at, {}, true};
  }

  RayMessage corner_ray(Cycle now) {
    const CornerRequest corner = board.corners.read(now);
    return {board.view_vectors(corner.point), corner.point, corner.tag, false};
  }
};

struct IntersectionUnit final : Box {
  IntersectionUnit(Board& its_board, std::size_t its_number) : Box(its_board), number(its_number) {}
  std::size_t number;

  Cycle fire(Cycle now) override {
    Fifo<SampleMessage>& results = board.has_shadow_units ? board.seen[number] : board.samples[number];
    if (!board.rays[number].readable(now) || !results.has_room()) return 0;
    const RayMessage ray = board.rays[number].read(now);
    Work work;
    const Sample sample = board.intersector->intersect(ray.view_vector, work);
    const Cycle busy = board.spec.intersection_cost.ray + cycles_of(work);
    const std::uint64_t shadow_rays = std::accumulate(work.shadow.rays.begin(), work.shadow.rays.end(), 0ULL);
    results.write(
        now, {sample, ray.tag, ray.subdivision, static_cast<std::uint32_t>(shadow_rays), cycles_of(work.shadow.tests)},
        busy - 1);
    return busy;
  }

  Cycle cycles_of(const Tests& tests) const {
    const IntersectionCost& cost = board.spec.intersection_cost;
    Cycle cycles = cost.box_test * tests.box_tests;
    for (std::size_t kind = 0; kind < surface_kinds; ++kind) {
      cycles += cost.surface_test[kind] * tests.surface_tests[kind];
    }
    return cycles;
  }
};

struct ShadowUnit final : Box {
  ShadowUnit(Board& its_board, std::size_t its_number) : Box(its_board), number(its_number) {}
  std::size_t number;

  Cycle fire(Cycle now) override {
    if (!board.has_shadow_units || !board.seen[number].readable(now) || !board.samples[number].has_room()) return 0;
    const SampleMessage sample = board.seen[number].read(now);
    const Cycle busy = 1 + board.spec.shadow_unit.ray * sample.shadow_rays + sample.shadow_tests;
    board.samples[number].write(now, sample, busy - 1);
    return busy;
  }
};

struct PyramidClassifier final : Box {
  using Box::Box;
  std::size_t turn = 0;     ///< the unit of the next sample, where there is no issue-order queue
  std::deque<Sample> row;   ///< the last N_z + 2 corners
  NodeMessage parent{};     ///< of the family under way
  std::size_t arrived = 0;  ///< of its samples; 0: no family is under way
  SubdivisionSamples middle{};

  Cycle fire(Cycle now) override {
    const bool fired = arrived == subdivision_rays ? last_subpixel(now) : next_sample(now);
    return fired ? board.spec.pyramid_classifier.interval : 0;
  }

  bool last_subpixel(Cycle now) {
    if (!classify_subpixel(now, 3)) return false;
    arrived = 0;
    return true;
  }

  bool next_sample(Cycle now) {
    if (board.has_issue_order_queue && !board.order.readable(now)) return false;
    Fifo<SampleMessage>& samples = board.samples[board.has_issue_order_queue ? board.order.head() : turn];
    if (!samples.readable(now)) return false;
    const SampleMessage& message = samples.head();
    if (!(message.subdivision ? family_sample(now, message.sample) : corner_sample(now, message))) return false;
    samples.read(now);
    if (board.has_issue_order_queue) board.order.read(now);
    turn = (turn + 1) % board.samples.size();
    return true;
  }

  bool corner_sample(Cycle now, const SampleMessage& message) {
    if (message.tag.pixel != no_pixel) {
      const PixelWindow& window = board.window;
      const auto pixel = static_cast<int>(message.tag.pixel);
      const GridPoint corner{static_cast<std::uint32_t>(window.row + pixel / window.columns) << board.max_level,
                             static_cast<std::uint32_t>(window.column + pixel % window.columns) << board.max_level};
      const CornerSamples corners{row[0], row[1], row.back(), message.sample};
      if (!classify_node(now, {{corner, static_cast<std::uint32_t>(board.max_level)}, message.tag, corners}))
        return false;
    }
    row.push_back(message.sample);
    if (row.size() > static_cast<std::size_t>(board.window.columns) + 2) row.pop_front();
    return true;
  }

  bool family_sample(Cycle now, const Sample& sample) {
    if (arrived == 0) {
      if (!board.parents.readable(now)) return false;
      parent = board.parents.read(now);
    }
    middle[arrived] = sample;
    if (arrived >= 2 && !classify_subpixel(now, arrived - 2)) return false;
    ++arrived;
    return true;
  }

  bool classify_subpixel(Cycle now, std::size_t child) {
    const Cell cell = subpixel(parent.cell, child);
    const bool closes_family = child == 3 && cell.log2_side > 0;
    const CornerSamples corners = subpixel_corners(parent.corners, middle, child);
    return classify_node(now, {cell, parent.tag, corners, false, closes_family});
  }

  bool classify_node(Cycle now, NodeMessage node) {
    node.subdivide = subdivides(classify(node.corners), node.cell);
    const bool to_controller = node.subdivide || node.closes_family;
    if (to_controller && !board.nodes.has_room()) return false;
    if (!node.subdivide && !board.terminals.has_room()) return false;
    if (to_controller) board.nodes.write(now, node);
    if (!node.subdivide) board.terminals.write(now, {node.cell, node.tag, node.corners, classify(node.corners)});
    return true;
  }
};

struct SubdivisionController final : Box {
  using Box::Box;
  std::vector<NodeMessage> subpixels;  ///< in the pool; the newest at the back
  std::deque<NodeMessage> pixels;      ///< the oldest at the front
  std::size_t reserved = 0;            ///< entries of the pool
  std::size_t of_family = 0;           ///< reserved for the family that comes back now, and not taken yet

  Cycle fire(Cycle now) override {
    if (board.nodes.readable(now)) {
      accept(board.nodes.read(now));
    } else if (can_issue()) {
      issue(now);
    } else {
      return 0;
    }
    return board.spec.subdivision_controller.interval;
  }

  void accept(const NodeMessage& node) {
    if (static_cast<int>(node.cell.log2_side) == board.max_level) {
      pixels.push_back(node);
      return;
    }
    if (of_family == 0) of_family = 4;  // families come back one after the other, each to its close
    if (node.subdivide) {
      subpixels.push_back(node);
      --reserved;
      --of_family;
    }
    if (node.closes_family) {
      reserved -= of_family;
      of_family = 0;
    }
  }

  const NodeMessage& next() const { return subpixels.empty() ? pixels.front() : subpixels.back(); }

  /// Levels below the node's subpixels that can hold nodes to split; -1: its subpixels cannot be split.
  static int levels_below(const NodeMessage& node) { return static_cast<int>(node.cell.log2_side) - 2; }

  bool can_issue() const {
    if (subpixels.empty() && pixels.empty()) return false;
    if (!board.requests.has_room() || !board.parents.has_room()) return false;
    const int below = levels_below(next());
    if (below < 0) return true;  // it reserves nothing
    const std::size_t tree = 3 * (static_cast<std::size_t>(below) + 1) + (subpixels.empty() ? 1 : 0);
    return subpixels.size() + reserved + tree <= board.spec.subdivision_pool;
  }

  void issue(Cycle now) {
    const NodeMessage node = next();
    board.requests.write(now, {node.cell});
    board.parents.write(now, node);
    if (levels_below(node) >= 0) reserved += 4;
    if (subpixels.empty()) {
      pixels.pop_front();
    } else {
      subpixels.pop_back();
    }
  }
};

/// What the colour is does not matter to the dates, but what its texture takes does.
struct ColorUnit final : Box {
  using Box::Box;

  Cycle fire(Cycle now) override {
    if (!board.terminals.readable(now) || !board.colors.has_room()) return 0;
    const TerminalMessage node = board.terminals.read(now);
    TextureWork work;
    board.palette.terminal_color(node.which, node.corners, EdgePolicy::mean, node.cell, work);
    const auto& [place, line, texel] = board.spec.texture_cost;
    const Cycle cost = place * work.places + line * work.lines + texel * work.texels;
    board.colors.write(now, {{}, node.tag, node.cell.log2_side}, cost);
    return board.spec.color_unit.interval + cost;
  }
};

struct TreeAccumulator final : Box {
  using Box::Box;
  std::map<std::uint32_t, std::uint64_t> area;  ///< summed so far, by slot, in squares of the grid

  Cycle fire(Cycle now) override {
    if (!board.colors.readable(now)) return 0;
    const ColorMessage& node = board.colors.head();
    const std::uint64_t sum = area[node.tag.slot] + (1ULL << 2 * node.log2_side);
    const bool complete = sum == 1ULL << 2 * board.max_level;
    if (complete && !(board.pixels.has_room() && board.slots.has_room())) return 0;
    area[node.tag.slot] = complete ? 0 : sum;
    if (complete) {
      board.pixels.write(now, {node.tag.pixel, {}});
      board.slots.write(now, {node.tag.slot});
    }
    board.colors.read(now);
    return board.spec.tree_accumulator.interval;
  }
};

struct FrameBuffer final : Box {
  using Box::Box;
  int missing = board.window.rows * board.window.columns;  ///< pixels not stored yet

  Cycle fire(Cycle now) override {
    if (!board.pixels.readable(now)) return 0;
    board.pixels.read(now);
    --missing;
    return board.spec.frame_buffer_interval;
  }
};

/// The FIFOs that the machine has, by name.
std::map<std::string, AnyFifo*> built_fifos(Board& board) {
  std::map<std::string, AnyFifo*> fifos{{"pixel_scan_to_view_vector_generator", &board.corners},
                                        {"pyramid_classifier_to_color_unit", &board.terminals},
                                        {"color_unit_to_tree_accumulator", &board.colors},
                                        {"tree_accumulator_to_frame_buffer", &board.pixels},
                                        {"tree_accumulator_to_pixel_scan", &board.slots}};
  for (std::size_t k = 0; k < board.rays.size(); ++k) {
    const std::string unit = "intersection_unit_" + std::to_string(k);
    fifos["view_vector_generator_to_" + unit] = &board.rays[k];
    const std::string shadow_unit = "shadow_unit_" + std::to_string(k);
    if (board.has_shadow_units) fifos[unit + "_to_" + shadow_unit] = &board.seen[k];
    fifos[(board.has_shadow_units ? shadow_unit : unit) + "_to_pyramid_classifier"] = &board.samples[k];
  }
  if (board.has_issue_order_queue) fifos["view_vector_generator_to_pyramid_classifier"] = &board.order;
  if (board.has_controller) {
    fifos["pyramid_classifier_to_subdivision_controller"] = &board.nodes;
    fifos["subdivision_controller_to_view_vector_generator"] = &board.requests;
    fifos["subdivision_controller_to_pyramid_classifier"] = &board.parents;
  }
  return fifos;
}

bool at_rest(const Board& board, const std::map<std::string, AnyFifo*>& fifos) {
  for (const auto& [name, fifo] : fifos) {
    if (fifo != &board.slots && !fifo->empty()) return false;
  }
  return true;
}

/// A light has shadows, and something casts them.
bool shadow_units_stand_in(const Scene& scene) {
  const auto casts = [](const Object& object) { return object.casts_shadow; };
  return scene.lights && std::any_of(scene.lights->begin(), scene.lights->end(), casts_shadows) &&
         std::any_of(scene.objects.begin(), scene.objects.end(), casts);
}

}  // namespace

Timeline run_cycle_loop(const Scene& scene, const MachineSpec& spec, int max_level, const DatapathFormats& formats) {
  constexpr Cycle patience = 1'000'000;  // more than any firing takes
  Board board{spec,
              scene.camera.rendered(),
              max_level,
              ViewVectors(scene.camera.screen, std::int64_t{1} << max_level, formats.view_vectors),
              make_intersector(scene, formats.intersection),
              max_level > 0 && !scene.objects.empty(),
              shadow_units_stand_in(scene),
              Palette(scene, std::int64_t{1} << max_level)};
  for (std::uint32_t slot = 0; slot < spec.pixels_in_flight; ++slot) board.slots.preload({slot});
  PixelScan scan(board);
  ViewVectorGenerator generator(board);
  PyramidClassifier classifier(board);
  SubdivisionController controller(board);
  ColorUnit color_unit(board);
  TreeAccumulator accumulator(board);
  FrameBuffer frame_buffer(board);
  std::deque<IntersectionUnit> units;
  std::deque<ShadowUnit> shadow_units;
  for (std::size_t k = 0; k < spec.intersection_units; ++k) {
    units.emplace_back(board, k);
    shadow_units.emplace_back(board, k);
  }
  std::vector<Box*> boxes{&scan, &generator, &classifier, &controller, &color_unit, &accumulator, &frame_buffer};
  for (IntersectionUnit& unit : units) boxes.push_back(&unit);
  for (ShadowUnit& unit : shadow_units) boxes.push_back(&unit);
  const std::map<std::string, AnyFifo*> fifos = built_fifos(board);

  Timeline timeline;
  for (Cycle now = 0; frame_buffer.missing > 0 || !at_rest(board, fifos); ++now) {
    for (Box* box : boxes) {
      if (now < box->busy_until) continue;
      if (const Cycle busy = box->fire(now); busy > 0) box->busy_until = now + busy;
      timeline.cycles = std::max(timeline.cycles, box->busy_until);
    }
    for (const auto& [name, fifo] : fifos) fifo->take_effect();
    if (now > timeline.cycles + patience) throw std::logic_error("the cycle loop stands still");
  }
  for (const auto& [name, fifo] : fifos) timeline.fifos[name] = fifo->dates;
  return timeline;
}

}  // namespace pyrasim::hw
