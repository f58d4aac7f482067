// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "numeric/arithmetic_events.h"

namespace pyrasim {

/// Counts by their names.
nlohmann::ordered_json events_document(const ArithmeticEvents& events);

}  // namespace pyrasim
