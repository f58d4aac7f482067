// SPDX-License-Identifier: Apache-2.0
#include "hw_model/report/diagram.h"

#include <fmt/format.h>

namespace pyrasim::hw {

std::string block_diagram(const Processor& processor) {
  std::string text = "digraph machine {\n  rankdir=LR;\n  node [shape=box];\n";
  for (const Stage* stage : processor.stages()) text += fmt::format("  {};\n", stage->basename());
  for (const Wire& wire : processor.wires()) {
    text +=
        fmt::format("  {} -> {} [label={}];\n", wire.writer->basename(), wire.reader->basename(), wire.fifo->depth());
  }
  for (const MachinePart& part : processor.parts()) {
    if (part.units == 0) text += fmt::format("  // not built: {}; {}\n", part.name(), part.reason);
  }
  return text + "}\n";
}

}  // namespace pyrasim::hw
