// SPDX-License-Identifier: Apache-2.0
#include "hw_model/trace/occupancy.h"

namespace pyrasim::hw {

/// What changes at `at` shows at the first point not earlier.
std::int64_t& Occupancy::change_from(Cycle at) {
  const auto point = [&] { return static_cast<std::size_t>((at + stride() - 1) >> shift_); };
  while (point() >= most_points) drop_every_other();
  if (point() >= changes_.size()) changes_.resize(point() + 1);
  return changes_[point()];
}

void Occupancy::drop_every_other() {
  for (std::size_t k = 1; k < changes_.size(); ++k) {
    const std::int64_t change = changes_[k];
    changes_[k] = 0;
    changes_[(k + 1) / 2] += change;
  }
  ++shift_;
}

void Occupancy::end_frame(Cycle cycles) {
  while (most_points * stride() < cycles) drop_every_other();
}

std::vector<std::size_t> Occupancy::points(Cycle cycles) const {
  std::vector<std::size_t> points;
  std::int64_t tokens = present_;
  for (std::size_t k = 0; k < most_points && k * stride() < cycles; ++k) {
    if (k < changes_.size()) tokens += changes_[k];
    points.push_back(static_cast<std::size_t>(tokens));
  }
  return points;
}

}  // namespace pyrasim::hw
