// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <queue>
#include <string>
#include <tuple>
#include <vector>

#include "files/output_file.h"
#include "hw_model/processor.h"
#include "hw_model/trace/signals.h"
#include "hw_model/trace/trace.h"
#include "hw_model/trace/vcd_time.h"
#include "hw_model/trace/windowed_sink.h"

namespace pyrasim::hw {

/// Writes the state of every stage and the fill of every FIFO of a processor as a VCD file (IEEE 1364-2005, clause 18),
/// while the frame runs and in bounded memory.
///
/// A stage's signal has two bits: 0 idle, 1 busy, 2 starved, 3 blocked. A FIFO's is the number of tokens, where a token
/// counts from the cycle of its write to that of its read. With the window's details there are the others of
/// signals_of(): in the cycle of a read its FIFO is valid, in that of a write it is ready. Time is the clock's: see
/// VcdTime. What a stage waits for is known only when it fires again, perhaps much later: its signal's value is then
/// written where the wait began.
class VcdTrace final : public Trace, public WindowedSink {
 public:
  /// Of `processor`, whose simulation has not started, to `output`, which has to be revisable; both outlive it.
  VcdTrace(Processor& processor, const TraceWindow& window, OutputFile& output);
  VcdTrace(const VcdTrace&) = delete;
  VcdTrace& operator=(const VcdTrace&) = delete;

  void finish(Cycle cycles) override;
  std::optional<Cycle> full() const override { return window_.full; }

 private:
  void take_shown(const Event& event) override;

  enum class Change : std::uint8_t { fires, rests, gains, loses, arrives, settles };
  /// What may change a signal at a date, in the order of the file.
  struct Item {
    Cycle at;
    std::size_t signal;
    Change change;
    friend bool operator>(const Item& a, const Item& b) {
      return std::tie(a.at, a.signal, a.change) > std::tie(b.at, b.signal, b.change);
    }
  };
  /// The state of a stage, or the fill of a FIFO.
  struct Track {
    std::string end;  ///< of a line: its code
    bool shown = false;
    StageState state = StageState::idle;  ///< of a stage: busy or idle
    std::size_t fill = 0;                 ///< of a FIFO, as it was written last
    std::optional<std::uint64_t> gap{};   ///< of a stage that rests: where in the file its value stands
  };
  /// A signal whose value is known at once.
  struct Value {
    std::string end;  ///< as in Track
    bool shown = false;
    std::uint64_t number = no_number;  ///< as it was written last; none: x
  };
  /// What the details of a FIFO are made of.
  struct Handshake {
    std::size_t readable = 0;  ///< tokens
    std::size_t settled = 0;   ///< tokens, without one that is written in this cycle
  };

  void write_header(const std::vector<Signal>& signals);
  /// The first values of all signals, at the window's beginning.
  void write_values();
  void write_before(Cycle date);
  void write_changes(Cycle at);
  bool begin_line(Cycle at);
  void write_date(Cycle at);
  void write_state(Track& track);
  void write_fill(const Track& track);
  /// Row, column and ray of a stage that fires.
  void set_subject(std::size_t stage, Cycle at);
  /// Valid and ready of a FIFO.
  void set_handshake(std::size_t fifo, Cycle at);
  void set(Value& value, std::uint64_t number, Cycle at);
  void write_value(const Value& value);
  void write_number(std::uint64_t number, const std::string& end);

  Processor& processor_;
  TraceWindow window_;
  OutputFile& output_;
  VcdTime time_;
  std::vector<Track> tracks_;          ///< of the stages, then of the FIFOs
  std::vector<Value> values_;          ///< of the stages, three each, then of the FIFOs, two each; none without details
  std::vector<Subject> subjects_;      ///< of the stages' newest firings; likewise
  std::vector<Handshake> handshakes_;  ///< of the FIFOs; likewise
  std::priority_queue<Item, std::vector<Item>, std::greater<>> agenda_;
  std::optional<Cycle> written_;  ///< date; none before the window
};

}  // namespace pyrasim::hw
