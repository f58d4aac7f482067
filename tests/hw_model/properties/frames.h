// SPDX-License-Identifier: Apache-2.0
// Frames that are run for their dates, and what a property says of dates.
#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <string>
#include <vector>

#include "../../test_scenes.h"
#include "../simulation.h"
#include "../timeline.h"

namespace pyrasim::hw {

struct Frame {
  Scene scene;
  MachineSpec spec;
  int max_level = 0;
};

/// The dates of a frame in one engine.
struct Dated {
  MachineSpec spec;
  std::string name;  ///< of frame and engine, for messages
  Timeline timeline;

  const FifoDates& fifo(const std::string& fifo_name) const { return timeline.fifos.at(fifo_name); }
};

/// Runs every frame in both engines; once a process.
inline std::vector<Dated> dates_of(const std::vector<Frame>& frames) {
  Simulation simulation;
  std::deque<TimelineRecorder> recorders;
  std::vector<Dated> all;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    for (const Engine engine : {Engine::decoupled, Engine::lockstep}) {
      SimulationOptions options;
      options.max_level = frames[k].max_level;
      options.engine = engine;
      recorders.emplace_back(simulation.add(frames[k].scene, frames[k].spec, options));
      all.push_back({frames[k].spec,
                     "frame " + std::to_string(k) + (engine == Engine::decoupled ? ", decoupled" : ", lockstep"),
                     {}});
    }
  }
  simulation.run();
  for (std::size_t k = 0; k < all.size(); ++k) all[k].timeline = recorders[k].timeline();
  return all;
}

/// A small frame with edges, whose trees go deep and whose rays cost differently.
inline Scene scene_with_edges() { return random_scene(21, {12, 12, 0}, 8, 6); }

/// The shortest that a token stayed from its write to its read; `preloaded` tokens come before the first write.
inline Cycle shortest_stay(const FifoDates& dates, std::size_t preloaded = 0) {
  Cycle least = never;
  for (std::size_t k = 0; k + preloaded < dates.reads.size(); ++k) {
    least = std::min(least, dates.reads[k + preloaded] - dates.writes[k]);
  }
  return least;
}

inline std::vector<Cycle> gaps(const std::vector<Cycle>& dates) {
  std::vector<Cycle> result;
  for (std::size_t k = 1; k < dates.size(); ++k) result.push_back(dates[k] - dates[k - 1]);
  return result;
}

/// Every gap is `interval`, and there are some.
inline void expect_gaps(const std::vector<Cycle>& dates, Cycle interval) {
  ASSERT_GT(dates.size(), 4U);
  EXPECT_EQ(gaps(dates), std::vector<Cycle>(dates.size() - 1, interval));
}

inline Cycle least_gap(const std::vector<Cycle>& dates) {
  const std::vector<Cycle> all = gaps(dates);
  return all.empty() ? never : *std::min_element(all.begin(), all.end());
}

/// Dates at which the n-th cell that is written again had been read, plus 1: what the writer had to wait for at least.
inline std::vector<Cycle> freed(const FifoDates& dates, std::size_t depth) {
  std::vector<Cycle> result;
  for (std::size_t n = 0; n + depth < dates.writes.size(); ++n) result.push_back(dates.reads[n] + 1);
  return result;
}
inline std::vector<Cycle> rewritten(const FifoDates& dates, std::size_t depth) {
  if (dates.writes.size() <= depth) return {};
  return {dates.writes.begin() + static_cast<std::ptrdiff_t>(depth), dates.writes.end()};
}

/// A writer of interval 1 that has work all the time writes each cell again in the very cycle after its read, or after
/// its own last write; it mostly waits for the reader.
inline void expect_writes_as_soon_as_freed(const FifoDates& dates, std::size_t depth) {
  ASSERT_GT(dates.writes.size(), depth + 4);
  const std::vector<Cycle> least = freed(dates, depth);
  std::size_t waits = 0;
  for (std::size_t n = 0; n < least.size(); ++n) {
    const Cycle ready = dates.writes[n + depth - 1] + 1;
    ASSERT_EQ(dates.writes[n + depth], std::max(least[n], ready)) << "write " << n + depth;
    if (least[n] > ready) ++waits;
  }
  EXPECT_GT(waits, least.size() / 2);
}

inline std::vector<Cycle> merged(std::vector<Cycle> a, const std::vector<Cycle>& b) {
  a.insert(a.end(), b.begin(), b.end());
  std::sort(a.begin(), a.end());
  return a;
}

/// A ray on its way: where it went, and when it was sent, taken up by its unit, and read by the classifier as a sample.
struct RayDates {
  std::size_t unit;
  std::size_t nth;  ///< of its unit's
  Cycle sent;
  Cycle started;
  Cycle classified;
};

inline std::string rays_to(std::size_t unit) {
  return "view_vector_generator_to_intersection_unit_" + std::to_string(unit);
}
inline std::string samples_of(std::size_t unit) {
  return "intersection_unit_" + std::to_string(unit) + "_to_pyramid_classifier";
}

/// All rays, in the order in which the generator sent them.
inline std::vector<RayDates> rays_in_order(const Dated& frame) {
  std::vector<RayDates> rays;
  for (std::size_t unit = 0; unit < frame.spec.intersection_units; ++unit) {
    const FifoDates& to = frame.fifo(rays_to(unit));
    for (std::size_t k = 0; k < to.writes.size(); ++k) {
      rays.push_back({unit, k, to.writes[k], to.reads[k], frame.fifo(samples_of(unit)).reads[k]});
    }
  }
  std::sort(rays.begin(), rays.end(), [](const RayDates& a, const RayDates& b) { return a.sent < b.sent; });
  return rays;
}
inline std::vector<Cycle> sent_dates(const Dated& frame) {
  std::vector<Cycle> dates;
  for (const RayDates& ray : rays_in_order(frame)) dates.push_back(ray.sent);
  return dates;
}

/// From when on the FIFO has room for its `n`-th token.
inline Cycle room_for(const FifoDates& dates, std::size_t n, std::size_t depth) {
  return n < depth ? 0 : dates.reads[n - depth] + 1;
}

}  // namespace pyrasim::hw
