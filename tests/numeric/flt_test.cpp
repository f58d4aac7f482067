// SPDX-License-Identifier: Apache-2.0
// Flt against MPFR, bit for bit, with the events that it counts.
#include "numeric/flt.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>

#include "flt_operands.h"
#include "mpfr_oracle.h"
#include "numeric/format_scope.h"

namespace pyrasim {
namespace {

constexpr std::array operations{Operation::add,    Operation::subtract,    Operation::multiply,
                                Operation::divide, Operation::square_root, Operation::convert};

/// In the format set.
Outcome outcome(Operation operation, double a, double b) {
  const auto at = [](double x) { return Flt::from_exact(x); };
  arithmetic_events = {};
  Flt result;
  if (operation == Operation::add) result = at(a) + at(b);
  if (operation == Operation::subtract) result = at(a) - at(b);
  if (operation == Operation::multiply) result = at(a) * at(b);
  if (operation == Operation::divide) result = at(a) / at(b);
  if (operation == Operation::square_root) result = sqrt(at(a));
  if (operation == Operation::convert) result = Flt(a);
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

/// One format.
class Comparison {
 public:
  explicit Comparison(const NumberFormat& format)
      : scope_(format),
        oracle_(format.exponent_bits, format.significand_bits),
        operands_(format.exponent_bits, format.significand_bits,
                  static_cast<std::uint64_t>(1000 * format.exponent_bits + format.significand_bits)) {}

  void corners() {
    for (const Operation operation : operations) {
      for (const double a : operands_.corners()) {
        for (const double b : operands_.corners()) compare(operation, a, b);
      }
    }
  }

  void random_operands(int trials) {
    for (int trial = 0; trial < trials; ++trial) {
      const double a = operands_.any();
      const double b = operands_.partner(a);
      for (const Operation operation : operations) {
        const bool convert = operation == Operation::convert;
        const bool root = operation == Operation::square_root;
        compare(operation, convert ? operands_.to_convert() : root ? std::abs(a) : a, b);
      }
    }
  }

  void all_pairs() {
    const std::vector<double> values = operands_.all();
    for (const Operation operation : operations) {
      for (const double a : values) {
        for (const double b : values) compare(operation, a, b);
      }
    }
  }

  int mismatches() const { return mismatches_; }

 private:
  void compare(Operation operation, double a, double b) {
    const Outcome ours = outcome(operation, a, b);
    const Outcome exact = oracle_(operation, a, b);
    if (same(ours, exact)) return;
    if (++mismatches_ > 5) return;
    ADD_FAILURE() << "operation " << static_cast<int>(operation) << std::hexfloat << " on " << a << " and " << b
                  << ":\n"
                  << text(ours) << "\n"
                  << text(exact) << " by MPFR";
  }

  FormatScope<Flt> scope_;
  int mismatches_ = 0;
  MpfrOracle oracle_;
  FltOperands operands_;
};

std::string format_name(const testing::TestParamInfo<NumberFormat>& test) { return test.param.name(); }

class FltAgainstMpfr : public testing::TestWithParam<NumberFormat> {};

TEST_P(FltAgainstMpfr, CornersAgree) {
  Comparison comparison(GetParam());
  comparison.corners();
  EXPECT_EQ(comparison.mismatches(), 0);
}

/// 26 formats: 2.08 million operand pairs for each operation.
TEST_P(FltAgainstMpfr, RandomOperandsAgree) {
  Comparison comparison(GetParam());
  comparison.random_operands(80000);
  EXPECT_EQ(comparison.mismatches(), 0);
}

std::vector<NumberFormat> formats() {
  std::vector<NumberFormat> formats{fp16, fp24};
  for (int p = 8; p <= 25; ++p) formats.push_back(NumberFormat::floating(8, p));
  for (const auto& [e, p] : {std::pair(11, 25), {11, 11}, {10, 25}, {5, 25}, {4, 4}, {2, 25}}) {
    formats.push_back(NumberFormat::floating(e, p));
  }
  return formats;
}
INSTANTIATE_TEST_SUITE_P(Formats, FltAgainstMpfr, testing::ValuesIn(formats()), format_name);

/// 240 formats: 360 000 operand pairs for each operation.
TEST(Flt, EveryFormatAgreesWithMpfr) {
  for (int e = min_exponent_bits; e <= max_exponent_bits; ++e) {
    for (int p = min_significand_bits; p <= max_significand_bits; ++p) {
      Comparison comparison(NumberFormat::floating(e, p));
      comparison.random_operands(1500);
      ASSERT_EQ(comparison.mismatches(), 0) << e << " " << p;
    }
  }
}

class SmallFltAgainstMpfr : public testing::TestWithParam<NumberFormat> {};

TEST_P(SmallFltAgainstMpfr, AllPairsAgree) {
  Comparison comparison(GetParam());
  comparison.all_pairs();
  EXPECT_EQ(comparison.mismatches(), 0);
}

INSTANTIATE_TEST_SUITE_P(Formats, SmallFltAgainstMpfr,
                         testing::Values(NumberFormat::floating(2, 2), NumberFormat::floating(3, 3),
                                         NumberFormat::floating(4, 5), NumberFormat::floating(5, 3),
                                         NumberFormat::floating(3, 6)),
                         format_name);

/// 1867833 * 18837001 = 2^45 + 1: half the smallest subnormal number and a little more, which double cannot hold there.
TEST(Flt, TinyProductsOfTheWidestExponentAreRoundedOnce) {
  const FormatScope<Flt> scope(NumberFormat::floating(11, 25));
  MpfrOracle oracle(11, 25);
  const double a = std::ldexp(1867833.0, -546);
  const double b = std::ldexp(18837001.0, -1047 - 45 + 546);
  const Outcome exact = oracle(Operation::multiply, a, b);
  EXPECT_EQ(exact.value, 0x1p-1046);
  EXPECT_EQ(text(outcome(Operation::multiply, a, b)), text(exact));
}

/// In double the value just above the midpoint of 1 and 1 + 2^-7 becomes the midpoint, which would go to 1.
TEST(Flt, LongIntegersAreRoundedOnce) {
  const auto held = [](const NumberFormat& format, auto n) {
    const FormatScope<Flt> scope(format);
    return static_cast<double>(Flt(n));
  };
  const std::int64_t midpoint = (std::int64_t{1} << 62) + (std::int64_t{1} << 54);
  EXPECT_EQ(held(bf16, midpoint), 0x1p62);
  EXPECT_EQ(held(bf16, midpoint + 1), 0x1.02p62);
  EXPECT_EQ(held(bf16, -midpoint - 1), -0x1.02p62);
  EXPECT_EQ(held(bf16, std::numeric_limits<std::int64_t>::min()), -0x1p63);
  EXPECT_EQ(held(bf16, std::numeric_limits<std::uint64_t>::max()), 0x1p64);
  EXPECT_EQ(held(fp16, 65520), std::numeric_limits<double>::infinity());
  EXPECT_EQ(held(fp16, -7), -7);
}

TEST(Flt, SmallIntegersAreExactInTheNarrowestFormat) {
  const FormatScope<Flt> scope(NumberFormat::floating(min_exponent_bits, min_significand_bits));
  arithmetic_events = {};
  for (const int n : {-3, -2, -1, 0, 1, 2, 3}) EXPECT_EQ(static_cast<double>(Flt(n)), n);
  EXPECT_EQ(arithmetic_events, ArithmeticEvents());
  EXPECT_EQ(Flt(4), std::numeric_limits<Flt>::infinity());
}

TEST(Flt, NamedFormatsHaveTheirStandardsLimits) {
  using Limits = std::numeric_limits<Flt>;
  using Float = std::numeric_limits<float>;
  const auto limit = [](const NumberFormat& format, Flt (*value)()) {
    const FormatScope<Flt> scope(format);
    return static_cast<double>(value());
  };
  EXPECT_EQ(limit(fp16, Limits::max), 65504);
  EXPECT_EQ(limit(fp16, Limits::denorm_min), 0x1p-24);
  EXPECT_EQ(limit(bf16, Limits::max), 0x1.fep127);
  EXPECT_EQ(limit(tf32, Limits::epsilon), 0x1p-10);
  EXPECT_EQ(limit(fp24, Limits::min), 0x1p-62);
  const NumberFormat single = NumberFormat::floating(8, 24);
  EXPECT_EQ(limit(single, Limits::max), Float::max());
  EXPECT_EQ(limit(single, Limits::lowest), Float::lowest());
  EXPECT_EQ(limit(single, Limits::min), Float::min());
  EXPECT_EQ(limit(single, Limits::denorm_min), Float::denorm_min());
  EXPECT_EQ(limit(single, Limits::epsilon), Float::epsilon());
}

}  // namespace
}  // namespace pyrasim
