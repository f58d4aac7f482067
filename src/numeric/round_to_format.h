// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>

#include "numeric/format_scope.h"

namespace pyrasim {

/// Gives the nearest value of a format, held in double. Counts arithmetic_events. A fixed-point value of more than 53
/// bits comes out as the double nearest to it.
class RoundToFormat {
 public:
  explicit RoundToFormat(const NumberFormat& format);

  double operator()(double x) const {
    if (std::holds_alternative<ScalarFormat<double>>(format_)) return x;
    return std::visit(
        [x]<class Scalar>(const ScalarFormat<Scalar>& format) {
          const FormatScope<Scalar> scope(format);
          return static_cast<double>(static_cast<Scalar>(x));
        },
        format_);
  }

 private:
  std::variant<ScalarFormat<double>, ScalarFormat<float>, ScalarFormat<Flt>, ScalarFormat<Fix>> format_;
};

}  // namespace pyrasim
