// SPDX-License-Identifier: Apache-2.0
// The settings of a machine: what a machine file says, with defaults filled in and checked.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hw_model/cycle.h"
#include "intersect/work.h"
#include "json/json_reader.h"
#include "texture/texture_work.h"

namespace pyrasim::hw {

/// The timing of one stage, in cycles; both at least 1.
struct StageTiming {
  Cycle latency = 1;   ///< from a firing to its result being visible to the reader
  Cycle interval = 1;  ///< from a firing to the next (initiation interval)
  friend bool operator==(const StageTiming&, const StageTiming&) = default;
};

inline std::array<Cycle, surface_kinds> default_surface_test() {
  std::array<Cycle, surface_kinds> cycles{};
  std::transform(surface_traits.begin(), surface_traits.end(), cycles.begin(),
                 [](const SurfaceTraits& traits) { return traits.default_cost; });
  return cycles;
}

/// What a ray costs an intersection unit, in cycles: the unit is occupied for the sum over the ray's work.
struct IntersectionCost {
  Cycle ray = 1;  ///< for every ray
  Cycle box_test = 1;
  std::array<Cycle, surface_kinds> surface_test = default_surface_test();  ///< by SurfaceKind
  friend bool operator==(const IntersectionCost&, const IntersectionCost&) = default;
};

/// In cycles, of all of `tests`.
inline Cycle cost_of(const Tests& tests, const IntersectionCost& cost) {
  Cycle cycles = cost.box_test * tests.box_tests;
  for (std::size_t kind = 0; kind < surface_kinds; ++kind) {
    cycles += cost.surface_test[kind] * tests.surface_tests[kind];
  }
  return cycles;
}

/// Of a shadow unit, in cycles. A sample occupies it for 1, `ray` for each shadow ray, and their tests, which cost what
/// an intersection unit's do.
struct ShadowTiming {
  Cycle latency = 8;  ///< as that of intersection units
  Cycle ray = 1;
  friend bool operator==(const ShadowTiming&, const ShadowTiming&) = default;
};

/// Of the colour unit's texture part, in cycles beside its interval.
struct TextureCost {
  Cycle place = 2;  ///< for each ray whose place on the texture is worked out
  Cycle line = 1;   ///< for each step of a pattern's integral
  Cycle texel = 2;  ///< for each of a picture's
  friend bool operator==(const TextureCost&, const TextureCost&) = default;
};
inline Cycle cost_of(const TextureWork& work, const TextureCost& cost) {
  return cost.place * work.places + cost.line * work.lines + cost.texel * work.texels;
}

/// Which intersection unit gets the next ray.
enum class Dispatch : std::uint8_t {
  round_robin,  ///< each in turn
  first_free,   ///< the first that has room, counting on from the last; the issue-order queue restores the order
};
inline constexpr std::array<std::pair<std::string_view, Dispatch>, 2> dispatch_names{
    {{"round_robin", Dispatch::round_robin}, {"first_free", Dispatch::first_free}}};

/// Depths of the FIFOs, in tokens: one name for each kind of arrow in the block diagram.
struct FifoDepths {
  std::size_t pixel_scan_to_view_vector_generator = 4;
  std::size_t view_vector_generator_to_intersection_unit = 8;
  std::size_t intersection_unit_to_pyramid_classifier = 8;
  std::size_t intersection_unit_to_shadow_unit = 8;
  std::size_t shadow_unit_to_pyramid_classifier = 8;
  std::size_t pyramid_classifier_to_subdivision_controller = 8;
  std::size_t subdivision_controller_to_view_vector_generator = 8;
  std::size_t subdivision_controller_to_pyramid_classifier = 32;
  std::size_t pyramid_classifier_to_color_unit = 8;
  std::size_t color_unit_to_tree_accumulator = 8;
  std::size_t tree_accumulator_to_frame_buffer = 8;
  friend bool operator==(const FifoDepths&, const FifoDepths&) = default;
};

/// A machine. Immutable once loaded; see docs/machine.md for what each number means.
struct MachineSpec {
  std::string name = "default";
  std::size_t overridden = 0;  ///< settings that --set gave another value than the file's
  double clock_mhz = 200;
  double goal_fps = 30;  ///< the frame rate that makes the cycle budget
  StageTiming pixel_scan;
  StageTiming view_vector_generator{.latency = 4};
  std::size_t intersection_units = 4;
  Dispatch dispatch = Dispatch::round_robin;
  std::size_t issue_order_queue = 32;  ///< rays under way between generator and classifier under first_free
  Cycle intersection_latency = 8;      ///< a result can be read from the end of its ray's occupancy on, plus this - 1
  IntersectionCost intersection_cost;
  ShadowTiming shadow_unit;
  StageTiming pyramid_classifier{.latency = 2};
  std::size_t line_buffer = 65'537;  ///< corner samples that the classifier can hold: a row and one more
  StageTiming subdivision_controller{.latency = 2};
  std::size_t subdivision_pool = 64;  ///< subpixels that the controller can hold for subdivision
  StageTiming color_unit;
  TextureCost texture_cost;
  StageTiming tree_accumulator{.latency = 2};
  std::size_t pixels_in_flight = 256;  ///< trace trees that the accumulator can sum at once
  Cycle frame_buffer_interval = 1;
  FifoDepths fifos;

  /// Cycles that a frame may take at the goal's frame rate.
  Cycle budget() const { return static_cast<Cycle>(clock_mhz * 1e6 / goal_fps); }
  /// "default", "default + 1 setting", "default + 2 settings" ...
  std::string title() const;
  friend bool operator==(const MachineSpec&, const MachineSpec&) = default;
};

/// The least `subdivision_pool` that cannot deadlock: one pixel's tree, released depth first, holds at most
/// 3 (MAX_LEVEL - 1) + 1 pending subpixels. 0 up to MAX_LEVEL 1, where no subpixel is subdivided.
constexpr std::size_t required_pool(int max_level) {
  return max_level < 2 ? 0 : 3 * (static_cast<std::size_t>(max_level) - 1) + 1;
}

/// Reads a machine, as a machine file says it; it has the name that it says, or its file's. Throws InputError with the
/// JSON pointer.
MachineSpec read_machine(const JsonReader& root);
/// Reads a machine file's `document`; `file` is its name in messages. Throws InputError with the JSON pointer.
MachineSpec read_machine(const std::string& file, const nlohmann::json& document);

/// Reads `file`, or takes the default machine where there is none, applies `overrides` ("intersection.units=4", as
/// --set gives them), and validates. Throws InputError for the file (with the JSON pointer), UsageError for an
/// override.
MachineSpec load_machine(const std::optional<std::filesystem::path>& file,
                         const std::vector<std::string>& overrides = {});

/// Throws InputError where the machine cannot hold one pixel's tree of `max_level`, or a row of `columns` pixels.
void check_machine_holds(const MachineSpec& spec, int max_level, int columns);

}  // namespace pyrasim::hw
