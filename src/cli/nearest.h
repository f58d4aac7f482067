// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace pyrasim::cli {

/// The one of `known` that `word` most likely stands for: no more than a third of its letters are inserted, left out,
/// replaced or exchanged with their neighbour. None where nothing is so near.
std::optional<std::string> nearest(const std::string& word, const std::vector<std::string>& known);

}  // namespace pyrasim::cli
