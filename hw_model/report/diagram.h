// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "hw_model/processor.h"

namespace pyrasim::hw {

/// The block diagram of a machine as it was built, in Graphviz's DOT: a node for each stage, an edge with its depth for
/// each FIFO, and a comment for what was left out.
std::string block_diagram(const Processor& processor);

}  // namespace pyrasim::hw
