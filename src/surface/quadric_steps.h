// SPDX-License-Identifier: Apache-2.0
// QuadricForm::along() and QuadricRoots step by step, each with its error.
#pragma once

#include "surface/error_bounds.h"
#include "surface/quadric_form.h"
#include "surface/quadric_range.h"

namespace pyrasim {

/// By how much the numbers that enter err.
struct QuadricErrors {
  Vector<double> direction;  ///< of m, the ray's direction in the quadric's frame
  Vector<double> origin;     ///< of o
  double linear;
  double constant;
  double power;
};

/// The roots of a quadric along a ray with what a datapath of `rounding` may make of them.
class QuadricSteps {
 public:
  QuadricSteps(const QuadricForm<double>& form, const Vector<double>& direction, const QuadricErrors& errors,
               const RoundingUnits& rounding);

  /// `kept`: what planes leave of the ray.
  QuadricRootRanges roots(const StretchRanges& kept) const;
  /// The discriminant known better than double works it out.
  void set_discriminant(double value) { discriminant_.value = value; }

 private:
  Bounded sum(const Bounded& p, const Bounded& q) const;
  Bounded product(const Bounded& p, const Bounded& q) const;
  Bounded dot_product(const std::array<Bounded, 3>& p, const std::array<Bounded, 3>& q) const;
  Bounded moment(std::size_t i, std::size_t j) const;
  Bounded by_powers() const;
  Bounded by_moment() const;
  Bounded half_chord() const;
  Bounded quotient(const Bounded& numerator, const Bounded& denominator) const;

  const QuadricForm<double>& form_;
  double u_;
  double absolute_;
  std::array<Bounded, 3> m_;
  std::array<Bounded, 3> signed_m_;
  std::array<Bounded, 3> origin_;
  Bounded linear_;
  Bounded constant_;
  Bounded a_;
  Bounded b_;
  Bounded c_;
  Bounded discriminant_;
};

}  // namespace pyrasim
