// SPDX-License-Identifier: Apache-2.0
// Flt against MPFR, bit for bit, with the events that it counts.
#include "numeric/flt.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>

#include "flt_operands.h"
#include "mpfr_oracle.h"

namespace pyrasim {
namespace {

constexpr std::array operations{Operation::add,    Operation::subtract,    Operation::multiply,
                                Operation::divide, Operation::square_root, Operation::convert};

template <class Number>
Outcome outcome(Operation operation, double a, double b) {
  const auto at = [](double x) { return Number::from_exact(x); };
  arithmetic_events = {};
  Number result;
  if (operation == Operation::add) result = at(a) + at(b);
  if (operation == Operation::subtract) result = at(a) - at(b);
  if (operation == Operation::multiply) result = at(a) * at(b);
  if (operation == Operation::divide) result = at(a) / at(b);
  if (operation == Operation::square_root) result = sqrt(at(a));
  if (operation == Operation::convert) result = Number(a);
  return {static_cast<double>(result), arithmetic_events};
}

/// NaN equals NaN, +0 differs from -0.
bool same(const Outcome& a, const Outcome& b) {
  const bool values = std::isnan(a.value)
                          ? std::isnan(b.value)
                          : std::bit_cast<std::uint64_t>(a.value) == std::bit_cast<std::uint64_t>(b.value);
  return values && a.events == b.events;
}

std::string text(const Outcome& x) {
  std::ostringstream out;
  out << std::hexfloat << x.value << " saturations " << x.events.saturations << " underflows " << x.events.underflows
      << " inexact " << x.events.inexact << " divisions by zero " << x.events.divisions_by_zero << " invalid "
      << x.events.invalid;
  return out.str();
}

template <class Number>
class FltAgainstMpfr : public testing::Test {
 protected:
  static constexpr int e = Number::exponent_bits;
  static constexpr int p = Number::significand_bits;

  void expect_same(Operation operation, double a, double b) {
    const Outcome ours = outcome<Number>(operation, a, b);
    const Outcome exact = oracle_(operation, a, b);
    if (same(ours, exact)) return;
    if (++mismatches_ > 5) return;
    ADD_FAILURE() << "operation " << static_cast<int>(operation) << std::hexfloat << " on " << a << " and " << b
                  << ":\n"
                  << text(ours) << "\n"
                  << text(exact) << " by MPFR";
  }

  int mismatches_ = 0;
  MpfrOracle oracle_{e, p};
  FltOperands operands_{e, p, 1000 * e + p};
};

using Formats =
    testing::Types<Fp16, Fp24, Bf16, Flt<8, 9>, Flt<8, 10>, Tf32, Flt<8, 12>, Flt<8, 13>, Flt<8, 14>, Flt<8, 15>,
                   Flt<8, 16>, Flt<8, 17>, Flt<8, 18>, Flt<8, 19>, Flt<8, 20>, Flt<8, 21>, Flt<8, 22>, Flt<8, 23>,
                   Flt<8, 24>, Flt<8, 25>, Flt<11, 25>, Flt<11, 11>, Flt<10, 25>, Flt<5, 25>, Flt<4, 4>, Flt<2, 25>>;
TYPED_TEST_SUITE(FltAgainstMpfr, Formats);

TYPED_TEST(FltAgainstMpfr, CornersAgree) {
  for (const Operation operation : operations) {
    for (const double a : this->operands_.corners()) {
      for (const double b : this->operands_.corners()) this->expect_same(operation, a, b);
    }
  }
  EXPECT_EQ(this->mismatches_, 0);
}

/// 26 formats: 2.08 million operand pairs for each operation.
TYPED_TEST(FltAgainstMpfr, RandomOperandsAgree) {
  for (int trial = 0; trial < 80000; ++trial) {
    const double a = this->operands_.any();
    const double b = this->operands_.partner(a);
    for (const Operation operation : operations) {
      const bool convert = operation == Operation::convert;
      const bool root = operation == Operation::square_root;
      this->expect_same(operation, convert ? this->operands_.to_convert() : root ? std::abs(a) : a, b);
    }
  }
  EXPECT_EQ(this->mismatches_, 0);
}

template <class Number>
class SmallFltAgainstMpfr : public FltAgainstMpfr<Number> {};
using SmallFormats = testing::Types<Flt<2, 2>, Flt<3, 3>, Flt<4, 5>, Flt<5, 3>, Flt<3, 6>>;
TYPED_TEST_SUITE(SmallFltAgainstMpfr, SmallFormats);

TYPED_TEST(SmallFltAgainstMpfr, AllPairsAgree) {
  const std::vector<double> values = this->operands_.all();
  for (const Operation operation : operations) {
    for (const double a : values) {
      for (const double b : values) this->expect_same(operation, a, b);
    }
  }
  EXPECT_EQ(this->mismatches_, 0);
}

/// 1867833 * 18837001 = 2^45 + 1: half the smallest subnormal number and a little more, which double cannot hold there.
TEST(Flt, TinyProductsOfTheWidestExponentAreRoundedOnce) {
  MpfrOracle oracle(11, 25);
  const double a = std::ldexp(1867833.0, -546);
  const double b = std::ldexp(18837001.0, -1047 - 45 + 546);
  const Outcome exact = oracle(Operation::multiply, a, b);
  EXPECT_EQ(exact.value, 0x1p-1046);
  EXPECT_EQ(text(outcome<Flt<11, 25>>(Operation::multiply, a, b)), text(exact));
}

/// In double the value just above the midpoint of 1 and 1 + 2^-7 becomes the midpoint, which would go to 1.
TEST(Flt, LongIntegersAreRoundedOnce) {
  const std::int64_t midpoint = (std::int64_t{1} << 62) + (std::int64_t{1} << 54);
  EXPECT_EQ(static_cast<double>(Bf16(midpoint)), 0x1p62);
  EXPECT_EQ(static_cast<double>(Bf16(midpoint + 1)), 0x1.02p62);
  EXPECT_EQ(static_cast<double>(Bf16(-midpoint - 1)), -0x1.02p62);
  EXPECT_EQ(static_cast<double>(Bf16(std::numeric_limits<std::int64_t>::min())), -0x1p63);
  EXPECT_EQ(static_cast<double>(Bf16(std::numeric_limits<std::uint64_t>::max())), 0x1p64);
  EXPECT_EQ(static_cast<double>(Fp16(65520)), std::numeric_limits<double>::infinity());
  EXPECT_EQ(static_cast<double>(Fp16(-7)), -7);
}

TEST(Flt, NamedFormatsHaveTheirStandardsLimits) {
  using Single = std::numeric_limits<Flt<8, 24>>;
  using Float = std::numeric_limits<float>;
  EXPECT_EQ(static_cast<double>(std::numeric_limits<Fp16>::max()), 65504);
  EXPECT_EQ(static_cast<double>(std::numeric_limits<Fp16>::denorm_min()), 0x1p-24);
  EXPECT_EQ(static_cast<double>(std::numeric_limits<Bf16>::max()), 0x1.fep127);
  EXPECT_EQ(static_cast<double>(std::numeric_limits<Tf32>::epsilon()), 0x1p-10);
  EXPECT_EQ(static_cast<double>(std::numeric_limits<Fp24>::min()), 0x1p-62);
  EXPECT_EQ(static_cast<float>(Single::max()), Float::max());
  EXPECT_EQ(static_cast<float>(Single::denorm_min()), Float::denorm_min());
  EXPECT_EQ(Single::max_exponent, Float::max_exponent);
  EXPECT_EQ(Single::min_exponent, Float::min_exponent);
}

}  // namespace
}  // namespace pyrasim
