// SPDX-License-Identifier: Apache-2.0
// Fix against exact fractions, and the events that it counts. Against SystemC: hw_model/fix_against_systemc_test.cpp.
#include "numeric/fix.h"

#include <gtest/gtest.h>

#include "fix_operands.h"
#include "fix_operations.h"
#include "fix_oracle.h"

namespace pyrasim {
namespace {

/// One format in one pair of modes.
class Comparison {
 public:
  explicit Comparison(const FixOperations& fix) : fix_(fix) {}

  void run(int trials) {
    FixOperands operands(fix_.smallest, fix_.largest, fix_.fraction_bits, fix_.seed());
    for (int trial = 0; trial < trials; ++trial) {
      compare(operands(), operands());
      compare_conversion(std::ldexp(static_cast<double>(operands()),
                                    -fix_.fraction_bits - static_cast<int>(operands.draw(-3, fix_.bits))));
    }
    ASSERT_EQ(mismatches_, 0) << "Fix<" << fix_.bits << ", " << fix_.fraction_bits << "> rounding "
                              << static_cast<int>(fix_.rounding) << " overflow " << static_cast<int>(fix_.overflow);
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
        "+", [&] { return fix_.add(a, b); }, mpq_class(p + q));
    expect(
        "-", [&] { return fix_.subtract(a, b); }, mpq_class(p - q));
    expect(
        "negation", [&] { return fix_.negate(a); }, mpq_class(-p));
    mpq_class exact(p * q, one);
    exact.canonicalize();
    expect(
        "*", [&] { return fix_.multiply(a, b); }, exact);
    if (b != 0) {
      exact = mpq_class(p * one, q);
      exact.canonicalize();
      expect(
          "/", [&] { return fix_.divide(a, b); }, exact);
    }
    if (a < 0) return;
    const mpz_class root = oracle_limited(oracle_root(p * one, fix_.rounding), fix_.bits, fix_.overflow);
    if (to_mpz(fix_.square_root(a)) != root) fail("sqrt", a, b);
  }

  void compare_conversion(double x) {
    mpq_class exact(x);
    mpq_mul_2exp(exact.get_mpq_t(), exact.get_mpq_t(), static_cast<unsigned>(fix_.fraction_bits));
    arithmetic_events = {};
    const std::int64_t result = fix_.convert(x);
    expect_result("conversion", 0, 0, result, exact);
  }

  void expect_result(const char* operation, std::int64_t a, std::int64_t b, std::int64_t result,
                     const mpq_class& exact) {
    const mpz_class unlimited = oracle_rounded(exact, fix_.rounding);
    const mpz_class limited = oracle_limited(unlimited, fix_.bits, fix_.overflow);
    ArithmeticEvents events;
    events.saturations = limited != unlimited ? 1 : 0;
    events.inexact = exact != limited ? 1 : 0;
    events.underflows = exact != 0 && unlimited == 0 ? 1 : 0;
    if (to_mpz(result) != limited || !(arithmetic_events == events)) fail(operation, a, b);
  }

  void fail(const char* operation, std::int64_t a, std::int64_t b) {
    if (++mismatches_ <= 3) ADD_FAILURE() << operation << " of " << a << " and " << b;
  }

  FixOperations fix_;
  int mismatches_ = 0;
};

void run_modes(const std::vector<FixOperations>& modes) {
  for (const FixOperations& fix : modes) Comparison(fix).run(6000);
}

// 7 * 4 modes, 6 formats: 1 008 000 pairs for each operation.
TEST(Fix, AllModesAreExactIn64Bits) {
  run_modes(fix_in_all_modes<64, 28>());
  run_modes(fix_in_all_modes<64, 62>());
  run_modes(fix_in_all_modes<64, 0>());
}
TEST(Fix, AllModesAreExactInFewerBits) {
  run_modes(fix_in_all_modes<48, 20>());
  run_modes(fix_in_all_modes<32, 16>());
  run_modes(fix_in_all_modes<9, 4>());
}

TEST(Fix, DefaultModesAreExactInAllFractions) {
  Comparison(fix_operations<64, 12>()).run(20000);
  Comparison(fix_operations<64, 20>()).run(20000);
  Comparison(fix_operations<64, 32>()).run(20000);
  Comparison(fix_operations<33, 32>()).run(20000);
  Comparison(fix_operations<2, 1>()).run(2000);
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
