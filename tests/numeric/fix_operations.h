// SPDX-License-Identifier: Apache-2.0
// What a fixed-point format computes, as functions of raw integers: so that the comparison with an oracle is compiled
// once, and not for each pair of modes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "fix_operands.h"
#include "numeric/format_scope.h"

namespace pyrasim {

/// The operations compute in the format set.
struct FixOperations {
  Rounding rounding;
  Overflow overflow;

  using Raw = std::int64_t;
  Raw (*add)(Raw a, Raw b);
  Raw (*subtract)(Raw a, Raw b);
  Raw (*negate)(Raw a);
  Raw (*multiply)(Raw a, Raw b);
  Raw (*divide)(Raw a, Raw b);
  Raw (*square_root)(Raw a);
  Raw (*convert)(double x);
  Raw (*smallest)();
  Raw (*largest)();
};

template <Rounding R = Rounding::SC_RND_CONV, Overflow O = Overflow::SC_SAT>
FixOperations fix_operations() {
  using Number = BasicFix<R, O>;
  using Raw = FixOperations::Raw;
  return {R,
          O,
          [](Raw a, Raw b) { return (Number::from_raw(a) + Number::from_raw(b)).raw(); },
          [](Raw a, Raw b) { return (Number::from_raw(a) - Number::from_raw(b)).raw(); },
          [](Raw a) { return (-Number::from_raw(a)).raw(); },
          [](Raw a, Raw b) { return (Number::from_raw(a) * Number::from_raw(b)).raw(); },
          [](Raw a, Raw b) { return (Number::from_raw(a) / Number::from_raw(b)).raw(); },
          [](Raw a) { return sqrt(Number::from_raw(a)).raw(); },
          [](double x) { return Number(x).raw(); },
          [] { return std::numeric_limits<Number>::lowest().raw(); },
          [] { return std::numeric_limits<Number>::max().raw(); }};
}

namespace detail {

template <Rounding R>
void add_overflow_modes(std::vector<FixOperations>& all) {
  all.push_back(fix_operations<R, Overflow::SC_SAT>());
  all.push_back(fix_operations<R, Overflow::SC_SAT_ZERO>());
  all.push_back(fix_operations<R, Overflow::SC_SAT_SYM>());
  all.push_back(fix_operations<R, Overflow::SC_WRAP>());
}

}  // namespace detail

/// All 7 * 4 pairs of modes.
inline std::vector<FixOperations> fix_modes() {
  std::vector<FixOperations> all;
  detail::add_overflow_modes<Rounding::SC_RND>(all);
  detail::add_overflow_modes<Rounding::SC_RND_ZERO>(all);
  detail::add_overflow_modes<Rounding::SC_RND_MIN_INF>(all);
  detail::add_overflow_modes<Rounding::SC_RND_INF>(all);
  detail::add_overflow_modes<Rounding::SC_RND_CONV>(all);
  detail::add_overflow_modes<Rounding::SC_TRN>(all);
  detail::add_overflow_modes<Rounding::SC_TRN_ZERO>(all);
  return all;
}

/// One format in one pair of modes, set while this lives.
struct FixInFormat {
  FixOperations operations;
  int bits, fraction_bits;
  FormatScope<Fix> scope{NumberFormat::fixed(bits, fraction_bits)};

  /// Corners of the format and random numbers, of a seed of its own for each format and pair of modes.
  FixOperands operands() const {
    const int seed = bits * 100 + fraction_bits * 28 + static_cast<int>(operations.rounding) * 4 +
                     static_cast<int>(operations.overflow);
    return {operations.smallest(), operations.largest(), fraction_bits, static_cast<std::uint64_t>(seed)};
  }
  std::string name() const {
    return format_of<Fix>().name() + " rounding " + std::to_string(static_cast<int>(operations.rounding)) +
           " overflow " + std::to_string(static_cast<int>(operations.overflow));
  }
};

}  // namespace pyrasim
