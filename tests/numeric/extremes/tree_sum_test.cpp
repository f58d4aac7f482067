// SPDX-License-Identifier: Apache-2.0
// Extremes: the trace tree's sum is the rational mean of its terminal nodes, rounded once.
#include <gmp.h>

#include <cmath>
#include <limits>

#include "formats.h"
#include "pyramid/trace_tree.h"

namespace pyrasim {
namespace {

/// A fraction of whole numbers of any size.
class Rational {
 public:
  Rational() { mpq_init(value_); }
  explicit Rational(double x) : Rational() { mpq_set_d(value_, x); }
  Rational(const Rational&) = delete;
  Rational& operator=(const Rational&) = delete;
  ~Rational() { mpq_clear(value_); }

  /// Adds numerator * 2^-exponent.
  void add(std::int64_t numerator, unsigned exponent) {
    Rational term;
    mpq_set_si(term.value_, numerator, 1);
    mpq_div_2exp(term.value_, term.value_, exponent);
    mpq_add(value_, value_, term.value_);
  }
  /// |a - b| compared with |c - b|.
  static int compare_distances(const Rational& a, const Rational& b, const Rational& c) {
    Rational first;
    Rational second;
    mpq_sub(first.value_, a.value_, b.value_);
    mpq_abs(first.value_, first.value_);
    mpq_sub(second.value_, c.value_, b.value_);
    mpq_abs(second.value_, second.value_);
    return mpq_cmp(first.value_, second.value_);
  }

 private:
  mpq_t value_;
};

/// No other float is nearer, and between two equally near it is the even one.
void expect_nearest(float result, const Rational& exact) {
  for (const float end : {-std::numeric_limits<float>::infinity(), std::numeric_limits<float>::infinity()}) {
    const float other = std::nextafter(result, end);
    const int order = Rational::compare_distances(Rational(result), exact, Rational(other));
    ASSERT_LE(order, 0) << result;
    if (order == 0) {
      int exponent = 0;
      const float significand = std::ldexp(std::frexp(result, &exponent), 24);
      ASSERT_EQ(std::fmod(significand, 2.0F), 0) << result;
    }
  }
}

/// A tree split at random down to `max_level`, every node's color by `color`; its sum against the fraction.
template <class Color>
void expect_mean_of_random_tree(Random& random, int max_level, const Color& color) {
  TraceTree tree;
  Rational mean;
  const auto terminal = [&](std::uint32_t level) {
    const FixedColor value = color();
    tree.add_terminal_node(static_cast<std::uint32_t>(max_level) - level, value);
    mean.add(value[0], static_cast<unsigned>(fixed_color_bits) + 2 * level);
  };
  std::uint32_t level = 0;
  int open = 1;  // nodes of `level` that are not yet decided
  while (open > 0) {
    const int split = static_cast<int>(level) == max_level ? 0 : static_cast<int>(1 + random.below(2));
    const int splits = std::min(split, open);
    for (int k = splits; k < open; ++k) terminal(level);
    open = 4 * splits;
    ++level;
  }
  ASSERT_TRUE(tree.complete(max_level));
  expect_nearest(tree.result(max_level).x, mean);
}

TEST(ExtremesTreeSum, EqualsTheRationalMeanRoundedOnce) {
  Random random(14);
  for (int max_level = 0; max_level <= max_level_limit; ++max_level) {
    for (int k = 0; k < 300; ++k) {
      const double brightest = k % 3 == 0 ? max_color : std::exp2(-static_cast<double>(k % 40));
      expect_mean_of_random_tree(random, max_level, [&] {
        const auto value = std::llrint(std::ldexp(random.uniform(0, brightest), fixed_color_bits));
        return FixedColor{value, 0, 0};
      });
    }
  }
}

/// Sums beside the midpoint of two floats, by less than a double can say: rounded to double on the way, they would be
/// rounded to even where the exact mean lies above.
TEST(ExtremesTreeSum, IsNotRoundedTwice) {
  constexpr std::int64_t one = std::int64_t{1} << fixed_color_bits;
  for (int max_level = 3; max_level <= max_level_limit; ++max_level) {
    TraceTree tree;
    Rational mean;
    const std::int64_t midpoint = one + (one >> 24);  // between 1 and the next float
    for (std::uint32_t level = 1; static_cast<int>(level) <= max_level; ++level) {
      for (int k = 0; k < (static_cast<int>(level) == max_level ? 4 : 3); ++k) {
        const bool last = static_cast<int>(level) == max_level && k == 3;
        const std::int64_t value = midpoint + (last ? 1 : 0);
        tree.add_terminal_node(static_cast<std::uint32_t>(max_level) - level, {value, value, value});
        mean.add(value, static_cast<unsigned>(fixed_color_bits) + 2 * level);
      }
    }
    EXPECT_EQ(tree.result(max_level).x, std::nextafter(1.0F, 2.0F));
    expect_nearest(tree.result(max_level).x, mean);
  }
  const std::int64_t above =
      (std::int64_t{2048} << fixed_color_bits) + (std::int64_t{2048} << (fixed_color_bits - 24)) + 1;
  EXPECT_EQ(single_node_result({above, 0, 0}).x, std::nextafter(2048.0F, 4096.0F));
}

}  // namespace
}  // namespace pyrasim
