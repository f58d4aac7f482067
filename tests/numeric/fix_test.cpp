// SPDX-License-Identifier: Apache-2.0
// Fix against exact fractions, and the events that it counts. Against SystemC: hw_model/fix_against_systemc_test.cpp.
#include "numeric/fix.h"

#include <gtest/gtest.h>

#include "fix_operands.h"
#include "fix_oracle.h"

namespace pyrasim {
namespace {

/// One format in one pair of modes.
template <int W, int F, Rounding R, Overflow O>
class Comparison {
  using Number = Fix<W, F, R, O>;

 public:
  void run(int trials) {
    using Limits = std::numeric_limits<Number>;
    FixOperands operands(Limits::lowest().raw(), Limits::max().raw(), F,
                         static_cast<std::uint64_t>(W * 100 + F * 28 + static_cast<int>(R) * 4 + static_cast<int>(O)));
    for (int trial = 0; trial < trials; ++trial) {
      compare(operands(), operands());
      compare_conversion(std::ldexp(static_cast<double>(operands()), -F - static_cast<int>(operands.draw(-3, W))));
    }
    ASSERT_EQ(mismatches_, 0) << "Fix<" << W << ", " << F << "> rounding " << static_cast<int>(R) << " overflow "
                              << static_cast<int>(O);
  }

 private:
  void compare(std::int64_t a, std::int64_t b) {
    const auto x = Number::from_raw(a);
    const auto y = Number::from_raw(b);
    const mpz_class p = to_mpz(a);
    const mpz_class q = to_mpz(b);
    const mpz_class one = mpz_class(1) << static_cast<unsigned>(F);
    expect(
        "+", a, b, [&] { return x + y; }, mpq_class(p + q));
    expect(
        "-", a, b, [&] { return x - y; }, mpq_class(p - q));
    expect(
        "negation", a, b, [&] { return -x; }, mpq_class(-p));
    mpq_class exact(p * q, one);
    exact.canonicalize();
    expect(
        "*", a, b, [&] { return x * y; }, exact);
    if (b != 0) {
      exact = mpq_class(p * one, q);
      exact.canonicalize();
      expect(
          "/", a, b, [&] { return x / y; }, exact);
    }
    if (a >= 0 && to_mpz(sqrt(x).raw()) != oracle_limited(oracle_root(p * one, R), W, O)) fail("sqrt", a, b);
  }

  void compare_conversion(double x) {
    mpq_class exact(x);
    mpq_mul_2exp(exact.get_mpq_t(), exact.get_mpq_t(), F);
    expect(
        "conversion", 0, 0, [&] { return Number(x); }, exact);
  }

  template <class Compute>
  void expect(const char* operation, std::int64_t a, std::int64_t b, Compute compute, const mpq_class& exact) {
    arithmetic_events = {};
    const Number result = compute();
    const mpz_class unlimited = oracle_rounded(exact, R);
    const mpz_class limited = oracle_limited(unlimited, W, O);
    ArithmeticEvents events;
    events.saturations = limited != unlimited ? 1 : 0;
    events.inexact = exact != limited ? 1 : 0;
    events.underflows = exact != 0 && unlimited == 0 ? 1 : 0;
    if (to_mpz(result.raw()) != limited || !(arithmetic_events == events)) fail(operation, a, b);
  }

  void fail(const char* operation, std::int64_t a, std::int64_t b) {
    if (++mismatches_ <= 3) ADD_FAILURE() << operation << " of " << a << " and " << b;
  }

