// SPDX-License-Identifier: Apache-2.0
#include "frames.h"

#include <algorithm>
#include <deque>

#include "../simulation.h"
#include "../timeline.h"

namespace pyrasim::hw {

std::vector<Dated> dates_of(const std::vector<Frame>& frames) {
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

Scene scene_with_edges() { return random_scene(21, {12, 12, 0}, 8, 6); }

Cycle shortest_stay(const FifoDates& dates, std::size_t preloaded) {
  Cycle least = never;
  for (std::size_t k = 0; k + preloaded < dates.reads.size(); ++k) {
    least = std::min(least, dates.reads[k + preloaded] - dates.writes[k]);
  }
  return least;
}

std::vector<Cycle> gaps(const std::vector<Cycle>& dates) {
  std::vector<Cycle> result;
  for (std::size_t k = 1; k < dates.size(); ++k) result.push_back(dates[k] - dates[k - 1]);
  return result;
}

void expect_gaps(const std::vector<Cycle>& dates, Cycle interval) {
  ASSERT_GT(dates.size(), 4U);
  EXPECT_EQ(gaps(dates), std::vector<Cycle>(dates.size() - 1, interval));
}

Cycle least_gap(const std::vector<Cycle>& dates) {
  const std::vector<Cycle> all = gaps(dates);
  return all.empty() ? never : *std::min_element(all.begin(), all.end());
}

std::vector<Cycle> freed(const FifoDates& dates, std::size_t depth) {
  std::vector<Cycle> result;
  for (std::size_t n = 0; n + depth < dates.writes.size(); ++n) result.push_back(dates.reads[n] + 1);
  return result;
}

std::vector<Cycle> rewritten(const FifoDates& dates, std::size_t depth) {
  if (dates.writes.size() <= depth) return {};
  return {dates.writes.begin() + static_cast<std::ptrdiff_t>(depth), dates.writes.end()};
}

void expect_writes_as_soon_as_freed(const FifoDates& dates, std::size_t depth) {
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

std::vector<Cycle> merged(std::vector<Cycle> a, const std::vector<Cycle>& b) {
  a.insert(a.end(), b.begin(), b.end());
  std::sort(a.begin(), a.end());
  return a;
}

std::string rays_to(std::size_t unit) { return "view_vector_generator_to_intersection_unit_" + std::to_string(unit); }

std::string samples_of(std::size_t unit) {
  return "intersection_unit_" + std::to_string(unit) + "_to_pyramid_classifier";
}

std::vector<RayDates> rays_in_order(const Dated& frame) {
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

std::vector<Cycle> sent_dates(const Dated& frame) {
  std::vector<Cycle> dates;
  for (const RayDates& ray : rays_in_order(frame)) dates.push_back(ray.sent);
  return dates;
}

Cycle room_for(const FifoDates& dates, std::size_t n, std::size_t depth) {
  return n < depth ? 0 : dates.reads[n - depth] + 1;
}

}  // namespace pyrasim::hw
