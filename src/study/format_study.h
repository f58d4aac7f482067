// SPDX-License-Identifier: Apache-2.0
// What one scene makes of every number format: the rows of `pyrasim study numerics`.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "numeric/arithmetic_events.h"
#include "numeric/number_format.h"
#include "study/decision_flips.h"

namespace pyrasim {

/// A format against double on the same frame.
struct FormatRow {
  NumberFormat format;
  std::string refused;               ///< why the format cannot be used on this screen; all else is 0 then
  std::uint64_t changed_pixels = 0;  ///< in the picture of 8 bits, sRGB
  DecisionFlips flips;
  double psnr = 0;  ///< dB, of linear RGB with a peak of 1
  std::uint64_t rays = 0;
  std::uint64_t cycles = 0;
  ArithmeticEvents events;  ///< of all stages

  bool usable() const { return refused.empty(); }
  /// The processor's own formats are not watched.
  bool counts_events() const { return format.kind != NumberKind::processor; }
};

/// The narrowest format, in bits of a number and, where these are equal, after the binary point, that leaves the 8-bit
/// picture as it is; of `rows` of one kind: floating point (double and float included) or fixed. None where no format
/// of the kind does.
std::optional<NumberFormat> smallest_unchanged(const std::vector<FormatRow>& rows, bool fixed);

/// The table for people: its first line, a row, and what it comes to.
std::string format_table_header();
std::string format_table_row(const FormatRow& row);
std::string format_verdict(const std::vector<FormatRow>& rows);
/// The same with every count, as comma-separated values.
std::string format_csv_header();
std::string format_csv_row(const FormatRow& row);

}  // namespace pyrasim
