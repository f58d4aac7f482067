// SPDX-License-Identifier: Apache-2.0
// What a run came to, as plain data: tables, documents and rows are made from it and the Run alone.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hw_model/fifo/fifo_statistics.h"
#include "hw_model/processor.h"
#include "hw_model/report/bottleneck.h"
#include "hw_model/stage/stage_statistics.h"
#include "render/frame_statistics.h"
#include "study/decision_flips.h"

namespace pyrasim {

/// Cycles that a unit waited for one FIFO.
struct WaitAccount {
  std::string fifo;
  bool starved = false;  ///< for a token from it; else for room in it
  hw::Cycle cycles = 0;
  friend bool operator==(const WaitAccount&, const WaitAccount&) = default;
};

/// Where a unit's cycles went.
struct UnitAccount {
  std::string name;
  std::string box;  ///< that it is, or is one of
  hw::StageStatistics cycles;
  std::vector<WaitAccount> waits;  ///< the longest first; their sum is starved + blocked
  friend bool operator==(const UnitAccount&, const UnitAccount&) = default;
};

/// How full a FIFO was over time: at the cycles 0, stride, 2 stride ...
struct OccupancyAccount {
  hw::Cycle stride = 0;
  std::vector<std::size_t> tokens;
  friend bool operator==(const OccupancyAccount&, const OccupancyAccount&) = default;
};

struct FifoAccount {
  std::string name;
  hw::FifoStatistics use;
  OccupancyAccount occupancy;  ///< empty where nobody asked for it
  friend bool operator==(const FifoAccount&, const FifoAccount&) = default;
};

/// Cycles of the frame's critical path that are owed to one place.
struct PathAccount {
  std::string owed;   ///< of hw::owed_names
  std::string place;  ///< a unit; of room a FIFO
  hw::Cycle cycles = 0;
  friend bool operator==(const PathAccount&, const PathAccount&) = default;
};

/// How long pixels took from their first ray on, in cycles.
struct LatencyAccount {
  struct Class {
    hw::Cycle up_to = 0;  ///< above the class before
    std::uint64_t pixels = 0;
    friend bool operator==(const Class&, const Class&) = default;
  };
  std::uint64_t pixels = 0;
  double mean = 0;
  hw::Cycle p50 = 0;
  hw::Cycle p90 = 0;
  hw::Cycle p99 = 0;
  hw::Cycle max = 0;
  std::vector<Class> classes;  ///< that are not empty
  friend bool operator==(const LatencyAccount&, const LatencyAccount&) = default;
};

/// One of the pixels that took longest.
struct SlowPixel {
  int row = 0;     ///< of the screen
  int column = 0;  ///< of the screen
  hw::Cycle cycles = 0;
  std::uint32_t level = 0;  ///< the deepest in its tree
  friend bool operator==(const SlowPixel&, const SlowPixel&) = default;
};

/// Against a reference picture, in linear RGB.
struct ReferenceError {
  double rmse = 0;
  double maximum = 0;
  std::uint64_t rays = 0;  ///< that the reference took
  friend bool operator==(const ReferenceError&, const ReferenceError&) = default;
};

/// Against the same frame in double.
struct FormatError {
  std::uint64_t changed_pixels = 0;  ///< in the picture of 8 bits, sRGB
  double psnr = 0;                   ///< dB, of linear RGB with a peak of 1; infinite for equal pictures
  DecisionFlips flips;
  friend bool operator==(const FormatError&, const FormatError&) = default;
};

struct Outcome {
  std::string unfinished;  ///< why the frame is not finished, in lines; then nothing else is known
  FrameStatistics counts;
  hw::Cycle cycles = 0;
  std::string image_sha256;
  std::vector<UnitAccount> units;      ///< in data-flow order, of what was built
  std::vector<hw::MachinePart> parts;  ///< boxes and their parts, built or not
  std::vector<FifoAccount> fifos;
  std::vector<hw::BottleneckLink> bottleneck;
  hw::LowerBound lower_bound{};
  std::vector<PathAccount> critical_path;  ///< the most cycles first; empty where nobody asked for it
  LatencyAccount latency;
  std::vector<LatencyAccount> latency_by_level;  ///< of the deepest level in a pixel's tree
  std::vector<SlowPixel> slowest;                ///< the slowest first
  std::optional<ReferenceError> error;
  std::optional<FormatError> format_error;
  double host_seconds = 0;  ///< that the simulation took; no result depends on it

  friend bool operator==(const Outcome&, const Outcome&) = default;
};

/// Throws LimitError where the frame is not finished.
void require_finished(const Outcome& outcome);

}  // namespace pyrasim
