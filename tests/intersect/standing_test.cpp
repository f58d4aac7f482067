// SPDX-License-Identifier: Apache-2.0
// Hits that lie clearly apart are told apart by their errors' bounds; others are left to who looks at each one's range.
#include "intersect/standing.h"

#include <gtest/gtest.h>

#include <vector>

namespace pyrasim {
namespace {

struct Entry {
  double t;
  double relative_error;
};

/// Enters the hits as spheres 0, 1, 2 ...
ClearStanding<double> standing_of(const std::vector<Entry>& entries) {
  ClearStanding<double> standing;
  for (std::uint32_t k = 0; k < entries.size(); ++k) {
    standing.enter({entries[k].t, kind_of<SphereSurface>, k}, entries[k].relative_error);
  }
  return standing;
}

/// From 0.99 to 1.01 and from 1.0506 to 1.0914: a gap lies between.
TEST(ClearStanding, TheNearerLeadsWhateverCameFirst) {
  const Entry near{1, 0.01};
  const Entry far{1.071, 0.019};
  const ClearStanding<double> near_first = standing_of({near, far});
  EXPECT_FALSE(near_first.undecided());
  EXPECT_EQ(near_first.leader()->index, 0U);
  EXPECT_EQ(near_first.highest(), 1.01);
  const ClearStanding<double> far_first = standing_of({far, near});
  EXPECT_FALSE(far_first.undecided());
  EXPECT_EQ(far_first.leader()->index, 1U);
  EXPECT_EQ(far_first.highest(), 1.01);
}

/// The range of one reaches up to the other's, and be it that of the less certain alone: 1.02 may be 1.0.
TEST(ClearStanding, NobodyLeadsWhereRangesMeet) {
  const std::vector<std::vector<Entry>> pairs{{{1, 0.01}, {1, 0.01}},
                                              {{1, 0.01}, {1.015, 0.01}},
                                              {{1, 0.001}, {1.02, 0.02}},
                                              {{1, 0.02}, {1.015, 0.001}},
                                              {{1, 0}, {1, 0}}};
  for (const auto& pair : pairs) {
    EXPECT_TRUE(standing_of({pair[0], pair[1]}).undecided()) << pair[1].t;
    EXPECT_TRUE(standing_of({pair[1], pair[0]}).undecided()) << pair[1].t;
  }
}

TEST(ClearStanding, NobodyLeadsBeforeTheFirstHit) {
  const ClearStanding<double> none = standing_of({});
  EXPECT_FALSE(none.undecided());
  EXPECT_EQ(none.leader(), nullptr);
}

}  // namespace
}  // namespace pyrasim
