// SPDX-License-Identifier: Apache-2.0
#include "hw_model/trace/gtkw_save.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "hw_model/trace/signals.h"
#include "hw_model/trace/trace_writer.h"
#include "hw_model/trace/vcd_time.h"
#include "version.h"

namespace pyrasim::hw {
namespace {

constexpr double cycle_pixels = 10;  ///< at first

/// As GTKWave's save files have them, in base 16: bits of TraceEntFlagBits.
constexpr std::string_view state_flags = "2022";  // number, translated by a file
constexpr std::string_view fill_flags = "88024";  // decimal, a curve in steps over its own range
constexpr std::string_view number_flags = "24";   // decimal
constexpr int fill_color = 3;                     // yellow
constexpr int detail_color = 4;                   // green
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

/// Of the bits of a signal, as GTKWave names them.
std::string range(std::size_t bits) { return bits == 1 ? "0" : fmt::format("{}:0", bits - 1); }

/// A signal of two bits made of one of two bits: GTKWave prefers the names that an `.fst` has, without colours, to the
/// file's for any other.
std::string state_line(const std::string& scope, const std::string& name, const std::string& states) {
  return fmt::format("@{3}\n^1 {0}\n#{{{2}}} (0){1}.{2}[1:0] (1){1}.{2}[1:0]\n", states, scope, name, state_flags);
}

/// `color`: one of GTKWave's.
std::string number_line(const std::string& scope, const Signal& signal, std::string_view flags, int color) {
  return fmt::format("@{0}\n[color] {1}\n+{{{2}}} {3}.{2}[{4}]\n", flags, color, signal.name, scope,
                     range(signal.bits));
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
  const std::string states_path = std::filesystem::absolute(states.path()).string();
  // Of each stage and FIFO its details stand behind its state or fill.
  std::vector<std::string> units(processor.stages().size());
  std::vector<std::string> fifos(processor.fifos().size());
  for (const Signal& signal : signals_of(processor, window)) {
    if (!signal.shown) continue;
    switch (signal.kind) {
      case Signal::Kind::state:
        units[signal.source] += state_line(scope, signal.name, states_path);
        break;
      case Signal::Kind::row:
      case Signal::Kind::column:
      case Signal::Kind::ray:
        units[signal.source] += number_line(scope, signal, number_flags, detail_color);
        break;
      case Signal::Kind::fill:
        fifos[signal.source] += number_line(scope, signal, fill_flags, fill_color);
        break;
      case Signal::Kind::valid:
      case Signal::Kind::ready:
        fifos[signal.source] += number_line(scope, signal, number_flags, detail_color);
        break;
    }
  }
  output.write(fmt::format("[*] pyrasim {}; gtkwave TRACE.fst (or TRACE.vcd) {}\n[savefile] \"{}\"\n", version(),
                           output.path().filename().string(), std::filesystem::absolute(output.path()).string()));
  output.write(layout(VcdTime(processor.spec().clock_mhz), window.from) +
               group("units", fmt::format("{}", fmt::join(units, ""))) +
               group("FIFOs", fmt::format("{}", fmt::join(fifos, ""))));
}

}  // namespace pyrasim::hw
