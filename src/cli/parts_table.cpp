// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "cli/statistics_document.h"

namespace pyrasim::cli {
namespace {

std::string percentage(hw::Cycle part, hw::Cycle whole) {
  return fmt::format("{:.1f} %", 100 * static_cast<double>(part) / static_cast<double>(whole));
}

std::string part_line(const hw::MachinePart& part, hw::Cycle frame, hw::Cycle work) {
  const std::string name = part.part.empty() ? part.box : "  " + part.part;
  const bool built = part.units > 0;
  return fmt::format("{:<24}  {:>5}  {:>8}  {:>8}  {}: {}\n", name, built ? fmt::format("{}", part.units) : "-",
                     built ? percentage(part.busy, part.units * frame) : "-", built ? percentage(part.busy, work) : "-",
                     built ? "built" : "not built", part.reason);
}

}  // namespace

std::string parts_table(const Outcome& outcome) {
  hw::Cycle work = 0;
  for (const hw::MachinePart& part : outcome.parts) work += part.part.empty() ? part.busy : 0;
  std::string text = fmt::format("\n{:<24}  {:>5}  {:>8}  {:>8}  {}\n", "part", "units", "busy", "work", "why");
  for (const hw::MachinePart& part : outcome.parts) text += part_line(part, outcome.cycles, work);
  return text + "busy: of the frame's cycles, each unit; work: of all units' busy cycles\n";
}

}  // namespace pyrasim::cli
