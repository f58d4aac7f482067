// SPDX-License-Identifier: Apache-2.0
// Real numbers for oracles: MPFR with so many bits that its own roundings do not count.
#pragma once

#include <mpfr.h>

#include <algorithm>
#include <cmath>
#include <compare>
#include <utility>

#include "numeric/format_scope.h"
#include "numeric/scalar.h"

namespace pyrasim {

/// A number of 512 significant bits. Doubles are taken exactly.
class Real {
 public:
  static constexpr mpfr_prec_t bits = 512;

  Real() { mpfr_init2(value_, bits); }
  Real(double x) : Real() { mpfr_set_d(value_, x, MPFR_RNDN); }  // NOLINT(google-explicit-constructor): exact
  Real(const Real& other) : Real() { mpfr_set(value_, other.value_, MPFR_RNDN); }
  Real(Real&& other) noexcept : Real() { mpfr_swap(value_, other.value_); }
  Real& operator=(const Real& other) {
    mpfr_set(value_, other.value_, MPFR_RNDN);
    return *this;
  }
  Real& operator=(Real&& other) noexcept {
    mpfr_swap(value_, other.value_);
    return *this;
  }
  ~Real() { mpfr_clear(value_); }

  friend Real operator+(const Real& a, const Real& b) { return computed(mpfr_add, a, b); }
  friend Real operator-(const Real& a, const Real& b) { return computed(mpfr_sub, a, b); }
  friend Real operator*(const Real& a, const Real& b) { return computed(mpfr_mul, a, b); }
  friend Real operator/(const Real& a, const Real& b) { return computed(mpfr_div, a, b); }
  friend Real operator-(const Real& a) { return Real(0) - a; }
  friend Real sqrt(const Real& a) {
    Real result;
    mpfr_sqrt(result.value_, a.value_, MPFR_RNDN);
    return result;
  }
  friend Real abs(const Real& a) { return a < Real(0) ? -a : a; }

  friend bool operator==(const Real& a, const Real& b) { return mpfr_equal_p(a.value_, b.value_) != 0; }
  friend std::weak_ordering operator<=>(const Real& a, const Real& b) { return mpfr_cmp(a.value_, b.value_) <=> 0; }

  explicit operator double() const { return mpfr_get_d(value_, MPFR_RNDN); }

 private:
  static Real computed(int (*operation)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t), const Real& a, const Real& b) {
    Real result;
    operation(result.value_, a.value_, b.value_, MPFR_RNDN);
    return result;
  }

  mpfr_t value_;
};

struct RealVector {
  Real x, y, z;
};

template <class Scalar>
RealVector real(const Vector<Scalar>& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

inline Real dot(const RealVector& a, const RealVector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// The distance between neighbouring values of `Scalar` about `x`: one unit in the last place.
template <class Scalar>
double spacing(double x) {
  const NumberFormat format = format_of<Scalar>();
  if (format.kind == NumberKind::fixed) return std::ldexp(1.0, -format.fraction_bits);
  const int smallest_exponent = 2 - (1 << static_cast<unsigned>(format.exponent_bits - 1));
  return std::ldexp(1.0, std::max(std::ilogb(x), smallest_exponent) + 1 - format.significand_bits);
}

/// By how many units in the last place of the exact value a result errs.
template <class Scalar>
double error_in_ulp(Scalar result, const Real& exact) {
  const Real error = abs(Real(static_cast<double>(result)) - exact);
  return static_cast<double>(error / Real(spacing<Scalar>(static_cast<double>(exact))));
}

}  // namespace pyrasim
