// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "hw_model/trace/event.h"

namespace pyrasim::hw {

class Stage;
struct Wire;

/// Numbers the rays of a machine's events, which no message carries: rays are issued in order and every FIFO keeps it,
/// so that counting is enough, and costs nothing where nobody listens.
///
/// A ray has the number of its issue, and as its parent that of the request that asked for it. Both are known of: the
/// firings of the generator, of the intersection and shadow units and of the classifier (of its newest sample); the
/// reads and writes of the units' FIFOs and of the issue-order queue. A request's writes and reads, on its way to the
/// generator and of its node to the classifier, have its number as `parent`.
class RayNumbers {
 public:
  /// Numbers nothing.
  RayNumbers() = default;
  RayNumbers(const std::vector<Stage*>& stages, const std::vector<Wire>& wires);

  /// Of the next event in the order of the stream.
  void number(Event& event);

 private:
  struct Ray {
    std::uint64_t ray = no_number;
    std::uint64_t parent = no_number;
  };
  enum class Content : std::uint8_t { other, rays, requests };
  struct Fifo {
    Content content = Content::other;
    std::size_t writer = 0;  ///< stage
    std::size_t reader = 0;
    std::uint64_t writes = 0;
    std::deque<Ray> inside;
  };

  Ray written(Fifo& fifo) const;
  Ray read(Fifo& fifo);
  Ray issued();

  std::vector<Fifo> fifos_;
  std::vector<Ray> at_stage_;   ///< that each stage works on
  std::size_t generator_ = 0;   ///< stage
  std::uint64_t rays_ = 0;      ///< issued
  std::uint64_t request_ = 0;   ///< whose rays are being issued
  std::size_t of_request_ = 0;  ///< of them, those to come
};

}  // namespace pyrasim::hw
