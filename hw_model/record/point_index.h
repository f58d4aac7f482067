// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "raster/grid_point.h"

namespace pyrasim::hw {

/// Numbers by grid point.
class PointIndex {
 public:
  /// For so many points at most.
  explicit PointIndex(std::size_t points)
      : shift_(64 - std::countr_zero(std::bit_ceil(2 * points + 2))), places_(std::size_t{1} << (64 - shift_)) {}

  /// Of a point that is there already the number is replaced.
  void set(GridPoint point, std::uint32_t number) { places_[place_of(point)] = {point, number}; }

  std::optional<std::uint32_t> find(GridPoint point) const {
    const Place& place = places_[place_of(point)];
    return place.number == nothing ? std::nullopt : std::optional(place.number);
  }

 private:
  static constexpr std::uint32_t nothing = 0xFFFFFFFFU;
  struct Place {
    GridPoint point;
    std::uint32_t number = nothing;
  };

  /// The point's, or the one that it would have.
  std::size_t place_of(GridPoint point) const {
    const std::uint64_t key = std::uint64_t{point.row} << 32U | point.column;
    std::size_t place = key * 0x9E3779B97F4A7C15ULL >> shift_;  // Fibonacci hashing
    while (places_[place].number != nothing && places_[place].point != point) {
      place = place + 1 == places_.size() ? 0 : place + 1;
    }
    return place;
  }

  int shift_;
  std::vector<Place> places_;  ///< half of them at least are empty
};

}  // namespace pyrasim::hw
