// SPDX-License-Identifier: Apache-2.0
#include "hw_model/latency_histogram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace pyrasim::hw {
namespace {

using Classes = std::vector<std::pair<Cycle, std::uint64_t>>;

Classes classes_of(const LatencyHistogram& histogram) {
  Classes classes;
  histogram.for_each_class([&](Cycle last, std::uint64_t count) { classes.emplace_back(last, count); });
  return classes;
}

Cycle class_end(Cycle latency) {
  LatencyHistogram histogram;
  histogram.add(latency);
  return classes_of(histogram).at(0).first;
}

/// Latencies of every order of magnitude.
std::vector<Cycle> random_latencies(std::uint64_t seed, std::size_t count, int bits) {
  std::mt19937_64 random(seed);
  std::vector<Cycle> latencies(count);
  for (Cycle& latency : latencies) latency = random() >> (64 - 1 - random() % static_cast<std::uint64_t>(bits));
  return latencies;
}

LatencyHistogram histogram_of(const std::vector<Cycle>& latencies) {
  LatencyHistogram histogram;
  for (const Cycle latency : latencies) histogram.add(latency);
  return histogram;
}

TEST(LatencyHistogram, IsExactBelow32) {
  LatencyHistogram histogram;
  Classes expected;
  for (Cycle latency = 0; latency < 32; ++latency) {
    for (Cycle k = 0; k <= latency; ++k) histogram.add(latency);
    expected.emplace_back(latency, latency + 1);
  }
  EXPECT_EQ(classes_of(histogram), expected);
}

TEST(LatencyHistogram, AClassEndsAtMostASixteenthAboveItsMembers) {
  std::vector<Cycle> latencies = random_latencies(1, 20'000, 63);
  for (int bit = 0; bit < 64; ++bit) {
    const Cycle power = Cycle{1} << bit;
    for (const Cycle latency : {power - 1, power, power + 1}) latencies.push_back(latency);
  }
  latencies.push_back(never);
  for (const Cycle latency : latencies) {
    const Cycle end = class_end(latency);
    ASSERT_GE(end, latency);
    ASSERT_LE(end - latency, latency / 16) << latency;
  }
}

TEST(LatencyHistogram, ClassesFollowOneAnotherWithoutAGap) {
  Cycle end = 0;
  for (int k = 0; k < 900; ++k) {
    const Cycle next = class_end(end + 1);
    ASSERT_GT(next, end);
    EXPECT_EQ(class_end(next), next) << "the class's last belongs to it";
    end = next;
    if (end == never) return;
  }
}

TEST(LatencyHistogram, PercentilesAreAtMostASixteenthAboveThoseOfTheSortedLatencies) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    std::vector<Cycle> latencies = random_latencies(seed, 1 + seed * seed * 3, 30);
    const LatencyHistogram histogram = histogram_of(latencies);
    std::sort(latencies.begin(), latencies.end());
    for (const double share : {1e-9, 0.01, 0.25, 0.5, 0.75, 0.9, 0.99, 1.0}) {
      const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(latencies.size())));
      const Cycle exact = latencies[rank - 1];
      EXPECT_GE(histogram.percentile(share), exact) << seed << ": " << share;
      EXPECT_LE(histogram.percentile(share), exact + exact / 16) << seed << ": " << share;
      EXPECT_LE(histogram.percentile(share), latencies.back());
    }
  }
}

TEST(LatencyHistogram, CountMeanAndMaxAreExact) {
  const std::vector<Cycle> latencies = random_latencies(3, 1000, 40);
  const LatencyHistogram histogram = histogram_of(latencies);
  double sum = 0;
  Cycle max = 0;
  for (const Cycle latency : latencies) {
    sum += static_cast<double>(latency);  // below 2^53: exact
    max = std::max(max, latency);
  }
  EXPECT_EQ(histogram.count(), 1000U);
  EXPECT_EQ(histogram.mean(), sum / 1000);
  EXPECT_EQ(histogram.max(), max);
}

TEST(LatencyHistogram, ASumIsTheHistogramOfAllLatencies) {
  const std::vector<Cycle> a = random_latencies(4, 300, 40);
  const std::vector<Cycle> b = random_latencies(5, 200, 20);
  std::vector<Cycle> all = a;
  all.insert(all.end(), b.begin(), b.end());
  for (const bool swapped : {false, true}) {
    LatencyHistogram sum = histogram_of(swapped ? b : a);
    sum += histogram_of(swapped ? a : b);
    EXPECT_TRUE(sum == histogram_of(all));
    EXPECT_EQ(sum.mean(), histogram_of(all).mean());
  }
}

TEST(LatencyHistogram, OfNothingIsZero) {
  const LatencyHistogram none;
  EXPECT_EQ(none.count(), 0U);
  EXPECT_EQ(none.mean(), 0);
  EXPECT_EQ(none.max(), 0U);
  EXPECT_EQ(none.percentile(0.5), 0U);
  EXPECT_TRUE(classes_of(none).empty());
}

}  // namespace
}  // namespace pyrasim::hw