  int mismatches_ = 0;
};

template <int W, int F, Rounding R>
void run_overflow_modes(int trials) {
  Comparison<W, F, R, Overflow::SC_SAT>().run(trials);
  Comparison<W, F, R, Overflow::SC_SAT_ZERO>().run(trials);
  Comparison<W, F, R, Overflow::SC_SAT_SYM>().run(trials);
  Comparison<W, F, R, Overflow::SC_WRAP>().run(trials);
}

template <int W, int F>
void run_modes(int trials) {
  run_overflow_modes<W, F, Rounding::SC_RND>(trials);
  run_overflow_modes<W, F, Rounding::SC_RND_ZERO>(trials);
  run_overflow_modes<W, F, Rounding::SC_RND_MIN_INF>(trials);
  run_overflow_modes<W, F, Rounding::SC_RND_INF>(trials);
  run_overflow_modes<W, F, Rounding::SC_RND_CONV>(trials);
  run_overflow_modes<W, F, Rounding::SC_TRN>(trials);
  run_overflow_modes<W, F, Rounding::SC_TRN_ZERO>(trials);
}

// 7 * 4 modes, 6 formats: 1 008 000 pairs for each operation.
TEST(Fix, AllModesAreExactIn64Bits) {
  run_modes<64, 28>(6000);
  run_modes<64, 62>(6000);
  run_modes<64, 0>(6000);
}
TEST(Fix, AllModesAreExactInFewerBits) {
  run_modes<48, 20>(6000);
  run_modes<32, 16>(6000);
  run_modes<9, 4>(6000);
}

TEST(Fix, DefaultModesAreExactInAllFractions) {
  Comparison<64, 12, Rounding::SC_RND_CONV, Overflow::SC_SAT>().run(20000);
  Comparison<64, 20, Rounding::SC_RND_CONV, Overflow::SC_SAT>().run(20000);
  Comparison<64, 32, Rounding::SC_RND_CONV, Overflow::SC_SAT>().run(20000);
  Comparison<33, 32, Rounding::SC_RND_CONV, Overflow::SC_SAT>().run(20000);
  Comparison<2, 1, Rounding::SC_RND_CONV, Overflow::SC_SAT>().run(2000);
}

using Small = Fix<16, 8>;  // -128 to 128 - 2^-8
constexpr double infinity = std::numeric_limits<double>::infinity();

ArithmeticEvents events_of(auto action) {
  arithmetic_events = {};
  action();
  return arithmetic_events;
}

TEST(Fix, SpecialDoublesBecomeNumbers) {
  ArithmeticEvents events = events_of([] { EXPECT_EQ(Small(std::nan("")), Small(0)); });
  EXPECT_EQ(events.invalid, 1U);
  events = events_of([] {
    EXPECT_EQ(Small(infinity), std::numeric_limits<Small>::max());
    EXPECT_EQ(Small(-infinity), std::numeric_limits<Small>::lowest());
    EXPECT_EQ((Fix<16, 8, Rounding::SC_TRN, Overflow::SC_WRAP>(infinity).raw()), 0x7fff);
  });
  EXPECT_EQ(events.saturations, 3U);
  EXPECT_EQ(static_cast<double>(Small(-0.0)), 0);
  EXPECT_EQ(Small(1e300), std::numeric_limits<Small>::max());
  EXPECT_EQ(Small(-1e-300), Small(0));
  EXPECT_EQ((Fix<16, 8, Rounding::SC_TRN>(-1e-300).raw()), -1);
}

TEST(Fix, DivisionByZeroSaturatesBySignAndIsCounted) {
  const ArithmeticEvents events = events_of([] {
    EXPECT_EQ(Small(3) / Small(0), std::numeric_limits<Small>::max());
    EXPECT_EQ(Small(-3) / Small(0), std::numeric_limits<Small>::lowest());
    EXPECT_EQ(Small(0) / Small(0), Small(0));
  });
  EXPECT_EQ(events, (ArithmeticEvents{.divisions_by_zero = 3}));
}

TEST(Fix, IntegersAreScaledAndSaturate) {
  EXPECT_EQ(Small(-3).raw(), -768);
  EXPECT_EQ(Small(std::int64_t{1} << 62), std::numeric_limits<Small>::max());
  EXPECT_EQ(Small(std::numeric_limits<std::uint64_t>::max()), std::numeric_limits<Small>::max());
  EXPECT_EQ((Fix<64, 0>(std::numeric_limits<std::int64_t>::min()).raw()), std::numeric_limits<std::int64_t>::min());
}

}  // namespace
}  // namespace pyrasim
