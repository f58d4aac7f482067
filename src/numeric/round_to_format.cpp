// SPDX-License-Identifier: Apache-2.0
#include "numeric/round_to_format.h"

#include "numeric/number_types.h"

namespace pyrasim {

RoundToFormat rounding_to(const NumberFormat& format) {
  if (format == NumberFormat()) return nullptr;
  return with_number_type(format, []<class Number>(std::type_identity<Number>) -> RoundToFormat {
    return [](double x) { return static_cast<double>(static_cast<Number>(x)); };
  });
}

}  // namespace pyrasim
