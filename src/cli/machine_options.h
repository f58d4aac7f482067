// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "cli/command_parser.h"
#include "hw_model/cycle.h"
#include "hw_model/machine_spec.h"

namespace pyrasim::cli {

/// Which machine: --machine and --set; and how long it may take: --max-cycles.
struct MachineOptions {
  std::string file;                    ///< empty: the default machine
  std::vector<std::string> overrides;  ///< "path=value"
  hw::Cycle max_cycles = hw::never;

  void add(const Command& command, const std::string& values = "=VALUE",
           const std::string& set = "a setting over the machine file's, as in intersection.units=4; repeatable") {
    command.add_text("--machine", file, "machine file (JSON); the default machine without it").type_name("FILE");
    command.add_texts("--set", overrides, set).type_name("PATH" + values);
  }
  void add_limit(const Command& command) {
    command
        .add_integer("--max-cycles", max_cycles, 1, hw::never - 1, "give up on a frame that takes longer: exit code 4")
        .type_name("N");
  }
  hw::MachineSpec load() const {
    return hw::load_machine(file.empty() ? std::nullopt : std::optional<std::filesystem::path>(file), overrides);
  }
};

}  // namespace pyrasim::cli
