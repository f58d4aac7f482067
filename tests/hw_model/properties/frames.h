// SPDX-License-Identifier: Apache-2.0
// Frames that are run for their dates, and what a property says of dates.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "../../test_scenes.h"
#include "../cycle_loop.h"
#include "../machines.h"
#include "scene/scene.h"

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
std::vector<Dated> dates_of(const std::vector<Frame>& frames);

/// A small frame with edges, whose trees go deep and whose rays cost differently.
Scene scene_with_edges();

/// The shortest that a token stayed from its write to its read; `preloaded` tokens come before the first write.
Cycle shortest_stay(const FifoDates& dates, std::size_t preloaded = 0);

std::vector<Cycle> gaps(const std::vector<Cycle>& dates);

/// Every gap is `interval`, and there are some.
void expect_gaps(const std::vector<Cycle>& dates, Cycle interval);

Cycle least_gap(const std::vector<Cycle>& dates);

/// Dates at which the n-th cell that is written again had been read, plus 1: what the writer had to wait for at least.
std::vector<Cycle> freed(const FifoDates& dates, std::size_t depth);
std::vector<Cycle> rewritten(const FifoDates& dates, std::size_t depth);

/// A writer of interval 1 that has work all the time writes each cell again in the very cycle after its read, or after
/// its own last write; it mostly waits for the reader.
void expect_writes_as_soon_as_freed(const FifoDates& dates, std::size_t depth);

std::vector<Cycle> merged(std::vector<Cycle> a, const std::vector<Cycle>& b);

/// A ray on its way: where it went, and when it was sent, taken up by its unit, and read by the classifier as a sample.
struct RayDates {
  std::size_t unit;
  std::size_t nth;  ///< of its unit's
  Cycle sent;
  Cycle started;
  Cycle classified;
};

std::string rays_to(std::size_t unit);
std::string samples_of(std::size_t unit);

/// All rays, in the order in which the generator sent them.
std::vector<RayDates> rays_in_order(const Dated& frame);
std::vector<Cycle> sent_dates(const Dated& frame);

/// From when on the FIFO has room for its `n`-th token.
Cycle room_for(const FifoDates& dates, std::size_t n, std::size_t depth);

}  // namespace pyrasim::hw
