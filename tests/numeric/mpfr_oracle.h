// SPDX-License-Identifier: Apache-2.0
// The result of one operation in any IEEE 754 binary format, and what is to be said of it, by MPFR.
#pragma once

#include <mpfr.h>

#include <cmath>
#include <cstdint>

#include "numeric/arithmetic_events.h"

namespace pyrasim {

enum class Operation : std::uint8_t { add, subtract, multiply, divide, square_root, convert };

struct Outcome {
  double value;
  ArithmeticEvents events;
};

/// Holds MPFR's variables; MPFR's exponent range is a global of the thread, and is wide again after each call.
class MpfrOracle {
 public:
  MpfrOracle(int exponent_bits, int significand_bits)
      : largest_exponent_((1 << (exponent_bits - 1)) - 1), significand_bits_(significand_bits) {
    mpfr_inits2(53, a_, b_, static_cast<mpfr_ptr>(nullptr));
    mpfr_inits2(significand_bits, result_, cut_, static_cast<mpfr_ptr>(nullptr));
  }
  MpfrOracle(const MpfrOracle&) = delete;
  MpfrOracle& operator=(const MpfrOracle&) = delete;
  ~MpfrOracle() { mpfr_clears(a_, b_, result_, cut_, static_cast<mpfr_ptr>(nullptr)); }

  /// The operation on values of the format; `convert` takes any double `a`. `b` counts where there are two operands.
  Outcome operator()(Operation operation, double a, double b) {
    mpfr_set_d(a_, a, MPFR_RNDN);
    mpfr_set_d(b_, b, MPFR_RNDN);
    mpfr_clear_flags();
    int ternary = compute(operation, result_, MPFR_RNDN);
    ArithmeticEvents events;
    const bool two = operation != Operation::square_root && operation != Operation::convert;
    if (operation == Operation::divide && b == 0 && std::isfinite(a)) {
      events.divisions_by_zero = 1;
    } else if (mpfr_nan_p(result_) != 0 && !std::isnan(a) && !(two && std::isnan(b))) {
      events.invalid = 1;
    }
    const auto [first, last] = std::pair{mpfr_get_emin(), mpfr_get_emax()};
    mpfr_set_emin(1 - largest_exponent_ - significand_bits_ + 2);  // MPFR's significands lie in [1/2, 1)
    mpfr_set_emax(largest_exponent_ + 1);
    ternary = mpfr_check_range(result_, ternary, MPFR_RNDN);
    ternary = mpfr_subnormalize(result_, ternary, MPFR_RNDN);
    events.saturations = mpfr_overflow_p() != 0 ? 1 : 0;
    events.inexact = ternary != 0 ? 1 : 0;
    mpfr_set_emin(first);
    mpfr_set_emax(last);
    if (ternary != 0 && is_tiny(operation)) events.underflows = 1;
    return {mpfr_get_d(result_, MPFR_RNDN), events};
  }

 private:
  int compute(Operation operation, mpfr_ptr result, mpfr_rnd_t rounding) {
    switch (operation) {
      case Operation::add:
        return mpfr_add(result, a_, b_, rounding);
      case Operation::subtract:
        return mpfr_sub(result, a_, b_, rounding);
      case Operation::multiply:
        return mpfr_mul(result, a_, b_, rounding);
      case Operation::divide:
        return mpfr_div(result, a_, b_, rounding);
      case Operation::square_root:
        return mpfr_sqrt(result, a_, rounding);
      case Operation::convert:
        break;
    }
    return mpfr_set(result, a_, rounding);
  }

  /// Whether the exact result is less than the smallest normal number: cutting does not reach that from below.
  bool is_tiny(Operation operation) {
    compute(operation, cut_, MPFR_RNDZ);
    return mpfr_zero_p(cut_) != 0 || (mpfr_regular_p(cut_) != 0 && mpfr_get_exp(cut_) < 2 - largest_exponent_);
  }

  int largest_exponent_;
  int significand_bits_;
  mpfr_t a_, b_, result_, cut_;
};

}  // namespace pyrasim
