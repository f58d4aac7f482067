// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "cli/whole_number.h"
#include "hw_model/cycle.h"
#include "hw_model/machine_spec.h"

namespace pyrasim::cli {

/// Which machine: --machine and --set.
struct MachineOptions {
  std::string file;                    ///< empty: the default machine
  std::vector<std::string> overrides;  ///< "path=value"
  hw::Cycle max_cycles = hw::never;

  void add(CLI::App& command) {
    command.add_option("--machine", file, "machine file (JSON); the default machine without it")->type_name("FILE");
    command.add_option("--set", overrides, "a setting over the machine file's, as in intersection.units=4; repeatable")
        ->type_name("PATH=VALUE")
        ->allow_extra_args(false)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    add_whole_number(command, "--max-cycles", max_cycles, hw::Cycle{1}, hw::never - 1,
                     "give up on a frame that takes longer: exit code 4");
  }
  hw::MachineSpec load() const {
    return hw::load_machine(file.empty() ? std::nullopt : std::optional<std::filesystem::path>(file), overrides);
  }
};

}  // namespace pyrasim::cli
