// SPDX-License-Identifier: Apache-2.0
#include "surface/error_bounds.h"

#include <algorithm>

namespace pyrasim {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

DistanceRange within_bounds(const DistanceRange& range, double begin, double end, const Vector<double>& direction) {
  if (!(direction.x > 0)) return range;
  const double lowest = std::max(range.lowest, begin / direction.x);
  return {lowest, std::max(lowest, std::min(range.highest, end / direction.x))};
}

double if_of_use(double error, const RoundingUnits& rounding) {
  constexpr double of_use = 0x1p-8;
  return rounding.relative > 0 && error < of_use ? error : infinity;
}

}  // namespace pyrasim
