// SPDX-License-Identifier: Apache-2.0
// Scripts that complete the program's command line in a shell: commands, options, words that are known, files.
#pragma once

#include <string>

#include "cli/command_description.h"

namespace pyrasim::cli {

/// For bash 4 or later, with or without the package bash-completion.
std::string bash_completion(const CommandDescription& program);
/// A function `_pyrasim` to be found on zsh's fpath.
std::string zsh_completion(const CommandDescription& program);
/// For fish 3 or later.
std::string fish_completion(const CommandDescription& program);

}  // namespace pyrasim::cli
