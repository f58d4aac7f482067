// SPDX-License-Identifier: Apache-2.0
#include "numeric/flt_edge.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "numeric/arithmetic_events.h"

namespace pyrasim::flt_edge {
namespace {

void require(const FltFormat& format) {
  if (format.exponent_bits() == 0) throw std::logic_error("Flt computes without a format: no FormatScope<Flt>");
}

double overflow(bool negative) {
  ++arithmetic_events.saturations;
  ++arithmetic_events.inexact;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return negative ? -infinity : infinity;
}

/// A result below the normal range; both numbers are `lift` times as large as what they stand for. `inexact`: that the
/// result is not exact although the two are equal.
double tiny(const FltFormat& format, double lifted, double rounded, bool inexact = false) {
  if (inexact || rounded != lifted) {
    ++arithmetic_events.underflows;
    ++arithmetic_events.inexact;
  }
  return rounded / format.lift();
}

/// The result with an operand that is infinite or NaN, or of the root of a negative number.
double special(double result, double a, double b) {
  if (std::isnan(result) && !std::isnan(a) && !std::isnan(b)) ++arithmetic_events.invalid;
  return result;
}

}  // namespace

double convert(const FltFormat& format, double x) {
  require(format);
  const double size = magnitude(x);
  if (!(size > 0 && size <= std::numeric_limits<double>::max())) return x;  // 0, infinity or NaN
  if (size >= format.overflow_threshold()) return overflow(x < 0);
  return tiny(format, x * format.lift(), format.round_tiny(x * format.lift()));
}

/// Sums below the normal range are exact: both operands are multiples of the spacing there.
double add(const FltFormat& format, double a, double b) {
  require(format);
  const double sum = a + b;
  if (!std::isfinite(a) || !std::isfinite(b)) return special(sum, a, b);
  return magnitude(sum) >= format.overflow_threshold() ? overflow(sum < 0) : sum;
}

double multiply(const FltFormat& format, double a, double b) {
  require(format);
  const double product = a * b;
  if (!std::isfinite(a) || !std::isfinite(b)) return special(product, a, b);
  if (magnitude(product) >= format.overflow_threshold()) return overflow(std::signbit(product));
  if (a == 0 || b == 0) return product;
  if (magnitude(a) > magnitude(b)) std::swap(a, b);
  const double lifted = (a * format.lift()) * b;  // exact, or so small that the result is 0 anyway
  return tiny(format, lifted, format.round_tiny(lifted), lifted == 0);
}

double divide(const FltFormat& format, double a, double b) {
  require(format);
  const double quotient = a / b;
  if (std::isfinite(a) && b == 0) {
    ++arithmetic_events.divisions_by_zero;
    return quotient;
  }
  if (!std::isfinite(a) || !std::isfinite(b)) return special(quotient, a, b);
  if (magnitude(quotient) >= format.overflow_threshold()) return overflow(std::signbit(quotient));
  const double lifted_dividend = a * format.lift();  // the quotient is tiny, so that |a| < 8 where it matters
  const double lifted = lifted_dividend / b;
  const double rounded = format.round_tiny(lifted);
  return tiny(format, lifted, rounded, rounded * b != lifted_dividend);
}

double square_root(const FltFormat& format, double x) {
  require(format);
  const double root = std::sqrt(x);
  if (!(x > 0) || !std::isfinite(x)) return special(root, x, x);
  const double rounded = format.round_tiny(root);  // only where the exponent is short for the significand: lift is 1
  return tiny(format, root, rounded, rounded * rounded != x);
}

/// With 11 bits of exponent that of small numbers is not: then both sides are taken 2^128 times as large.
bool is_product(double product, double a, double b) {
  if (magnitude(product) >= 1) return a * b == product;
  if (magnitude(a) > magnitude(b)) std::swap(a, b);
  return (a * power_of_two(128)) * b == product * power_of_two(128);
}

}  // namespace pyrasim::flt_edge
