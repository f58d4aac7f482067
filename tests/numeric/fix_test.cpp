// SPDX-License-Identifier: Apache-2.0
// Fix against exact fractions, and the events that it counts. Against SystemC: hw_model/fix_against_systemc_test.cpp.
#include "numeric/fix.h"

#include <gtest/gtest.h>

#include "fix_operations.h"
#include "fix_oracle.h"

namespace pyrasim {
namespace {

/// One format in one pair of modes.
class Comparison {
 public:
  Comparison(const FixOperations& operations, int bits, int fraction_bits) : fix_{operations, bits, fraction_bits} {}

  void run(int trials) {
    FixOperands operands = fix_.operands();
    for (int trial = 0; trial < trials; ++trial) {
      compare(operands(), operands());
      compare_conversion(std::ldexp(static_cast<double>(operands()),
                                    -fix_.fraction_bits - static_cast<int>(operands.draw(-3, fix_.bits))));
    }
    ASSERT_EQ(mismatches_, 0) << fix_.name();
  }

 private:
  void compare(std::int64_t a, std::int64_t b) {
    const mpz_class p = to_mpz(a);
    const mpz_class q = to_mpz(b);
    const mpz_class one = mpz_class(1) << static_cast<unsigned>(fix_.fraction_bits);
    const auto expect = [&](const char* operation, auto compute, const mpq_class& exact) {
      arithmetic_events = {};
      const std::int64_t result = compute();
      expect_result(operation, a, b, result, exact);
    };
    expect(
        "+", [&] { return fix_.operations.add(a, b); }, mpq_class(p + q));
    expect(
        "-", [&] { return fix_.operations.subtract(a, b); }, mpq_class(p - q));
    expect(
        "negation", [&] { return fix_.operations.negate(a); }, mpq_class(-p));
    mpq_class exact(p * q, one);
    exact.canonicalize();
    expect(
        "*", [&] { return fix_.operations.multiply(a, b); }, exact);
    if (b != 0) {
      exact = mpq_class(p * one, q);
      exact.canonicalize();
      expect(
          "/", [&] { return fix_.operations.divide(a, b); }, exact);
    }
    if (a < 0) return;
    const mpz_class root =
        oracle_limited(oracle_root(p * one, fix_.operations.rounding), fix_.bits, fix_.operations.overflow);
    if (to_mpz(fix_.operations.square_root(a)) != root) fail("sqrt", a, b);
  }

  void compare_conversion(double x) {
    mpq_class exact(x);
    mpq_mul_2exp(exact.get_mpq_t(), exact.get_mpq_t(), static_cast<unsigned>(fix_.fraction_bits));
    arithmetic_events = {};
    const std::int64_t result = fix_.operations.convert(x);
    expect_result("conversion", 0, 0, result, exact);
  }

  void expect_result(const char* operation, std::int64_t a, std::int64_t b, std::int64_t result,
                     const mpq_class& exact) {
    const mpz_class unlimited = oracle_rounded(exact, fix_.operations.rounding);
    const mpz_class limited = oracle_limited(unlimited, fix_.bits, fix_.operations.overflow);
    ArithmeticEvents events;
    events.saturations = limited != unlimited ? 1 : 0;
    events.inexact = exact != limited ? 1 : 0;
    events.underflows = exact != 0 && unlimited == 0 ? 1 : 0;
    if (to_mpz(result) != limited || !(arithmetic_events == events)) fail(operation, a, b);
  }

  void fail(const char* operation, std::int64_t a, std::int64_t b) {
    if (++mismatches_ <= 3) ADD_FAILURE() << operation << " of " << a << " and " << b;
  }

