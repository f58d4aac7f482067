// SPDX-License-Identifier: Apache-2.0
// From a number format chosen when the program runs to the type that computes in it.
#pragma once

#include <stdexcept>
#include <type_traits>

#include "numeric/format_scope.h"

namespace pyrasim {

/// visitor(std::type_identity<Number>()) for the type that computes in `format`, and while that is set. Instantiates
/// the visitor for every type. Throws std::logic_error if the format is not within its limits.
template <class Visitor>
decltype(auto) with_number_type(const NumberFormat& format, Visitor visitor) {
  switch (format.kind) {
    case NumberKind::floating: {
      const FormatScope<Flt> scope(format);
      return visitor(std::type_identity<Flt>());
    }
    case NumberKind::fixed: {
      const FormatScope<Fix> scope(format);
      return visitor(std::type_identity<Fix>());
    }
    case NumberKind::processor:
      break;
  }
  if (format == NumberFormat::single()) return visitor(std::type_identity<float>());
  if (format != NumberFormat()) throw std::logic_error("the processor has no number format " + format.name());
  return visitor(std::type_identity<double>());
}

}  // namespace pyrasim
