// SPDX-License-Identifier: Apache-2.0
#include "hw_model/trace/vcd_trace.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <string_view>

#include "hw_model/trace/vcd_code.h"
#include "version.h"

namespace pyrasim::hw {
namespace {

/// A stage's value, always in both of its bits, so that one can take the place of another.
std::string_view bits_of(StageState state) {
  constexpr std::array<std::string_view, 4> bits{"00", "01", "10", "11"};
  return bits[static_cast<std::size_t>(state)];
}

/// A line of many: quicker than fmt.
template <class Number>
std::string_view line(std::array<char, 80>& buffer, char first, Number number, int base, std::string_view end) {
  buffer[0] = first;
  char* const behind = std::to_chars(buffer.data() + 1, buffer.data() + buffer.size(), number, base).ptr;
  std::copy(end.begin(), end.end(), behind);
  return {buffer.data(), static_cast<std::size_t>(behind - buffer.data()) + end.size()};
}

}  // namespace

VcdTrace::VcdTrace(Processor& processor, const TraceWindow& window, OutputFile& output)
    : WindowedSink(processor, window),
      processor_(processor),
      window_(window),
      output_(output),
      time_(processor.spec().clock_mhz) {
  const std::size_t stages = processor.stages().size();
  signals_.resize(stages + processor.fifos().size());
  for (std::size_t k = 0; k < signals_.size(); ++k) {
    const bool stage = k < stages;
    signals_[k].end = fmt::format(" {}\n", vcd_code(k));
    signals_[k].shown =
        window.shows(stage ? processor.stages()[k]->basename() : processor.fifos()[k - stages]->basename());
    if (!stage) signals_[k].fill = tokens_before(*processor.fifos()[k - stages]);
  }
  write_header();
  if (window.from == 0) write_values();
  processor.attach(*this);
}

void VcdTrace::write_header() {
  output_.write(
      fmt::format("$version pyrasim {} $end\n$comment one cycle is one period of {} MHz; units: 0 idle, 1 busy, 2 "
                  "starved, 3 blocked "
                  "$end\n$timescale {} $end\n$scope module {} $end\n",
                  version(), processor_.spec().clock_mhz, time_.unit(), processor_.basename()));
  const std::size_t stages = processor_.stages().size();
  for (std::size_t k = 0; k < stages; ++k) {
    if (!signals_[k].shown) continue;
    output_.write(fmt::format("$var reg 2 {} {} [1:0] $end\n", vcd_code(k), processor_.stages()[k]->basename()));
  }
  for (std::size_t k = stages; k < signals_.size(); ++k) {
    if (!signals_[k].shown) continue;
    const FifoBase& fifo = *processor_.fifos()[k - stages];
    const int bits = static_cast<int>(std::bit_width(fifo.depth()));
    output_.write(fmt::format("$var reg {} {} {} [{}:0] $end\n", bits, vcd_code(k), fifo.basename(), bits - 1));
  }
  output_.write("$upscope $end\n$enddefinitions $end\n");
}

void VcdTrace::write_values() {
  write_date(window_.from);
  output_.write("$dumpvars\n");
  for (std::size_t k = 0; k < signals_.size(); ++k) {
    if (!signals_[k].shown) continue;
    if (k < processor_.stages().size()) {
      write_state(signals_[k]);
    } else {
      write_fill(signals_[k]);
    }
  }
  output_.write("$end\n");
}

void VcdTrace::take_shown(const Event& event) {
  write_before(event.at);
  window_.end_if_full(output_.size(), event.at);
  const std::size_t fifo = processor_.stages().size() + event.source;
  if (!signals_[event.kind == Event::Kind::firing ? event.source : fifo].shown) return;
  switch (event.kind) {
    case Event::Kind::read:
      agenda_.push({event.at + 1, fifo, Change::loses});
      break;
    case Event::Kind::write:
      agenda_.push({event.at, fifo, Change::gains});
      break;
    case Event::Kind::firing:
      if (auto& gap = signals_[event.source].gap) {
        output_.overwrite(*gap, bits_of(event.waited));
        gap.reset();
      }
      agenda_.push({event.at, event.source, Change::fires});
      agenda_.push({event.until, event.source, Change::rests});
      break;
  }
}

void VcdTrace::finish(Cycle cycles) {
  write_before(never);
  if (!written_) write_values();
  const Cycle end = std::min(cycles, window_.to);
  if (end > *written_) write_date(end);
}

void VcdTrace::write_before(Cycle date) {
  while (!agenda_.empty() && agenda_.top().at < date) write_changes(agenda_.top().at);
}

/// A stage that fires in the cycle in which it comes to rest stays busy, a FIFO that gains and loses keeps its fill.
void VcdTrace::write_changes(Cycle at) {
  if (!written_ && at > window_.from) write_values();
  const bool shown = written_ && at < window_.to;
  while (!agenda_.empty() && agenda_.top().at == at) {
    const std::size_t number = agenda_.top().signal;
    Signal& signal = signals_[number];
    bool fires = false;
    bool rests = false;
    std::size_t fill = signal.fill;
    for (; !agenda_.empty() && agenda_.top().at == at && agenda_.top().signal == number; agenda_.pop()) {
      const Change change = agenda_.top().change;
      fires |= change == Change::fires;
      rests |= change == Change::rests;
      if (change == Change::gains) ++fill;
      if (change == Change::loses) --fill;
    }
    if (fires == rests && fill == signal.fill) continue;
    if (shown && written_ != at) write_date(at);
    if (fires || rests) {
      signal.state = fires ? StageState::busy : StageState::idle;
      if (shown) write_state(signal);
    } else {
      signal.fill = fill;
      if (shown) write_fill(signal);
    }
  }
}

void VcdTrace::write_date(Cycle at) {
  std::array<char, 80> buffer;
  output_.write(line(buffer, '#', time_.date(at), 10, "\n"));
  written_ = at;
}

/// What a stage that rests waits for, is known later.
void VcdTrace::write_state(Signal& signal) {
  signal.gap.reset();
  if (signal.state != StageState::busy) signal.gap = output_.size() + 1;
  output_.write("b");
  output_.write(bits_of(signal.state));
  output_.write(signal.end);
}

void VcdTrace::write_fill(const Signal& signal) {
  std::array<char, 80> buffer;
  output_.write(line(buffer, 'b', signal.fill, 2, signal.end));
}

}  // namespace pyrasim::hw
