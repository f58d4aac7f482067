// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "run/outcome.h"

namespace pyrasim {

/// The outcome as a document that crosses process boundaries. Every number comes back bit for bit; JSON has no
/// infinities and no NaN, which stand as texts: "inf", "-inf", "nan".
nlohmann::json pack(const Outcome& outcome);

/// What pack() was given. Throws InputError for what it did not make.
Outcome unpack(const nlohmann::json& document);

}  // namespace pyrasim
