// SPDX-License-Identifier: Apache-2.0
#include "intersect/contest.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

namespace pyrasim {
namespace {

struct Entry {
  DistanceRange range;
  std::uint32_t order;
};

/// By definition.
std::uint32_t first_not_behind(const std::vector<Entry>& entries) {
  double end = std::numeric_limits<double>::infinity();
  for (const Entry& entry : entries) end = std::min(end, entry.range.highest);
  std::uint32_t first = ~0U;
  for (const Entry& entry : entries) {
    if (entry.range.lowest <= end) first = std::min(first, entry.order);
  }
  return first;
}

/// As a walk does it.
std::uint32_t winner(const std::vector<Entry>& entries, int& walks) {
  Contest contest;
  std::uint32_t leader = ~0U;
  for (;;) {
    ++walks;
    for (const Entry& entry : entries) {
      if (contest.enter(entry.range, {entry.order, 0, 0})) leader = entry.order;
    }
    if (!contest.in_doubt()) return leader;
    contest.repeat();
  }
}

TEST(Contest, NobodyWinsWithoutHits) {
  Contest contest;
  EXPECT_FALSE(contest.in_doubt());
}

TEST(Contest, TheNearerWinsBeyondTheRangesAndTheFirstWithin) {
  int walks = 0;
  EXPECT_EQ(winner({{{1, 2}, 7}, {{2.5, 3}, 1}}, walks), 7U);
  EXPECT_EQ(winner({{{1, 2}, 7}, {{1.5, 3}, 1}}, walks), 1U);
  EXPECT_EQ(winner({{{1, 2}, 7}, {{2, 3}, 1}}, walks), 1U) << "where ranges touch, they meet";
  EXPECT_EQ(winner({{{1, std::numeric_limits<double>::infinity()}, 7}, {{2, 3}, 1}}, walks), 1U);
}

/// a and b meet, b and c do, a and c do not.
TEST(Contest, ChainsAreCutWhereTheNearestEnds) {
  const Entry a{{1, 3}, 2}, b{{2, 5}, 1}, c{{4, 6}, 0};
  int walks = 0;
  std::vector<Entry> entries{a, b, c};
  EXPECT_EQ(winner(entries, walks), 1U) << "c is behind a";
  EXPECT_EQ(winner({b, c}, walks), 0U);
}

/// c leads and has forgotten b when a comes and c falls behind.
TEST(Contest, AForgottenHitIsFoundByAnotherWalk) {
  const Entry a{{1, 3}, 2}, b{{2, 5}, 1}, c{{4, 6}, 0};
  int walks = 0;
  EXPECT_EQ(winner({b, c, a}, walks), 1U);
  EXPECT_EQ(walks, 2);
  walks = 0;
  EXPECT_EQ(winner({a, b, c}, walks), 1U);
  EXPECT_EQ(walks, 1);
}

TEST(Contest, TheOrderInWhichHitsComeDoesNotMatter) {
  std::mt19937_64 random(1);
  int walks = 0;
  int contests = 0;
  for (int k = 0; k < 4000; ++k) {
    std::vector<Entry> entries(2 + random() % 4);
    for (std::uint32_t order = 0; order < entries.size(); ++order) {
      const auto lowest = static_cast<double>(random() % 12);
      entries[order] = {{lowest, lowest + static_cast<double>(random() % 6)}, order};
    }
    const std::uint32_t expected = first_not_behind(entries);
    do {
      ++contests;
      ASSERT_EQ(winner(entries, walks), expected);
    } while (std::next_permutation(entries.begin(), entries.end(),
                                   [](const Entry& p, const Entry& q) { return p.order < q.order; }));
  }
  EXPECT_GT(walks, contests);
  EXPECT_LT(walks, contests * 5 / 4);
}

TEST(Contest, OfOneObjectTheNearerHitWins) {
  Contest contest;
  EXPECT_TRUE(contest.enter({1, 3}, {4, 2, 10}));
  EXPECT_FALSE(contest.enter({2, 4}, {4, 3, 9}));
  EXPECT_TRUE(contest.enter({0, 2}, {4, 1, 12}));
  EXPECT_FALSE(contest.enter({0, 2}, {5, 0.5, 13}));
  EXPECT_TRUE(contest.enter({2, 4}, {3, 3, 8}));
}

TEST(Contest, WhatBeginsBeyondTheNearestEndIsBehind) {
  Contest contest;
  EXPECT_TRUE(contest.enter({4, 6}, {3, 0, 0}));
  EXPECT_EQ(contest.highest(), 6);
  EXPECT_FALSE(contest.enter({3, 5}, {5, 0, 0}));
  EXPECT_EQ(contest.highest(), 5);
  EXPECT_FALSE(contest.enter({5.5, 9}, {1, 0, 0}));
}

}  // namespace
}  // namespace pyrasim
