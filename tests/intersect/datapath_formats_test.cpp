// SPDX-License-Identifier: Apache-2.0
#include "intersect/datapath_formats.h"

#include <gtest/gtest.h>

#include "../test_scenes.h"
#include "camera/view_vector.h"
#include "error.h"

namespace pyrasim {
namespace {

TEST(DatapathFormats, AreReadAsTheyAreWritten) {
  EXPECT_EQ(parse_datapath_formats("double"), DatapathFormats());
  EXPECT_EQ(parse_datapath_formats("fp24"), (DatapathFormats{fp24, fp24}));
  EXPECT_EQ(parse_datapath_formats("intersection=fp24"), (DatapathFormats{{}, fp24}));
  EXPECT_EQ(parse_datapath_formats("view_vectors=fp24"), (DatapathFormats{fp24, {}}));
  EXPECT_EQ(parse_datapath_formats("intersection=fp24,view_vectors=float").name(),
            "view_vectors=float,intersection=fp24");
  for (const NumberFormat& format : number_formats()) {
    for (const DatapathFormats& formats : {DatapathFormats{format, format}, DatapathFormats{format, fp24}}) {
      EXPECT_EQ(parse_datapath_formats(formats.name()), formats);
    }
  }
  for (const char* text : {"", "half", "=", "view_vectors=", "view_vectors=fp24,", "color=fp24", "fp24,fp24",
                           "view_vectors=fp24,view_vectors=fp24"}) {
    EXPECT_THROW(parse_datapath_formats(text), UsageError) << text;
  }
}

TEST(DatapathFormats, OnlySoftwareFormatsCountEvents) {
  EXPECT_TRUE(parse_datapath_formats("double").plain());
  EXPECT_FALSE(parse_datapath_formats("view_vectors=float").plain());
  EXPECT_FALSE(parse_datapath_formats("view_vectors=float").counts_events());
  EXPECT_TRUE(parse_datapath_formats("view_vectors=fp24").counts_events());
  EXPECT_TRUE(parse_datapath_formats("intersection=fix64.20").counts_events());
}

/// Whether no two points of the grid, walked along both axes, have one view vector.
bool tells_points_apart(const NumberFormat& format, const Screen& screen, std::uint32_t steps) {
  const ViewVectors view_vectors(screen, steps, format);
  for (std::uint32_t k = 0; k < steps * static_cast<std::uint32_t>(screen.rows); ++k) {
    if (!(view_vectors({k, 0}).y > view_vectors({k + 1, 0}).y)) return false;
  }
  for (std::uint32_t k = 0; k < steps * static_cast<std::uint32_t>(screen.columns); ++k) {
    if (!(view_vectors({0, k}).z < view_vectors({0, k + 1}).z)) return false;
  }
  return true;
}

/// What is refused has points that fall together; what passes without a warning has none.
TEST(DatapathFormats, AreRefusedWhereFixedPointCannotTellPointsApart) {
  int refused = 0;
  int warned = 0;
  int passed = 0;
  for (const int columns : {40, 300, 2000}) {
    for (const std::uint32_t steps : {1U, 8U, 64U}) {
      const Screen screen{columns, columns / 2 + 1, 1.3, 0.9 / columns, 1.1 / columns};
      for (const NumberFormat& format : number_formats()) {
        SCOPED_TRACE(format.name() + " " + std::to_string(columns) + " " + std::to_string(steps));
        try {
          if (check_addressing({format, {}}, screen, steps)) {
            ++warned;
          } else {
            ++passed;
            EXPECT_TRUE(tells_points_apart(format, screen, steps));
          }
        } catch (const UsageError&) {
          ++refused;
          EXPECT_FALSE(tells_points_apart(format, screen, steps));
        }
      }
    }
  }
  EXPECT_GT(refused, 10);
  EXPECT_GT(warned, 30);
  EXPECT_GT(passed, 100);
}

TEST(DatapathFormats, AreRefusedWhereALongViewVectorOverflows) {
  const Screen wide{64, 48, 1, 2, 2};  // the corner's vector is (1, 48, 64): its squared length 6401 has 13 bits
  const NumberFormat narrow = NumberFormat::fixed(32, 20);
  EXPECT_THROW(check_addressing({narrow, {}}, wide, 1), UsageError);
  EXPECT_THROW(check_addressing({{}, narrow}, wide, 1), UsageError);
  EXPECT_EQ(check_addressing({NumberFormat::fixed(32, 16), {}}, wide, 1), std::nullopt);
}

/// The exponent of fp16: numbers below 2^16, and multiples of 2^-24.
TEST(DatapathFormats, AreRefusedWhereAnExponentIsTooShort) {
  const Screen nearly_a_half_space{64, 48, 1, 8, 8};  // a squared length of 1 + 192^2 + 256^2, which is 2^16.6
  EXPECT_THROW(check_addressing({fp16, {}}, nearly_a_half_space, 1), UsageError);
  EXPECT_NO_THROW(check_addressing({bf16, {}}, nearly_a_half_space, 1));
  const Screen tele{16, 12, 1, 0x1p-24, 0x1p-24};
  EXPECT_NO_THROW(check_addressing({{}, fp16}, tele, 1));
  EXPECT_THROW(check_addressing({{}, fp16}, tele, 2), UsageError);
  EXPECT_FALSE(tells_points_apart(fp16, tele, 2));
}

TEST(DatapathFormats, WarnBelowLogOfThePointsPlusFourBits) {
  const Screen screen{512, 256, 1, 0.001, 0.001};  // times 8 steps: 2^12 points
  EXPECT_EQ(check_addressing({NumberFormat::floating(8, 16), {}}, screen, 8), std::nullopt);
  const auto warning = check_addressing({{}, NumberFormat::floating(8, 15)}, screen, 8);
  ASSERT_TRUE(warning.has_value());
  EXPECT_NE(warning->find("e8p15 for intersection: 15 significand bits are fewer than the 16"), std::string::npos)
      << *warning;
}

}  // namespace
}  // namespace pyrasim
