// SPDX-License-Identifier: Apache-2.0
#include "numeric/number_format.h"

#include <gtest/gtest.h>

#include <set>

#include "../error_of.h"
#include "error.h"
#include "numeric/number_types.h"

namespace pyrasim {
namespace {

void expect_its_name_and_type(const NumberFormat& format) {
  EXPECT_EQ(parse_number_format(format.name()), format) << format.name();
  EXPECT_EQ(with_number_type(format, []<class Number>(std::type_identity<Number>) { return format_of<Number>(); }),
            format);
}

TEST(NumberFormat, EveryFormatHasANameOfItsOwnThatLeadsBackToItAndToItsType) {
  std::set<std::string> names;
  for (const NumberFormat& format : number_formats()) {
    EXPECT_TRUE(names.insert(format.name()).second) << format.name();
    expect_its_name_and_type(format);
  }
  EXPECT_EQ(names.size(), 35U);
  EXPECT_EQ(number_formats().front().name(), "double");
  for (int e = min_exponent_bits; e <= max_exponent_bits; ++e) {
    for (int p = min_significand_bits; p <= max_significand_bits; ++p) {
      expect_its_name_and_type(NumberFormat::floating(e, p));
    }
  }
  for (int w = min_fixed_bits; w <= max_fixed_bits; ++w) {
    for (int f = 0; f < w; ++f) expect_its_name_and_type(NumberFormat::fixed(w, f));
  }
}

TEST(NumberFormat, WidthsAreThoseOfTheName) {
  EXPECT_EQ(parse_number_format("double"), NumberFormat());
  EXPECT_EQ(parse_number_format("float"), (NumberFormat{NumberKind::processor, 32, 8, 24, 0}));
  EXPECT_EQ(parse_number_format("fp16"), (NumberFormat{NumberKind::floating, 16, 5, 11, 0}));
  EXPECT_EQ(parse_number_format("bf16"), (NumberFormat{NumberKind::floating, 16, 8, 8, 0}));
  EXPECT_EQ(parse_number_format("tf32"), (NumberFormat{NumberKind::floating, 19, 8, 11, 0}));
  EXPECT_EQ(parse_number_format("fp24"), (NumberFormat{NumberKind::floating, 24, 7, 17, 0}));
  EXPECT_EQ(parse_number_format("e6p13"), (NumberFormat{NumberKind::floating, 19, 6, 13, 0}));
  EXPECT_EQ(parse_number_format("fix48.20"), (NumberFormat{NumberKind::fixed, 48, 0, 47, 20}));
  EXPECT_EQ(parse_number_format("fix37.0"), (NumberFormat{NumberKind::fixed, 37, 0, 36, 0}));
}

TEST(NumberFormat, SystematicNamesOfNamedFormatsMeanTheSame) {
  EXPECT_EQ(parse_number_format("e5p11"), fp16);
  EXPECT_EQ(parse_number_format("e8p8"), bf16);
  EXPECT_EQ(parse_number_format("e8p11"), tf32);
  EXPECT_EQ(parse_number_format("e7p17").name(), "fp24");
}

TEST(NumberFormat, UnknownNamesAreRefusedAndTheLimitsTold) {
  for (const char* name :
       {"",        "half",     "e8p",      "ep8",     "E8P12",   "e8p12 ",        " double", "e8p26",  "e8p1",
        "e1p8",    "e12p8",    "e11p53",   "e08p12",  "e8p012",  "e+8p12",        "e-8p12",  "e8p-12", "e8p12.5",
        "fix64",   "fix64.64", "fix65.1",  "fix1.0",  "fix",     "fix.12",        "fix8.-1", "fix8.8", "fix032.16",
        "fix8.+1", "fix8.00",  "fix8.1p2", "fix8,12", "fix 8.1", "e99999999999p8"}) {
    const std::string message = error_of<UsageError>([&] { parse_number_format(name); });
    const std::string shown = *name == 0 ? "(empty)" : name;
    EXPECT_EQ(message, "number format " + shown +
                           ": double or float or fp16 or bf16 or tf32 or fp24 or eEpP, E from 2 to 11 and P from 2 to "
                           "25, or fixW.F, W from 2 to 64 and F from 0 to W - 1, is allowed");
  }
}

TEST(NumberFormat, BeyondTheLimitsThereIsNoType) {
  const auto visit = [](const NumberFormat& format) {
    return error_of<std::logic_error>([&] { with_number_type(format, [](auto) {}); });
  };
  EXPECT_EQ(visit(NumberFormat::fixed(65, 1)), "Fix has no format fix65.1");
  EXPECT_EQ(visit(NumberFormat::fixed(16, 16)), "Fix has no format fix16.16");
  EXPECT_EQ(visit(NumberFormat::floating(8, 26)), "Flt has no format e8p26");
  EXPECT_EQ(visit({NumberKind::processor, 80, 15, 64, 0}), "the processor has no number format e15p64");
}

}  // namespace
}  // namespace pyrasim
