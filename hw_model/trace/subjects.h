// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "hw_model/trace/event.h"
#include "pyramid/cell.h"

namespace pyrasim::hw {

class Stage;
struct Wire;

/// Tells what a machine's events are about, of which messages carry next to nothing: rays and nodes are issued in order
/// and every FIFO keeps it, so that following them is enough, and costs nothing where nobody listens.
///
/// Of the pixel scan: the corner. Of the generator, the intersection and shadow units and the classifier: the ray, of
/// the latter's firings the newest one. Of the controller, the colour unit and the accumulator: the node, which of a
/// request has its number. Of the frame buffer: the node that completed the pixel. Of free slots: nothing.
class Subjects {
 public:
  /// Tells nothing.
  Subjects() = default;
  Subjects(const std::vector<Stage*>& stages, const std::vector<Wire>& wires, const PixelWindow& window, int max_level);

  /// Of the next event in the order of the stream. `following`: at least all others of its cycle.
  void tell(Event& event, std::span<const Event> following);

 private:
  enum class Content : std::uint8_t { slots, corners, rays, nodes, requests, parents };
  struct Fifo {
    Content content = Content::slots;
    std::size_t writer = 0;  ///< stage
    std::size_t reader = 0;
    std::uint64_t writes = 0;
    std::deque<Subject> inside;
  };

  Subject fired(const Event& event, std::span<const Event> following);
  Subject written(Fifo& fifo, const Subject& said) const;
  Subject read(Fifo& fifo);
  Subject issued();
  Subject node(const Subject& said, std::uint64_t request) const;

  std::vector<Fifo> fifos_;
  std::vector<Subject> at_stage_;  ///< that each stage works on
  std::vector<bool> originates_;   ///< by stage: what a firing is about is known from what it writes, if it writes
  std::size_t generator_ = 0;      ///< stage
  PixelWindow window_;
  int max_level_ = 0;
  std::uint64_t rays_ = 0;      ///< issued
  Subject corner_;              ///< that the generator has read last
  Subject request_;             ///< whose rays are being issued
  std::size_t of_request_ = 0;  ///< of them, those to come
};

}  // namespace pyrasim::hw
