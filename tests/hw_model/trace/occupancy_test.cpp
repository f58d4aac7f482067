// SPDX-License-Identifier: Apache-2.0
#include "hw_model/trace/occupancy.h"

#include <gtest/gtest.h>

#include <optional>
#include <random>

#include "hw_model/fifo/fifo.h"

namespace pyrasim::hw {
namespace {

struct Traffic {
  std::size_t depth;
  std::size_t preloaded;
  std::size_t tokens;
  Cycle pause;  ///< the longest between two writes or two reads
};

/// Random traffic through a FIFO, in an order of calls that lets either end run ahead; counts by brute force.
class CountedFifo {
 public:
  CountedFifo(const Traffic& traffic, std::uint64_t seed)
      : random_(seed), fifo_(sc_core::sc_gen_unique_name("fifo"), traffic.depth) {
    for (std::size_t k = 0; k < traffic.preloaded; ++k) {
      fifo_.preload(0);
      writes_.push_back(0);
    }
    occupancy_.emplace(traffic.preloaded);
    std::size_t left = traffic.tokens;
    while (left > 0) {
      const std::uint64_t steps = 1 + random_() % traffic.depth;
      const bool writes = random_() % 2 == 0;
      for (std::uint64_t k = 0; k < steps && left > 0; ++k) {
        if (writes && !fifo_.full()) {
          write(traffic.pause);
          --left;
        } else if (!writes && !fifo_.empty()) {
          read(traffic.pause);
        }
      }
    }
    occupancy_->end_frame(cycles());
  }

  const Occupancy& occupancy() const { return *occupancy_; }
  Cycle cycles() const { return std::max(last_write_, last_read_) + 1; }
  /// A token counts from the cycle of its write to that of its read, both included.
  std::size_t tokens_at(Cycle at) const {
    std::size_t tokens = 0;
    for (std::size_t k = 0; k < writes_.size(); ++k) {
      if (writes_[k] <= at && (k >= reads_.size() || at <= reads_[k])) ++tokens;
    }
    return tokens;
  }

 private:
  void write(Cycle pause) {
    last_write_ = std::max(last_write_ + 1 + random_() % pause, fifo_.room_at());
    fifo_.write(0, last_write_, 1 + random_() % 3);
    occupancy_->write(last_write_);
    writes_.push_back(last_write_);
  }
  void read(Cycle pause) {
    last_read_ = std::max(last_read_ + 1 + random_() % pause, fifo_.token_at());
    fifo_.read(last_read_);
    occupancy_->read(last_read_);
    reads_.push_back(last_read_);
  }

  std::mt19937_64 random_;
  Fifo<int> fifo_;
  std::optional<Occupancy> occupancy_;
  Cycle last_write_ = 0;
  Cycle last_read_ = 0;
  std::vector<Cycle> writes_;
  std::vector<Cycle> reads_;
};

void expect_counts(const CountedFifo& fifo) {
  const std::vector<std::size_t> points = fifo.occupancy().points(fifo.cycles());
  for (std::size_t k = 0; k < points.size(); ++k) {
    ASSERT_EQ(points[k], fifo.tokens_at(k * fifo.occupancy().stride())) << "point " << k;
  }
}

TEST(Occupancy, OfAShortFrameIsTheCountOfEveryCycle) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const CountedFifo fifo({1 + seed % 9, 0, 20, 4}, seed);
    ASSERT_LT(fifo.cycles(), Occupancy::most_points);
    EXPECT_EQ(fifo.occupancy().stride(), 1U);
    EXPECT_EQ(fifo.occupancy().points(fifo.cycles()).size(), fifo.cycles());
    expect_counts(fifo);
  }
}

TEST(Occupancy, OfALongFrameIsTheCountOfTheCyclesThatAreLeft) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) expect_counts(CountedFifo({1 + seed, 0, 3000, 1 + seed}, seed));
}

TEST(Occupancy, KeepsAtMost256PointsAndHalfOfThemAtLeast) {
  for (const std::size_t tokens : {300, 1000, 5000, 20'000}) {
    const CountedFifo fifo({16, 0, tokens, 3}, tokens);
    const std::size_t points = fifo.occupancy().points(fifo.cycles()).size();
    EXPECT_LE(points, Occupancy::most_points);
    EXPECT_GE(points, Occupancy::most_points / 2);
    EXPECT_EQ(points, (fifo.cycles() + fifo.occupancy().stride() - 1) / fifo.occupancy().stride());
  }
}

TEST(Occupancy, CountsTokensThatWereThereBefore) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const CountedFifo fifo({8, 8, seed * 30, 5}, seed);
    EXPECT_EQ(fifo.occupancy().points(1), std::vector<std::size_t>{8});
    expect_counts(fifo);
  }
}

/// Long after the last token, points go on with what is left.
TEST(Occupancy, GoesOnToTheEndOfTheFrame) {
  Occupancy occupancy(0);
  occupancy.write(3);
  occupancy.write(5);
  occupancy.read(6);
  EXPECT_EQ(occupancy.points(10), (std::vector<std::size_t>{0, 0, 0, 1, 1, 2, 2, 1, 1, 1}));
}

TEST(Occupancy, ReachesToTheEndOfALongFrameWhoseTrafficIsOverEarly) {
  for (const Cycle cycles : {256, 257, 512, 513, 100'000}) {
    Occupancy occupancy(0);
    occupancy.write(0);
    occupancy.write(100);
    occupancy.read(200);
    occupancy.end_frame(cycles);
    const std::vector<std::size_t> points = occupancy.points(cycles);
    EXPECT_LE(points.size(), Occupancy::most_points);
    EXPECT_EQ(points.size(), (cycles + occupancy.stride() - 1) / occupancy.stride());
    for (std::size_t k = 0; k < points.size(); ++k) {
      const Cycle at = k * occupancy.stride();
      EXPECT_EQ(points[k], at >= 100 && at <= 200 ? 2U : 1U) << at << " of " << cycles;
    }
  }
}

}  // namespace
}  // namespace pyrasim::hw
