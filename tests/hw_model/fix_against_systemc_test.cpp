// SPDX-License-Identifier: Apache-2.0
// Fix against the definition it follows: SystemC's sc_fixed, in all rounding and overflow modes.
//
// sc_fixed computes sums and products exactly and quantises them when they are assigned. A quotient it first cuts to 64
// significant bits (SC_DEFAULT_DIV_WL_). With operands of less than 32 bits that does no harm: an inexact quotient
// keeps a distance of 2^-63 of itself from every tie and every value of the format. Wider formats are compared here
// where the quotient is exact; numeric/fix_test.cpp has exact fractions as the oracle of all quotients and square
// roots.
#define SC_INCLUDE_FX
#include <gtest/gtest.h>

#include <systemc>

#include "../numeric/fix_operands.h"
#include "numeric/fix.h"

namespace pyrasim {
namespace {

constexpr sc_dt::sc_q_mode in_systemc(Rounding mode) {
  switch (mode) {
    case Rounding::SC_RND:
      return sc_dt::SC_RND;
    case Rounding::SC_RND_ZERO:
      return sc_dt::SC_RND_ZERO;
    case Rounding::SC_RND_MIN_INF:
      return sc_dt::SC_RND_MIN_INF;
    case Rounding::SC_RND_INF:
      return sc_dt::SC_RND_INF;
    case Rounding::SC_RND_CONV:
      return sc_dt::SC_RND_CONV;
    case Rounding::SC_TRN:
      return sc_dt::SC_TRN;
    case Rounding::SC_TRN_ZERO:
      break;
  }
  return sc_dt::SC_TRN_ZERO;
}

constexpr sc_dt::sc_o_mode in_systemc(Overflow mode) {
  switch (mode) {
    case Overflow::SC_SAT:
      return sc_dt::SC_SAT;
    case Overflow::SC_SAT_ZERO:
      return sc_dt::SC_SAT_ZERO;
    case Overflow::SC_SAT_SYM:
      return sc_dt::SC_SAT_SYM;
    case Overflow::SC_WRAP:
      break;
  }
  return sc_dt::SC_WRAP;
}

/// One format in one pair of modes.
template <int W, int F, Rounding R, Overflow O>
class Comparison {
  using Ours = Fix<W, F, R, O>;
  using Theirs = sc_dt::sc_fixed<W, W - F, in_systemc(R), in_systemc(O)>;

 public:
  void run(int pairs) {
    using Limits = std::numeric_limits<Ours>;
    FixOperands operands(Limits::lowest().raw(), Limits::max().raw(), F,
                         static_cast<std::uint64_t>(W * 100 + F * 28 + static_cast<int>(R) * 4 + static_cast<int>(O)));
    for (int pair = 0; pair < pairs; ++pair) {
      compare(Ours::from_raw(operands()), Ours::from_raw(operands()));
      const double x = std::ldexp(static_cast<double>(operands()), -F - static_cast<int>(operands.draw(-3, W)));
      expect("conversion", Ours(), Ours(), Ours(x), sc_dt::sc_fxval(x));
    }
    ASSERT_EQ(mismatches_, 0) << "Fix<" << W << ", " << F << "> rounding " << static_cast<int>(R) << " overflow "
                              << static_cast<int>(O);
  }

 private:
  static sc_dt::sc_fxval exact(Ours x) { return sc_dt::sc_fxval(static_cast<sc_dt::int64>(x.raw())) >> F; }

  void compare(Ours a, Ours b) {
    const sc_dt::sc_fxval x = exact(a);
    const sc_dt::sc_fxval y = exact(b);
    expect("+", a, b, a + b, x + y);
    expect("-", a, b, a - b, x - y);
    expect("*", a, b, a * b, x * y);
    if constexpr (W < 32) {
      if (b.raw() != 0) expect("/", a, b, a / b, x / y);
    } else {
      // A quotient that is exact: of a product that fits.
      const Int128 product = static_cast<Int128>(a.raw()) * b.raw();
      if (b.raw() == 0 || product != static_cast<std::int64_t>(product) || product % (Int128{1} << F) != 0) return;
      const Ours dividend = a * b;
      if (exact(dividend) == x * y) expect("/", dividend, b, dividend / b, (x * y) / y);
    }
  }

  /// `unlimited`: the exact result, which sc_fixed quantises.
  void expect(const char* operation, Ours a, Ours b, Ours ours, const sc_dt::sc_fxval& unlimited) {
    const Theirs theirs = unlimited;
    if (exact(ours) == theirs) return;
    if (++mismatches_ <= 3) {
      ADD_FAILURE() << operation << " of " << a.raw() << " and " << b.raw() << ": " << ours.raw() << ", "
                    << sc_dt::sc_fxval(theirs << F).to_string() << " by SystemC";
    }
  }

  int mismatches_ = 0;
};

template <int W, int F, Rounding R>
void run_overflow_modes(int pairs) {
  Comparison<W, F, R, Overflow::SC_SAT>().run(pairs);
  Comparison<W, F, R, Overflow::SC_SAT_ZERO>().run(pairs);
  Comparison<W, F, R, Overflow::SC_SAT_SYM>().run(pairs);
  Comparison<W, F, R, Overflow::SC_WRAP>().run(pairs);
}

template <int W, int F>
void run_modes(int pairs) {
  run_overflow_modes<W, F, Rounding::SC_RND>(pairs);
  run_overflow_modes<W, F, Rounding::SC_RND_ZERO>(pairs);
  run_overflow_modes<W, F, Rounding::SC_RND_MIN_INF>(pairs);
  run_overflow_modes<W, F, Rounding::SC_RND_INF>(pairs);
  run_overflow_modes<W, F, Rounding::SC_RND_CONV>(pairs);
  run_overflow_modes<W, F, Rounding::SC_TRN>(pairs);
  run_overflow_modes<W, F, Rounding::SC_TRN_ZERO>(pairs);
}

// 28 pairs of modes, 4 formats: 1.12 million operand pairs.
TEST(FixAgainstSystemC, AllModesAgreeIn64Bits) { run_modes<64, 28>(10000); }
TEST(FixAgainstSystemC, AllModesAgreeIn48Bits) { run_modes<48, 20>(10000); }
TEST(FixAgainstSystemC, AllModesAgreeIn24Bits) { run_modes<24, 12>(10000); }
TEST(FixAgainstSystemC, AllModesAgreeIn9Bits) { run_modes<9, 4>(10000); }

}  // namespace
}  // namespace pyrasim
