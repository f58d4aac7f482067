// SPDX-License-Identifier: Apache-2.0
#include "numeric/arithmetic_events_json.h"

#include <nlohmann/json.hpp>

namespace pyrasim {

nlohmann::ordered_json events_document(const ArithmeticEvents& events) {
  return {{"saturations", events.saturations},
          {"underflows", events.underflows},
          {"inexact", events.inexact},
          {"divisions_by_zero", events.divisions_by_zero},
          {"invalid", events.invalid}};
}

}  // namespace pyrasim
