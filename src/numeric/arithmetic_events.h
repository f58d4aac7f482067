// SPDX-License-Identifier: Apache-2.0
// What happened to numbers on their way through a narrow format: part of a run's statistics.
#pragma once

#include <cstdint>

namespace pyrasim {

/// Counts of operations and conversions whose result is not the exact one. One operation may count in several fields.
struct ArithmeticEvents {
  std::uint64_t saturations = 0;  ///< too large: became the largest value, infinity, zero, or wrapped; inexact too
  std::uint64_t underflows = 0;   ///< inexact, and the result is 0 or (Flt) the exact one was below the normal range
  std::uint64_t inexact = 0;      ///< the exact result is a real number, and this one differs
  std::uint64_t divisions_by_zero = 0;  ///< of a finite number, 0 / 0 included
  std::uint64_t invalid = 0;            ///< no real result: sqrt(-1), 0 * infinity, NaN given to a format without NaN

  ArithmeticEvents& operator+=(const ArithmeticEvents& other) {
    saturations += other.saturations;
    underflows += other.underflows;
    inexact += other.inexact;
    divisions_by_zero += other.divisions_by_zero;
    invalid += other.invalid;
    return *this;
  }
  friend bool operator==(const ArithmeticEvents&, const ArithmeticEvents&) = default;
};

/// The events of this thread's operations in Flt and Fix since it last set them to {}. Like the format that they
/// compute in (format_scope.h) a global: an operator has no other place to leave what happened. Whoever runs threads
/// adds their counts up.
inline constinit thread_local ArithmeticEvents arithmetic_events{};

}  // namespace pyrasim
