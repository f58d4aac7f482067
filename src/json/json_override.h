// SPDX-License-Identifier: Apache-2.0
// Settings of the command line (`--set intersection.units=4`) written over those of a file.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string_view>

namespace pyrasim {

/// Applies "PATH=VALUE" to `document`. PATH is keys separated by dots, each non-empty; a number selects an element that
/// an array already has; objects that are missing are made. VALUE is JSON (4, 0.5, true, [1, 2], "text"); what does not
/// begin as JSON does is taken as a string, so that `order=depth_first` needs no quotes. Whether the key is known and
/// the value fits is said later, by whoever reads the document, which stays within max_json_depth. Throws UsageError
/// when the assignment itself makes no sense; `option` is what it names as its place on the command line.
void apply_override(nlohmann::json& document, std::string_view assignment, std::string_view option = "--set");

}  // namespace pyrasim
