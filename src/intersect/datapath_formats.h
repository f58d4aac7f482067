// SPDX-License-Identifier: Apache-2.0
// The number formats of a datapath, stage by stage.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "numeric/arithmetic_events.h"
#include "numeric/number_format.h"
#include "scene/scene.h"

namespace pyrasim {

/// The view-vector generator's format and the intersection units'. The trace trees are summed in integers, exactly, and
/// have none.
struct DatapathFormats {
  NumberFormat view_vectors;
  NumberFormat intersection;

  /// Both in double: nothing to round or to count.
  bool plain() const { return *this == DatapathFormats(); }
  /// One of them is computed in software, which counts arithmetic_events.
  bool counts_events() const {
    return view_vectors.kind != NumberKind::processor || intersection.kind != NumberKind::processor;
  }
  /// "fp24", or "view_vectors=fp24,intersection=double" where they differ.
  std::string name() const;
  friend bool operator==(const DatapathFormats&, const DatapathFormats&) = default;
};

/// Reads what name() writes; a stage that is not named computes in double. Throws UsageError.
DatapathFormats parse_datapath_formats(std::string_view text);

/// Whether the formats can tell the points of a screen's grid apart, `steps` of them along a pixel's side.
///
/// Throws UsageError where a format cannot address the screen: the grid's points lie closer together than its numbers
/// near 0, or the squared length of the view vector through the screen's corner exceeds them. Floating point has finer
/// steps towards the middle of the screen; with fewer significand bits than log2(N steps) + 4, N being the longer
/// side's pixels, points near the border begin to fall together, and the answer is a warning for the user.
std::optional<std::string> check_addressing(const DatapathFormats& formats, const Screen& screen, std::int64_t steps);

/// What happened to numbers in each stage of a frame.
struct DatapathEvents {
  ArithmeticEvents view_vectors;
  ArithmeticEvents intersection;

  DatapathEvents& operator+=(const DatapathEvents& other) {
    view_vectors += other.view_vectors;
    intersection += other.intersection;
    return *this;
  }
  friend bool operator==(const DatapathEvents&, const DatapathEvents&) = default;
};

/// compute()'s result; the events of its operations are added to `sum`.
template <class Computation>
auto counting_events(ArithmeticEvents& sum, const Computation& compute) {
  arithmetic_events = {};
  const auto result = compute();
  sum += arithmetic_events;
  return result;
}

}  // namespace pyrasim