  FixInFormat fix_;
  int mismatches_ = 0;
};

void run_modes(int bits, int fraction_bits) {
  for (const FixOperations& mode : fix_modes()) Comparison(mode, bits, fraction_bits).run(6000);
}

// 7 * 4 modes, 6 formats: 1 008 000 pairs for each operation.
TEST(Fix, AllModesAreExactIn64Bits) {
  run_modes(64, 28);
  run_modes(64, 62);
  run_modes(64, 0);
}
TEST(Fix, AllModesAreExactInFewerBits) {
  run_modes(48, 20);
  run_modes(32, 16);
  run_modes(9, 4);
}

TEST(Fix, DefaultModesAreExactInAllFractions) {
  const FixOperations modes = fix_operations();
  Comparison(modes, 64, 12).run(20000);
  Comparison(modes, 64, 20).run(20000);
  Comparison(modes, 64, 32).run(20000);
  Comparison(modes, 33, 32).run(20000);
  Comparison(modes, 2, 1).run(2000);
}

/// 2079 formats, each in one pair of modes by turns: 207 900 pairs for each operation.
TEST(Fix, EveryFormatIsExact) {
  const std::vector<FixOperations> modes = fix_modes();
  std::size_t formats = 0;
  for (int bits = min_fixed_bits; bits <= max_fixed_bits; ++bits) {
    for (int fraction_bits = 0; fraction_bits < bits; ++fraction_bits) {
      Comparison(modes[formats++ % modes.size()], bits, fraction_bits).run(100);
      if (HasFatalFailure()) return;
    }
  }
}

const NumberFormat small = NumberFormat::fixed(16, 8);  // -128 to 128 - 2^-8
using Limits = std::numeric_limits<Fix>;
constexpr double infinity = std::numeric_limits<double>::infinity();

ArithmeticEvents events_of(auto action) {
  const FormatScope<Fix> scope(small);
  arithmetic_events = {};
  action();
  return arithmetic_events;
}

TEST(Fix, SpecialDoublesBecomeNumbers) {
  ArithmeticEvents events = events_of([] { EXPECT_EQ(Fix(std::nan("")), Fix(0)); });
  EXPECT_EQ(events.invalid, 1U);
  events = events_of([] {
    EXPECT_EQ(Fix(infinity), Limits::max());
    EXPECT_EQ(Fix(-infinity), Limits::lowest());
    EXPECT_EQ((BasicFix<Rounding::SC_TRN, Overflow::SC_WRAP>(infinity).raw()), 0x7fff);
  });
  EXPECT_EQ(events.saturations, 3U);
  const FormatScope<Fix> scope(small);
  EXPECT_EQ(static_cast<double>(Fix(-0.0)), 0);
  EXPECT_EQ(Fix(1e300), Limits::max());
  EXPECT_EQ(Fix(-1e-300), Fix(0));
  EXPECT_EQ((BasicFix<Rounding::SC_TRN, Overflow::SC_SAT>(-1e-300).raw()), -1);
}

TEST(Fix, DivisionByZeroSaturatesBySignAndIsCounted) {
  const ArithmeticEvents events = events_of([] {
    EXPECT_EQ(Fix(3) / Fix(0), Limits::max());
    EXPECT_EQ(Fix(-3) / Fix(0), Limits::lowest());
    EXPECT_EQ(Fix(0) / Fix(0), Fix(0));
  });
  EXPECT_EQ(events, (ArithmeticEvents{.divisions_by_zero = 3}));
}

TEST(Fix, IntegersAreScaledAndSaturate) {
  const FormatScope<Fix> scope(small);
  EXPECT_EQ(Fix(-3).raw(), -768);
  EXPECT_EQ(Fix(std::int64_t{1} << 62), Limits::max());
  EXPECT_EQ(Fix(std::numeric_limits<std::uint64_t>::max()), Limits::max());
  const FormatScope<Fix> integers(NumberFormat::fixed(64, 0));
  EXPECT_EQ(Fix(std::numeric_limits<std::int64_t>::min()).raw(), std::numeric_limits<std::int64_t>::min());
}

}  // namespace
}  // namespace pyrasim
