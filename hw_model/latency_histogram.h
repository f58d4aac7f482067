// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <numeric>

#include "hw_model/cycle.h"

namespace pyrasim::hw {

/// How often each latency occurred, in bounded space: exact below 32 cycles, else in classes of 1/16 of a power of two,
/// so that a percentile is at most 1/16 too large.
class LatencyHistogram {
 public:
  void add(Cycle latency) {
    ++counts_[class_of(latency)];
    sum_ += latency;
    max_ = std::max(max_, latency);
  }

  std::uint64_t count() const { return std::accumulate(counts_.begin(), counts_.end(), std::uint64_t{0}); }
  double mean() const { return count() == 0 ? 0 : static_cast<double>(sum_) / static_cast<double>(count()); }
  Cycle max() const { return max_; }

  /// The least latency known to be reached or undercut by `share` (0 to 1] of all, in cycles; 0 where there are none.
  Cycle percentile(double share) const {
    const double wanted = share * static_cast<double>(count());
    std::uint64_t seen = 0;
    for (std::size_t k = 0; k < classes; ++k) {
      seen += counts_[k];
      if (seen > 0 && static_cast<double>(seen) >= wanted) return std::min(last_of(k), max_);
    }
    return max_;
  }

  /// Calls `visit(last, count)` for every class that is not empty: `count` latencies up to `last`, above the class
  /// before.
  template <class Visit>
  void for_each_class(const Visit& visit) const {
    for (std::size_t k = 0; k < classes; ++k) {
      if (counts_[k] > 0) visit(last_of(k), counts_[k]);
    }
  }

  LatencyHistogram& operator+=(const LatencyHistogram& other) {
    for (std::size_t k = 0; k < classes; ++k) counts_[k] += other.counts_[k];
    sum_ += other.sum_;
    max_ = std::max(max_, other.max_);
    return *this;
  }
  friend bool operator==(const LatencyHistogram&, const LatencyHistogram&) = default;

 private:
  static constexpr int fine_bits = 4;
  static constexpr std::size_t classes = std::size_t{64 - fine_bits + 1} << fine_bits;

  /// The leading bit and the `fine_bits` below it.
  static std::size_t class_of(Cycle latency) {
    const int octave = static_cast<int>(std::bit_width(latency | Cycle{1} << fine_bits)) - 1 - fine_bits;
    return (static_cast<std::size_t>(octave) << fine_bits) + static_cast<std::size_t>(latency >> octave);
  }
  static Cycle last_of(std::size_t k) {
    const std::size_t octave = k < (std::size_t{2} << fine_bits) ? 0 : (k >> fine_bits) - 1;
    return ((k - (octave << fine_bits) + 1) << octave) - 1;
  }

  std::array<std::uint64_t, classes> counts_{};
  Cycle sum_ = 0;
  Cycle max_ = 0;
};

}  // namespace pyrasim::hw
