// SPDX-License-Identifier: Apache-2.0
#include "surface/quadric_steps.h"

#include <algorithm>
#include <cmath>

namespace pyrasim {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::array<Bounded, 3> bounded(const Vector<double>& v, const Vector<double>& errors) {
  return {Bounded{v.x, errors.x}, Bounded{v.y, errors.y}, Bounded{v.z, errors.z}};
}

/// A sign is exact, and so is the product with it.
Bounded times(double sign, const Bounded& p) { return {sign * p.value, std::abs(sign) * p.error}; }

DistanceRange range_of(const Bounded& t) { return {t.value - t.error, t.value + t.error}; }

}  // namespace

QuadricSteps::QuadricSteps(const QuadricForm<double>& form, const Vector<double>& direction,
                           const QuadricErrors& errors, const RoundingUnits& rounding)
    : form_(form),
      u_(rounding.relative),
      absolute_(rounding.absolute),
      m_(bounded(form.turned(direction), errors.direction)),
      origin_(bounded(form.origin, errors.origin)),
      linear_{form.linear, errors.linear},
      constant_{form.constant, errors.constant},
      c_{form.power, errors.power} {
  signed_m_ = {times(form.signs.x, m_[0]), times(form.signs.y, m_[1]), times(form.signs.z, m_[2])};
  a_ = dot_product(signed_m_, m_);
  b_ = dot_product(signed_m_, origin_);
  if (form.linear != 0) b_ = sum(b_, product(linear_, m_[2]));
  const bool same_signs = (a_.value > 0) == (c_.value > 0) && a_.value != 0 && c_.value != 0;
  discriminant_ = same_signs ? by_moment() : by_powers();
  const bool other_sign = !(std::abs(a_.value) > a_.error && std::abs(c_.value) > c_.error);
  if (other_sign) discriminant_.error = std::max(by_moment().error, by_powers().error);
}

Bounded QuadricSteps::sum(const Bounded& p, const Bounded& q) const {
  const double value = p.value + q.value;
  return {value, p.error + q.error + u_ * (std::abs(value) + p.error + q.error)};
}

Bounded QuadricSteps::product(const Bounded& p, const Bounded& q) const {
  const double value = p.value * q.value;
  const double error = std::abs(p.value) * q.error + p.error * (std::abs(q.value) + q.error);
  if (value == 0 && error == 0) return {0, 0};
  return {value, error + u_ * (std::abs(value) + error) + absolute_};
}

/// In the order of dot().
Bounded QuadricSteps::dot_product(const std::array<Bounded, 3>& p, const std::array<Bounded, 3>& q) const {
  return sum(product(p[0], q[0]), sum(product(p[1], q[1]), product(p[2], q[2])));
}

Bounded QuadricSteps::moment(std::size_t i, std::size_t j) const {
  return sum(product(origin_[i], m_[j]), times(-1, product(origin_[j], m_[i])));
}

Bounded QuadricSteps::by_powers() const { return sum(product(b_, b_), times(-1, product(a_, c_))); }

Bounded QuadricSteps::by_moment() const {
  const Vector<double>& s = form_.signs;
  const std::array<Bounded, 3> moments{moment(1, 2), moment(2, 0), moment(0, 1)};
  const std::array<Bounded, 3> signed_moments{times(s.y * s.z, moments[0]), times(s.x * s.z, moments[1]),
                                              times(s.x * s.y, moments[2])};
  const Bounded negative = sum(dot_product(signed_moments, moments), product(a_, constant_));
  if (form_.linear == 0) return times(-1, negative);
  const Bounded across = sum(product(signed_m_[1], moments[0]), times(-1, product(signed_m_[0], moments[1])));
  const Bounded part = product(linear_, sum(product(linear_, product(m_[2], m_[2])), times(2, across)));
  return sum(times(-1, negative), part);
}

/// A root errs by its square's error over twice the root, or by that error's root where it is about 0.
Bounded QuadricSteps::half_chord() const {
  const double value = std::sqrt(std::max(discriminant_.value, 0.0));
  const double square_error = discriminant_.error;
  const bool small = discriminant_.value < 2 * square_error;
  const double error = small ? std::sqrt(std::max(square_error, discriminant_.value + square_error))
                             : square_error / (value + std::sqrt(discriminant_.value - square_error));
  return {value, error + u_ * (value + error) + absolute_};
}

Bounded QuadricSteps::quotient(const Bounded& numerator, const Bounded& denominator) const {
  const double value = numerator.value / denominator.value;
  const double least = std::abs(denominator.value) - denominator.error;
  const double error = (numerator.error + std::abs(value) * denominator.error) / least;
  return {value, error + u_ * (std::abs(value) + error) + absolute_};
}

QuadricRootRanges QuadricSteps::roots(const StretchRanges& kept) const {
  const Bounded root = half_chord();
  const Bounded size = sum({std::abs(b_.value), b_.error}, root);
  const Bounded h = times(b_.value < 0 ? 1 : -1, size);
  const bool sign_known = std::abs(a_.value) > a_.error;
  QuadricRootRanges result{.certain = discriminant_.value > discriminant_.error,
                           .possible = discriminant_.value >= -discriminant_.error,
                           .shapeless = false,
                           .outside = a_.value < 0,
                           .inside_without_roots = c_.value <= 0,
                           .first = {-infinity, -infinity},
                           .last = {infinity, infinity}};
  if (!(size.value > size.error)) {
    result.shapeless = !sign_known;
    const double most = (size.value + size.error) / (std::abs(a_.value) - a_.error) * (1 + 4 * u_) + absolute_;
    result.first = result.last = {-most, most};
    return result;
  }
  const DistanceRange inner = form_.power == 0 ? DistanceRange{0, 0} : range_of(quotient(c_, h));
  if (!sign_known) {
    // It runs along a generator, nearly: there is one root, and another one far away, ahead or behind.
    const double away = (size.value - size.error) / (std::abs(a_.value) + a_.error) * (1 - 4 * u_) - absolute_;
    result.shapeless = !(kept.begin.lowest > -away && kept.end.highest < away);
    result.outside = false;
    (h.value > 0 ? result.first : result.last) = inner;
    return result;
  }
  const DistanceRange outer = range_of(quotient(h, a_));
  result.first = earlier(inner, outer);
  result.last = later(inner, outer);
  return result;
}

}  // namespace pyrasim
