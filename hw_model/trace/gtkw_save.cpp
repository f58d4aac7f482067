// SPDX-License-Identifier: Apache-2.0
#include "hw_model/trace/gtkw_save.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <string>
#include <string_view>

#include "hw_model/trace/trace_writer.h"
#include "hw_model/trace/vcd_time.h"
#include "version.h"

namespace pyrasim::hw {
namespace {

constexpr double cycle_pixels = 10;  ///< at first

/// As GTKWave's save files have them, in base 16: bits of TraceEntFlagBits.
constexpr std::string_view state_flags = "2022";  // number, translated by a file
constexpr std::string_view fill_flags = "88024";  // decimal, a curve in steps over its own range
constexpr std::string_view group_begin = "800200";
constexpr std::string_view group_end = "1000200";

std::string states_text() {
  constexpr std::array<std::string_view, 4> colors{"gray15", "DarkGreen", "DarkOrange3", "red3"};
  std::string text;
  for (std::size_t k = 0; k < colors.size(); ++k) text += fmt::format("{} ?{}?{}\n", k, colors[k], state_names[k]);
  return text;
}

/// `zoom`: to the base of two, of a screen that shows 200 pixels a unit of time at 0.
std::string layout(const VcdTime& time, Cycle from) {
  const double zoom = std::log2(cycle_pixels / (200 * static_cast<double>(time.date(1))));
  return fmt::format("[timestart] {}\n[size] 1400 900\n[signals_width] 480\n[sst_expanded] 0\n*{:.6f} -1\n",
                     time.date(from), zoom);
}

/// Of the bits of a FIFO's signal, as GTKWave names them.
std::string range(std::size_t depth) {
  const int bits = static_cast<int>(std::bit_width(depth));
  return bits == 1 ? "0" : fmt::format("{}:0", bits - 1);
}

/// A signal of two bits made of one of two bits: GTKWave prefers the names that an `.fst` has, without colours, to the
/// file's for any other.
std::string state_line(const std::string& scope, const std::string& name, const std::string& states) {
  return fmt::format("^1 {0}\n#{{{2}}} (0){1}.{2}[1:0] (1){1}.{2}[1:0]\n", states, scope, name);
}

std::string group(std::string_view name, const std::string& lines) {
  return fmt::format("@{0}\n-{2}\n{3}@{1}\n-{2}\n", group_begin, group_end, name, lines);
}

}  // namespace

GtkwSave::GtkwSave(const Processor& processor, const TraceWindow& window, OutputFile& output) {
  OutputFile states(states_file(output.path()));
  states.write(states_text());
  states.commit();

  const std::string scope = processor.basename();
  std::string units = fmt::format("@{}\n", state_flags);
  for (const Stage* stage : processor.stages()) {
    if (!window.shows(stage->basename())) continue;
    units += state_line(scope, stage->basename(), std::filesystem::absolute(states.path()).string());
  }
  std::string fifos = fmt::format("@{}\n", fill_flags);
  for (const FifoBase* fifo : processor.fifos()) {
    if (!window.shows(fifo->basename())) continue;
    fifos += fmt::format("[color] 3\n+{{{1}}} {0}.{1}[{2}]\n", scope, fifo->basename(), range(fifo->depth()));
  }
  output.write(fmt::format("[*] pyrasim {}; gtkwave TRACE.fst (or TRACE.vcd) {}\n[savefile] \"{}\"\n", version(),
                           output.path().filename().string(), std::filesystem::absolute(output.path()).string()));
  output.write(layout(VcdTime(processor.spec().clock_mhz), window.from) + group("units", units) +
               group("FIFOs", fifos));
}

}  // namespace pyrasim::hw
