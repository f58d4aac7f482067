// SPDX-License-Identifier: Apache-2.0
// machines/default.json says, number for number, what the program takes where no machine is named.
#include <cstdio>
#include <exception>

#include "hw_model/machine_spec.h"

int main() {
  using namespace pyrasim::hw;
  try {
    if (load_machine(PYRASIM_SOURCE_DIR "/machines/default.json") == MachineSpec{}) return 0;
    std::fputs("machines/default.json differs from MachineSpec{}\n", stderr);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
  }
  return 1;
}
