// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <queue>
#include <string>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "hw_model/trace/trace.h"
#include "hw_model/trace/windowed_sink.h"

namespace pyrasim::hw {

/// Writes the log of rays that the pipeline viewer Konata opens (Kanata 0004): a row for each ray, from its view vector
/// to its classification; where it is in each cycle, by the names of units, and on a lane of their own of FIFOs in
/// which it waits; and an arrow to each of a request's rays from the ray that completed the node that it splits.
///
/// A ray is in a unit from the firing that takes it to the cycle in which the next one could; a row begins in the
/// window. The units that the window leaves out leave gaps.
class KanataTrace final : public Trace, public WindowedSink {
 public:
  KanataTrace(Processor& processor, const TraceWindow& window, OutputFile& output);

  void finish(Cycle cycles) override;
  std::optional<Cycle> full() const override { return window_.full; }

 private:
  void take_shown(const Event& event) override;

  /// Where a ray goes, at a date that may lie ahead.
  struct Item {
    Cycle at;
    std::uint64_t order;  ///< of items at equal dates: as they came
    std::uint64_t ray;
    std::size_t place;  ///< a stage, or behind all of them a FIFO; nowhere: it is done
    friend bool operator>(const Item& a, const Item& b) { return std::tie(a.at, a.order) > std::tie(b.at, b.order); }
  };
  struct Row {
    std::uint64_t number;  ///< in the file
    std::size_t place;
  };
  /// A node whose last corner is known.
  struct Completed {
    GridPoint corner;
    std::uint32_t log2_side;
    std::uint64_t row;                  ///< of the ray through that corner
    std::uint64_t request = no_number;  ///< that splits it
  };
  static constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

  void take_firing(const Event& event);
  void take_node(const Event& event);
  void begin_row(const Subject& ray, Cycle at);
  void go(std::uint64_t ray, Cycle at, std::size_t place);
  void write_before(Cycle date);
  void write(const Item& item);
  void write_date(Cycle at);
  void leave(const Row& row);
  /// Of waits there is one of their own.
  int lane(std::size_t place) const { return place < processor_.stages().size() ? 0 : 1; }
  bool shows(std::size_t place) const { return place != nowhere && shown_[place]; }

  const Processor& processor_;
  TraceWindow window_;
  OutputFile& output_;
  std::vector<std::string> names_;  ///< of stages, then of FIFOs
  std::vector<bool> shown_;
  std::vector<std::size_t> readers_;  ///< of FIFOs that rays go through: a stage; nowhere of others
  std::size_t generator_ = 0, classifier_ = 0, controller_ = nowhere, frame_buffer_ = 0;  ///< among the stages
  std::unordered_map<std::uint32_t, std::vector<Completed>> completed_;  ///< that may be split, by pixel
  std::priority_queue<Item, std::vector<Item>, std::greater<>> agenda_;
  std::unordered_map<std::uint64_t, Row> rows_;  ///< of rays under way
  std::uint64_t order_ = 0;
  std::uint64_t rows_begun_ = 0;
  std::uint64_t rows_ended_ = 0;
  std::optional<Cycle> written_;
};

}  // namespace pyrasim::hw
