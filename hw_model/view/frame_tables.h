// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <unordered_map>
#include <vector>

#include "hw_model/processor.h"
#include "hw_model/view/column.h"
#include "pyramid/cell.h"

namespace pyrasim::hw {

/// All that happens in a frame as tables, a column for each kind of number: firings of each unit, tokens of each FIFO,
/// rays, and nodes of the pixels' trace trees. See docs/trace_page.md.
class FrameTables final : public EventSink {
 public:
  /// Of `processor`, whose simulation has not started, and which outlives it.
  explicit FrameTables(Processor& processor);
  FrameTables(const FrameTables&) = delete;
  FrameTables& operator=(const FrameTables&) = delete;

  void take(const Event& event) override;

  /// Units, FIFOs, and how many rows each table has.
  nlohmann::ordered_json description() const;
  /// The columns of all tables, one after another.
  std::string bytes() const;

 private:
  /// What a table's column `subject` counts.
  enum class Content : std::uint8_t { nothing, corners, rays, nodes };
  struct Unit {
    Content content;
    std::uint64_t firings = 0;
    Column wait{}, busy{}, cause{}, subject{};
  };
  struct Fifo {
    Content content;
    std::size_t preloaded;  ///< tokens that are there when the frame begins
    std::uint64_t written = 0;
    std::uint64_t read = 0;
    std::deque<Cycle> visible{};  ///< of tokens that have not been read
    Column at{}, latency{}, stay{}, subject{};
  };
  struct CellHash {
    std::size_t operator()(const Cell& cell) const {
      const std::uint64_t point = std::uint64_t{cell.corner.row} << 32U | cell.corner.column;
      return std::hash<std::uint64_t>()((point ^ std::uint64_t{cell.log2_side} << 59U) * 0x9E3779B97F4A7C15U);
    }
  };
  struct SameCell {
    bool operator()(const Cell& a, const Cell& b) const { return a.corner == b.corner && a.log2_side == b.log2_side; }
  };

  void take_firing(const Event& event);
  void take_write(const Event& event);
  void add_ray(const Subject& ray);
  /// The number of `subject`; of a corner `count`.
  std::uint64_t number_of(Content content, const Subject& subject, std::uint64_t count);
  std::uint64_t number_of_node(const Subject& node);

  const Processor& processor_;
  std::size_t generator_ = 0;
  std::vector<Unit> units_;
  std::vector<Fifo> fifos_;
  Column ray_row_, ray_column_, ray_request_;
  std::vector<std::uint32_t> objects_;  ///< that each ray hit, counted from 1; 0: none
  Column node_row_, node_column_, node_log2_side_, node_request_;
  std::vector<std::uint8_t> cases_;  ///< of each node that is terminal, counted from 1; 0: it is split
  std::unordered_map<Cell, std::uint32_t, CellHash, SameCell> nodes_;  ///< their numbers
};

}  // namespace pyrasim::hw
