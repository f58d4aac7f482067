// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "hw_model/processor.h"
#include "hw_model/trace/event.h"

namespace pyrasim::hw {

/// A token's way from one stage to another, in cycles: written by a firing of the one, read by a firing of the other.
struct Hop {
  std::size_t fifo;  ///< in Processor::fifos()
  Subject subject;
  Cycle written;
  Cycle served;        ///< the end of the busy time of the firing that wrote it
  Cycle visible;       ///< when it could be read
  Cycle read = never;  ///< as long as it has not been
};

/// A stretch of a pixel's life, [begin, end) in cycles.
struct LifeStep {
  enum class Kind : std::uint8_t {
    service,  ///< a stage's work on it, in the stage's busy cycles
    latency,  ///< of a stage beyond them
    waiting,  ///< in a FIFO
    held,     ///< in a stage that goes on with it later: the controller with a node to be split, the generator with a
              ///< request's further rays, the classifier with a node whose last corner is known
  };
  Kind kind;
  std::size_t place;  ///< in Processor::stages(); of `waiting` in Processor::fifos()
  Cycle begin;
  Cycle end;
};

/// What happened to one pixel: its rays and nodes on their way through the machine, and those of the three corners that
/// its neighbours ask for, from their issue on.
class PixelHistory final : public EventSink {
 public:
  /// Of `processor`, whose simulation has not started, and whose events it has to be told. `pixel`: inside the window.
  PixelHistory(const Processor& processor, std::uint32_t pixel);

  void take(const Event& event) override;

  std::uint32_t pixel() const { return pixel_; }
  const Cell& cell() const { return cell_; }
  /// In the order of their writing.
  const std::vector<Hop>& hops() const { return hops_; }
  /// When the frame buffer had stored it; `never` as long as it has not.
  Cycle stored() const { return stored_; }
  /// Its latency without gaps: from the scan's sending of the corner that completes it until the frame buffer can read
  /// it; back from its end, each time what came last. Empty as long as the frame buffer has not read it.
  std::vector<LifeStep> life() const;

 private:
  bool is_about(const Subject& subject) const;
  const Hop* read_by(std::size_t stage, Cycle at) const;
  const Hop* held_for(const Hop& hop, std::size_t stage) const;

  const Processor& processor_;
  std::uint32_t pixel_;
  Cell cell_;
  std::vector<std::size_t> writers_, readers_;   ///< stages, by FIFO
  std::vector<Cycle> served_;                    ///< by stage: the end of its newest firing
  std::vector<std::deque<std::size_t>> unread_;  ///< hops, by FIFO
  std::size_t frame_buffer_ = 0;                 ///< stage
  std::vector<Hop> hops_;
  Cycle stored_ = never;
};

}  // namespace pyrasim::hw
