// SPDX-License-Identifier: Apache-2.0
#include "hw_model/trace/vcd_trace.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
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
  const std::vector<Signal> signals = signals_of(processor, window);
  const std::size_t stages = processor.stages().size();
  const std::size_t tracks = stages + processor.fifos().size();
  for (std::size_t k = 0; k < signals.size(); ++k) {
    const std::string end = fmt::format(" {}\n", vcd_code(k));
    if (k < tracks) {
      tracks_.push_back({end, signals[k].shown});
      if (k >= stages) tracks_.back().fill = tokens_before(*processor.fifos()[k - stages]);
    } else {
      values_.push_back({end, signals[k].shown});
    }
  }
  if (values_.size() > 0) subjects_.resize(stages);
  if (values_.size() > 3 * stages) {
    for (std::size_t k = stages; k < tracks; ++k) handshakes_.push_back({tracks_[k].fill, tracks_[k].fill});
    for (std::size_t k = 0; k < handshakes_.size(); ++k) set_handshake(k, 0);
  }
  write_header(signals);
  if (window.from == 0) write_values();
  processor.attach(*this);
}

void VcdTrace::write_header(const std::vector<Signal>& signals) {
  output_.write(
      fmt::format("$version pyrasim {} $end\n$comment one cycle is one period of {} MHz; units: 0 idle, 1 busy, 2 "
                  "starved, 3 blocked "
                  "$end\n$timescale {} $end\n$scope module {} $end\n",
                  version(), processor_.spec().clock_mhz, time_.unit(), processor_.basename()));
  for (std::size_t k = 0; k < signals.size(); ++k) {
    const Signal& signal = signals[k];
    if (!signal.shown) continue;
    output_.write(
        fmt::format("$var reg {} {} {} [{}:0] $end\n", signal.bits, vcd_code(k), signal.name, signal.bits - 1));
  }
  output_.write("$upscope $end\n$enddefinitions $end\n");
}

void VcdTrace::write_values() {
  write_date(window_.from);
  output_.write("$dumpvars\n");
  for (std::size_t k = 0; k < tracks_.size(); ++k) {
    if (!tracks_[k].shown) continue;
    if (k < processor_.stages().size()) {
      write_state(tracks_[k]);
    } else {
      write_fill(tracks_[k]);
    }
  }
  for (const Value& value : values_) {
    if (value.shown) write_value(value);
  }
  output_.write("$end\n");
}

void VcdTrace::take_shown(const Event& event) {
  write_before(event.at);
  window_.end_if_full(output_.size(), event.at);
  const std::size_t fifo = processor_.stages().size() + event.source;
  if (!tracks_[event.kind == Event::Kind::firing ? event.source : fifo].shown) return;
  switch (event.kind) {
    case Event::Kind::read:
      agenda_.push({event.at + 1, fifo, Change::loses});
      break;
    case Event::Kind::write:
      agenda_.push({event.at, fifo, Change::gains});
      if (handshakes_.empty()) break;
      agenda_.push({event.at + 1, fifo, Change::settles});
      agenda_.push({event.until, fifo, Change::arrives});
      break;
    case Event::Kind::firing:
      if (!subjects_.empty()) subjects_[event.source] = event.subject;
      if (auto& gap = tracks_[event.source].gap) {
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
  const Cycle end = std::min(cycles, window_.to);
  if (end > *written_) write_date(end);
}

void VcdTrace::write_before(Cycle date) {
  while (!agenda_.empty() && agenda_.top().at < date) write_changes(agenda_.top().at);
  if (!written_ && date > window_.from) write_values();  // before it is told what a unit waited for since then
}

/// A stage that fires in the cycle in which it comes to rest stays busy, a FIFO that gains and loses keeps its fill.
void VcdTrace::write_changes(Cycle at) {
  if (!written_ && at > window_.from) write_values();
  const std::size_t stages = processor_.stages().size();
  while (!agenda_.empty() && agenda_.top().at == at) {
    const std::size_t number = agenda_.top().signal;
    Track& track = tracks_[number];
    std::array<std::size_t, 6> times{};  // of each Change, in their order
    for (; !agenda_.empty() && agenda_.top().at == at && agenda_.top().signal == number; agenda_.pop()) {
      ++times[static_cast<std::size_t>(agenda_.top().change)];
    }
    const auto [fires, rests, gains, loses, arrives, settles] = times;
    if (fires != rests) {
      track.state = fires > 0 ? StageState::busy : StageState::idle;
      if (begin_line(at)) write_state(track);
    }
    if (gains != loses) {
      track.fill += gains - loses;
      if (begin_line(at)) write_fill(track);
    }
    if (fires > 0 && !subjects_.empty()) set_subject(number, at);
    if (number >= stages && !handshakes_.empty()) {
      Handshake& handshake = handshakes_[number - stages];
      handshake.readable += arrives - loses;
      handshake.settled += settles - loses;
      set_handshake(number - stages, at);
    }
  }
}

/// Whether a change at a date is in the window, whose first values have been written; if so, after its date.
bool VcdTrace::begin_line(Cycle at) {
  if (!written_ || at >= window_.to) return false;
  if (written_ != at) write_date(at);
  return true;
}

void VcdTrace::write_date(Cycle at) {
  std::array<char, 80> buffer;
  output_.write(line(buffer, '#', time_.date(at), 10, "\n"));
  written_ = at;
}

/// What a stage that rests waits for, is known later.
void VcdTrace::write_state(Track& track) {
  track.gap.reset();
  if (track.state != StageState::busy) track.gap = output_.size() + 1;
  output_.write("b");
  output_.write(bits_of(track.state));
  output_.write(track.end);
}

void VcdTrace::write_fill(const Track& track) { write_number(track.fill, track.end); }

void VcdTrace::set_subject(std::size_t stage, Cycle at) {
  const Subject& subject = subjects_[stage];
  std::uint64_t row = no_number;
  std::uint64_t column = no_number;
  if (subject.pixel != no_pixel) std::tie(row, column) = processor_.place_of(subject.pixel);
  set(values_[3 * stage], row, at);
  set(values_[3 * stage + 1], column, at);
  set(values_[3 * stage + 2], subject.ray, at);
}

void VcdTrace::set_handshake(std::size_t fifo, Cycle at) {
  const std::size_t first = 3 * subjects_.size() + 2 * fifo;
  set(values_[first], handshakes_[fifo].readable > 0 ? 1 : 0, at);
  set(values_[first + 1], handshakes_[fifo].settled < processor_.fifos()[fifo]->depth() ? 1 : 0, at);
}

void VcdTrace::set(Value& value, std::uint64_t number, Cycle at) {
  if (value.number == number) return;
  value.number = number;
  if (begin_line(at)) write_value(value);
}

void VcdTrace::write_value(const Value& value) {
  if (value.number != no_number) {
    write_number(value.number, value.end);
    return;
  }
  output_.write("bx");
  output_.write(value.end);
}

void VcdTrace::write_number(std::uint64_t number, const std::string& end) {
  std::array<char, 80> buffer;
  output_.write(line(buffer, 'b', number, 2, end));
}

}  // namespace pyrasim::hw
