// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "numeric/compensated.h"

namespace pyrasim {

/// A sum of doubles without rounding: an expansion of parts that do not overlap (Shewchuk, Adaptive precision
/// floating-point arithmetic and fast robust geometric predicates, Discrete & Computational Geometry 18, 1997,
/// theorem 10).
class ExactSum {
 public:
  void add(double value) {
    std::size_t kept = 0;
    for (const double part : parts_) {
      const double sum = value + part;
      const double error = sum_error(value, part, sum);
      if (error != 0) parts_[kept++] = error;
      value = sum;
    }
    parts_.resize(kept);
    if (value != 0) parts_.push_back(value);
  }

  /// Adds a * b, whose rounding error must not underflow.
  void add_product(double a, double b) {
    const double product = a * b;
    add(product_error(a, b, product));
    add(product);
  }

  /// -1, 0 or 1.
  int sign() const { return parts_.empty() ? 0 : parts_.back() < 0 ? -1 : 1; }

 private:
  std::vector<double> parts_;  ///< by magnitude, the largest last; none is 0
};

}  // namespace pyrasim
