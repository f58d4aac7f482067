// SPDX-License-Identifier: Apache-2.0
// What a fixed-point format computes, as functions of raw integers: so that the comparison with an oracle is compiled
// once, and not for each format in each pair of modes.
#pragma once

#include <cstdint>
#include <vector>

#include "numeric/fix.h"

namespace pyrasim {

struct FixOperations {
  int bits;
  int fraction_bits;
  Rounding rounding;
  Overflow overflow;
  std::int64_t smallest, largest;

  using Raw = std::int64_t;
  Raw (*add)(Raw a, Raw b);
  Raw (*subtract)(Raw a, Raw b);
  Raw (*negate)(Raw a);
  Raw (*multiply)(Raw a, Raw b);
  Raw (*divide)(Raw a, Raw b);
  Raw (*square_root)(Raw a);
  Raw (*convert)(double x);

  /// Of its own for each format and pair of modes.
  std::uint64_t seed() const {
    return static_cast<std::uint64_t>(bits * 100 + fraction_bits * 28 + static_cast<int>(rounding) * 4 +
                                      static_cast<int>(overflow));
  }
};

template <int W, int F, Rounding R = Rounding::SC_RND_CONV, Overflow O = Overflow::SC_SAT>
FixOperations fix_operations() {
  using Number = Fix<W, F, R, O>;
  using Raw = FixOperations::Raw;
  return {W,
          F,
          R,
          O,
          std::numeric_limits<Number>::lowest().raw(),
          std::numeric_limits<Number>::max().raw(),
          [](Raw a, Raw b) { return (Number::from_raw(a) + Number::from_raw(b)).raw(); },
          [](Raw a, Raw b) { return (Number::from_raw(a) - Number::from_raw(b)).raw(); },
          [](Raw a) { return (-Number::from_raw(a)).raw(); },
          [](Raw a, Raw b) { return (Number::from_raw(a) * Number::from_raw(b)).raw(); },
          [](Raw a, Raw b) { return (Number::from_raw(a) / Number::from_raw(b)).raw(); },
          [](Raw a) { return sqrt(Number::from_raw(a)).raw(); },
          [](double x) { return Number(x).raw(); }};
}

namespace detail {

template <int W, int F, Rounding R>
void add_overflow_modes(std::vector<FixOperations>& all) {
  all.push_back(fix_operations<W, F, R, Overflow::SC_SAT>());
  all.push_back(fix_operations<W, F, R, Overflow::SC_SAT_ZERO>());
  all.push_back(fix_operations<W, F, R, Overflow::SC_SAT_SYM>());
  all.push_back(fix_operations<W, F, R, Overflow::SC_WRAP>());
}

}  // namespace detail

/// In all 7 * 4 pairs of modes.
template <int W, int F>
std::vector<FixOperations> fix_in_all_modes() {
  std::vector<FixOperations> all;
  detail::add_overflow_modes<W, F, Rounding::SC_RND>(all);
  detail::add_overflow_modes<W, F, Rounding::SC_RND_ZERO>(all);
  detail::add_overflow_modes<W, F, Rounding::SC_RND_MIN_INF>(all);
  detail::add_overflow_modes<W, F, Rounding::SC_RND_INF>(all);
  detail::add_overflow_modes<W, F, Rounding::SC_RND_CONV>(all);
  detail::add_overflow_modes<W, F, Rounding::SC_TRN>(all);
  detail::add_overflow_modes<W, F, Rounding::SC_TRN_ZERO>(all);
  return all;
}

}  // namespace pyrasim
