// SPDX-License-Identifier: Apache-2.0
// Fix against the definition it follows: SystemC's fixed-point types, in all rounding and overflow modes.
//
// sc_fix, which is sc_fixed with its widths and modes as values, computes sums and products exactly and quantises them
// when they are assigned. A quotient it first cuts to 64 significant bits (SC_DEFAULT_DIV_WL_). With operands of less
// than 32 bits that does no harm: an inexact quotient keeps a distance of 2^-63 of itself from every tie and every
// value of the format. Wider formats are compared here where the quotient is exact; numeric/fix_test.cpp has exact
// fractions as the oracle of all quotients and square roots.
#define SC_INCLUDE_FX
#include <gtest/gtest.h>

#include <random>
#include <systemc>

#include "../numeric/fix_operations.h"

namespace pyrasim {
namespace {

sc_dt::sc_q_mode in_systemc(Rounding mode) {
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

sc_dt::sc_o_mode in_systemc(Overflow mode) {
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
class Comparison {
 public:
  Comparison(const FixOperations& operations, int bits, int fraction_bits)
      : fix_{operations, bits, fraction_bits},
        type_(bits, bits - fraction_bits, in_systemc(operations.rounding), in_systemc(operations.overflow)) {}

  void run(int pairs) {
    const sc_dt::sc_fxtype_context in_this_format(type_);
    FixOperands operands = fix_.operands();
    for (int pair = 0; pair < pairs; ++pair) {
      compare(operands(), operands());
      const double x = std::ldexp(static_cast<double>(operands()),
                                  -fix_.fraction_bits - static_cast<int>(operands.draw(-3, fix_.bits)));
      expect("conversion", 0, 0, fix_.operations.convert(x), sc_dt::sc_fxval(x));
    }
    ASSERT_EQ(mismatches_, 0) << fix_.name();
  }

 private:
  sc_dt::sc_fxval exact(std::int64_t raw) const {
    return sc_dt::sc_fxval(static_cast<sc_dt::int64>(raw)) >> fix_.fraction_bits;
  }

  void compare(std::int64_t a, std::int64_t b) {
    const sc_dt::sc_fxval x = exact(a);
    const sc_dt::sc_fxval y = exact(b);
    expect("+", a, b, fix_.operations.add(a, b), x + y);
    expect("-", a, b, fix_.operations.subtract(a, b), x - y);
    expect("*", a, b, fix_.operations.multiply(a, b), x * y);
    if (b == 0) return;
    if (fix_.bits < 32) {
      expect("/", a, b, fix_.operations.divide(a, b), x / y);
      return;
    }
    // A quotient that is exact: of a product that fits.
    const Int128 product = static_cast<Int128>(a) * b;
    if (product != static_cast<std::int64_t>(product) || product % (Int128{1} << fix_.fraction_bits) != 0) return;
    const std::int64_t dividend = fix_.operations.multiply(a, b);
    if (exact(dividend) == x * y) expect("/", dividend, b, fix_.operations.divide(dividend, b), (x * y) / y);
  }

  /// `unlimited`: the exact result, which sc_fix quantises.
  void expect(const char* operation, std::int64_t a, std::int64_t b, std::int64_t ours,
              const sc_dt::sc_fxval& unlimited) {
    const sc_dt::sc_fix theirs(unlimited);
    if (exact(ours) == theirs) return;
    if (++mismatches_ <= 3) {
      ADD_FAILURE() << operation << " of " << a << " and " << b << ": " << ours << ", "
                    << sc_dt::sc_fxval(theirs << fix_.fraction_bits).to_string() << " by SystemC";
    }
  }

  FixInFormat fix_;
  sc_dt::sc_fxtype_params type_;
  int mismatches_ = 0;
};

void run_modes(int bits, int fraction_bits) {
  for (const FixOperations& mode : fix_modes()) Comparison(mode, bits, fraction_bits).run(10000);
}

// 28 pairs of modes, 4 formats: 1.12 million operand pairs.
TEST(FixAgainstSystemC, AllModesAgreeIn64Bits) { run_modes(64, 28); }
TEST(FixAgainstSystemC, AllModesAgreeIn48Bits) { run_modes(48, 20); }
TEST(FixAgainstSystemC, AllModesAgreeIn24Bits) { run_modes(24, 12); }
TEST(FixAgainstSystemC, AllModesAgreeIn9Bits) { run_modes(9, 4); }

/// 300 formats of any widths, each in a pair of modes: 90 000 operand pairs.
TEST(FixAgainstSystemC, RandomFormatsAgree) {
  const std::vector<FixOperations> modes = fix_modes();
  std::mt19937_64 random(31);
  const auto draw = [&](int first, int last) { return std::uniform_int_distribution(first, last)(random); };
  for (int k = 0; k < 300; ++k) {
    const int bits = draw(min_fixed_bits, max_fixed_bits);
    const int fraction_bits = draw(0, bits - 1);
    Comparison(modes[random() % modes.size()], bits, fraction_bits).run(300);
    if (HasFatalFailure()) return;
  }
}

}  // namespace
}  // namespace pyrasim
