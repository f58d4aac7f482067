// SPDX-License-Identifier: Apache-2.0
#include "numeric/round_to_format.h"

#include "numeric/number_types.h"

namespace pyrasim {

RoundToFormat::RoundToFormat(const NumberFormat& format) {
  with_number_type(format,
                   [this]<class Scalar>(std::type_identity<Scalar>) { format_ = ScalarFormat<Scalar>::current(); });
}

}  // namespace pyrasim
