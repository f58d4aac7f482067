// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "camera/view_vector.h"
#include "raster/sample.h"

namespace pyrasim {

/// Samples already traced, by grid point: an open-addressing hash table whose clear() costs nothing.
class SampleCache {
 public:
  void clear() {
    ++epoch_;
    size_ = 0;
  }

  /// The sample kept for `point`, and whether it is new: then the caller has to fill it in. Valid until the next call.
  std::pair<Sample*, bool> insert(GridPoint point) {
    if (2 * size_ >= entries_.size()) grow();
    Entry& entry = slot(point);
    if (entry.epoch == epoch_) return {&entry.sample, false};
    entry.point = point;
    entry.epoch = epoch_;
    ++size_;
    return {&entry.sample, true};
  }

 private:
  struct Entry {
    GridPoint point;
    std::uint32_t epoch = 0;
    Sample sample;
  };

  Entry& slot(GridPoint point) {
    const std::uint64_t key = (static_cast<std::uint64_t>(point.row) << 32U) | point.column;
    std::size_t k = static_cast<std::size_t>((key * 0x9E3779B97F4A7C15ULL) >> 20U) & (entries_.size() - 1);
    while (entries_[k].epoch == epoch_ && !(entries_[k].point == point)) k = (k + 1) & (entries_.size() - 1);
    return entries_[k];
  }

  void grow() {
    std::vector<Entry> old(entries_.empty() ? 64 : 2 * entries_.size());
    old.swap(entries_);
    for (const Entry& entry : old) {
      if (entry.epoch == epoch_) slot(entry.point) = entry;
    }
  }

  std::vector<Entry> entries_;  ///< a power of two of them, at most half in use
  std::uint32_t epoch_ = 1;     ///< entries of other epochs are free
  std::size_t size_ = 0;
};

}  // namespace pyrasim
