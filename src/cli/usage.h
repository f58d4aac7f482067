// SPDX-License-Identifier: Apache-2.0
// Mistakes on the command line that are the same in every command.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

namespace pyrasim::cli {

/// No option of `app` and its commands takes an empty value from now on: a variable that the shell left empty is a
/// mistake, not an option that is not given.
void refuse_empty_values(CLI::App& app);

/// One line on a command line that could not be read: what was wrong, what was probably meant, and where to look.
std::string usage_mistake(const CLI::App& app, const CLI::ParseError& error);

/// The one of `known` that `word` most likely stands for: no more than a third of its letters are inserted, left out,
/// replaced or exchanged with their neighbour. None where nothing is so near.
std::optional<std::string> nearest(const std::string& word, const std::vector<std::string>& known);

}  // namespace pyrasim::cli
