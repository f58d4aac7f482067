// SPDX-License-Identifier: Apache-2.0
#include "hw_model/trace/fst_trace.h"

#include <fmt/format.h>

#include <charconv>
#include <string>
#include <vector>

#include "hw_model/trace/fst_file.h"
#include "hw_model/trace/signals.h"
#include "hw_model/trace/vcd_code.h"
#include "hw_model/trace/vcd_time.h"

namespace pyrasim::hw {
namespace {

/// Hands the lines of what is copied to `take`.
template <class Take>
void for_each_line(OutputFile& file, Take take) {
  std::string rest;  // of a piece: a line's beginning
  file.copy_to([&](std::string_view piece) {
    std::size_t end = 0;
    for (; (end = piece.find('\n')) != std::string_view::npos; piece.remove_prefix(end + 1)) {
      take(rest.empty() ? piece.substr(0, end) : rest += piece.substr(0, end));
      rest.clear();
    }
    rest += piece;
  });
}

/// By the signal's place in signals_of(); those that are not shown have none.
std::vector<std::size_t> declare(const Processor& processor, const TraceWindow& window, FstFile& file) {
  std::vector<std::size_t> numbers;
  file.begin_scope(processor.basename());
  for (const Signal& signal : signals_of(processor, window)) {
    const bool states = signal.kind == Signal::Kind::state;
    numbers.push_back(signal.shown ? file.add_signal(signal.name, signal.bits, states) : 0);
  }
  file.end_scope();
  return numbers;
}

}  // namespace

FstTrace::FstTrace(Processor& processor, const TraceWindow& window, OutputFile& output)
    : processor_(processor),
      window_(window),
      output_(output),
      vcd_file_(OutputFile::Scratch{}),
      vcd_(processor, window, vcd_file_) {}

void FstTrace::finish(Cycle cycles) {
  vcd_.finish(cycles);
  const double clock_mhz = processor_.spec().clock_mhz;
  FstFile file(vcd_file_.path(), VcdTime(clock_mhz).unit(),
               fmt::format("one cycle is one period of {} MHz", clock_mhz));
  const std::vector<std::size_t> numbers = declare(processor_, window_, file);
  for_each_line(vcd_file_, [&](std::string_view line) {
    if (line[0] == '#') {
      std::uint64_t time = 0;
      std::from_chars(line.data() + 1, line.data() + line.size(), time);
      file.set_time(time);
    } else if (line[0] == 'b') {
      const std::size_t space = line.find(' ');
      file.change(numbers[vcd_signal(line.substr(space + 1))], line.substr(1, space - 1));
    }
  });
  file.write_to(output_);
}

}  // namespace pyrasim::hw
