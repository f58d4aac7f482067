// SPDX-License-Identifier: Apache-2.0
#include "hw_model/trace/vcd_trace.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <iterator>

#include "version.h"

namespace pyrasim::hw {

/// A new value of a signal.
struct VcdTrace::Change {
  Cycle at;
  std::uint32_t signal;
  std::uint32_t value;
};

class VcdTrace::StageSignal final : public StageObserver {
 public:
  void span(State state, Cycle from, Cycle to) override {
    if (changes_.empty() || changes_.back().second != state) changes_.emplace_back(from, state);
    end_ = to;
  }
  void append(std::uint32_t signal, std::vector<Change>& all) const {
    for (const auto& [at, state] : changes_) all.push_back({at, signal, static_cast<std::uint32_t>(state)});
    all.push_back({end_, signal, static_cast<std::uint32_t>(State::idle)});
  }

 private:
  std::vector<std::pair<Cycle, State>> changes_;
  Cycle end_ = 0;
};

class VcdTrace::FifoSignal final : public FifoObserver {
 public:
  explicit FifoSignal(std::size_t present) : present_(static_cast<std::uint32_t>(present)) {}
  void written(Cycle at) override { writes_.push_back(at); }
  void read(Cycle at) override { reads_.push_back(at); }
  std::uint32_t present() const { return present_; }

  void append(std::uint32_t signal, std::vector<Change>& all) const {
    std::uint32_t fill = present_;
    std::size_t w = 0;
    std::size_t r = 0;
    while (w < writes_.size() || r < reads_.size()) {
      const Cycle write = w < writes_.size() ? writes_[w] : never;
      const Cycle leave = r < reads_.size() ? reads_[r] + 1 : never;
      const Cycle at = std::min(write, leave);
      const std::uint32_t before = fill;
      for (; w < writes_.size() && writes_[w] == at; ++w) ++fill;
      for (; r < reads_.size() && reads_[r] + 1 == at; ++r) --fill;
      if (fill != before) all.push_back({at, signal, fill});
    }
  }

 private:
  std::uint32_t present_;  ///< tokens preloaded
  std::vector<Cycle> writes_;
  std::vector<Cycle> reads_;
};

VcdTrace::VcdTrace(Processor& processor) : processor_(processor) {
  for (Stage* stage : processor.stages()) {
    stages_.push_back(std::make_unique<StageSignal>());
    stage->observe(stages_.back().get());
  }
  for (FifoBase* fifo : processor.fifos()) {
    fifos_.push_back(std::make_unique<FifoSignal>(fifo->size()));
    fifo->observe(*fifos_.back());
  }
}

VcdTrace::~VcdTrace() {
  for (Stage* stage : processor_.stages()) stage->observe(nullptr);
  for (std::size_t k = 0; k < fifos_.size(); ++k) processor_.fifos()[k]->ignore(*fifos_[k]);
}

namespace {

/// An identifier code of VCD: printable characters, shortest first.
std::string code(std::size_t signal) {
  std::string text;
  do {
    text += static_cast<char>('!' + signal % 94);
    signal /= 94;
  } while (signal > 0);
  return text;
}

int width(std::size_t largest) { return static_cast<int>(std::bit_width(largest)); }

}  // namespace

std::string VcdTrace::header() const {
  std::string text = fmt::format(
      "$version pyrasim {} $end\n$comment one time step is one cycle at {} MHz; units: 0 idle, "
      "1 busy, 2 starved, 3 blocked $end\n$timescale 1 ns $end\n$scope module {} $end\n",
      version(), processor_.spec().clock_mhz, processor_.basename());
  std::size_t signal = 0;
  for (const Stage* stage : processor_.stages()) {
    text += fmt::format("$var reg 2 {} {} [1:0] $end\n", code(signal++), stage->basename());
  }
  for (const FifoBase* fifo : processor_.fifos()) {
    const int bits = width(fifo->statistics().depth);
    text += fmt::format("$var reg {} {} {} [{}:0] $end\n", bits, code(signal++), fifo->basename(), bits - 1);
  }
  text += "$upscope $end\n$enddefinitions $end\n#0\n$dumpvars\n";
  for (std::size_t k = 0; k < stages_.size(); ++k) text += fmt::format("b0 {}\n", code(k));
  for (std::size_t k = 0; k < fifos_.size(); ++k) {
    text += fmt::format("b{:b} {}\n", fifos_[k]->present(), code(stages_.size() + k));
  }
  return text + "$end\n";
}

std::string VcdTrace::text() const {
  std::vector<Change> changes;
  std::uint32_t signal = 0;
  for (const auto& stage : stages_) stage->append(signal++, changes);
  for (const auto& fifo : fifos_) fifo->append(signal++, changes);
  std::stable_sort(changes.begin(), changes.end(), [](const Change& a, const Change& b) { return a.at < b.at; });
  std::string text = header();
  Cycle now = 0;
  for (const Change& change : changes) {
    if (change.at != now) {
      now = change.at;
      fmt::format_to(std::back_inserter(text), "#{}\n", now);
    }
    fmt::format_to(std::back_inserter(text), "b{:b} {}\n", change.value, code(change.signal));
  }
  if (now != processor_.cycles()) fmt::format_to(std::back_inserter(text), "#{}\n", processor_.cycles());
  return text;
}

}  // namespace pyrasim::hw
