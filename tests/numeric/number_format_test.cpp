// SPDX-License-Identifier: Apache-2.0
#include "numeric/number_format.h"

#include <gtest/gtest.h>

#include <set>

#include "../error_of.h"
#include "error.h"
#include "numeric/number_types.h"

namespace pyrasim {
namespace {

TEST(NumberFormat, EveryFormatHasANameOfItsOwnThatLeadsBackToItAndToItsType) {
  std::set<std::string> names;
  for (const NumberFormat& format : number_formats()) {
    EXPECT_TRUE(names.insert(format.name()).second) << format.name();
    EXPECT_EQ(parse_number_format(format.name()), format) << format.name();
    const int digits = with_number_type(
        format, []<class Number>(std::type_identity<Number>) { return std::numeric_limits<Number>::digits; });
    EXPECT_EQ(digits, format.significand_bits) << format.name();
  }
  EXPECT_EQ(number_formats().front().name(), "double");
}

TEST(NumberFormat, WidthsAreThoseOfTheName) {
  EXPECT_EQ(parse_number_format("double"), NumberFormat());
  EXPECT_EQ(parse_number_format("float"), (NumberFormat{NumberKind::processor, 32, 8, 24, 0}));
  EXPECT_EQ(parse_number_format("fp16"), (NumberFormat{NumberKind::floating, 16, 5, 11, 0}));
  EXPECT_EQ(parse_number_format("bf16"), (NumberFormat{NumberKind::floating, 16, 8, 8, 0}));
  EXPECT_EQ(parse_number_format("tf32"), (NumberFormat{NumberKind::floating, 19, 8, 11, 0}));
  EXPECT_EQ(parse_number_format("fp24"), (NumberFormat{NumberKind::floating, 24, 7, 17, 0}));
  EXPECT_EQ(parse_number_format("fix48.20"), (NumberFormat{NumberKind::fixed, 48, 0, 47, 20}));
  for (int p = 8; p <= 25; ++p) {
    EXPECT_EQ(parse_number_format("e8p" + std::to_string(p)), (NumberFormat{NumberKind::floating, 8 + p, 8, p, 0}));
  }
  for (int f = 12; f <= 32; f += 4) {
    EXPECT_EQ(parse_number_format("fix64." + std::to_string(f)), (NumberFormat{NumberKind::fixed, 64, 0, 63, f}));
  }
}

TEST(NumberFormat, UnknownNamesAreRefusedWithTheListOfNames) {
  for (const char* name : {"", "half", "e8p26", "e8p", "E8P12", "fix64", "fix64.13", "e11p53", " double"}) {
    const std::string message = error_of<UsageError>([&] { parse_number_format(name); });
    const std::string shown = *name == 0 ? "(empty)" : name;
    EXPECT_EQ(message.find("number format " + shown + ": double or float or fp16 or bf16 or "), 0U) << message;
    EXPECT_NE(message.find("e8p25 or fix64.12"), std::string::npos) << message;
    EXPECT_TRUE(message.ends_with(" or fix24.12 is allowed")) << message;
  }
}

TEST(NumberFormat, AFormatThatIsNotCompiledInHasNoType) {
  const NumberFormat unknown{NumberKind::fixed, 63, 0, 62, 1};
  const auto visit = [&] { with_number_type(unknown, [](auto) {}); };
  EXPECT_EQ(error_of<std::logic_error>(visit), "number format fix63.1 is not compiled in");
}

}  // namespace
}  // namespace pyrasim
