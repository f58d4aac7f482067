// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "hw_model/trace/event_stream.h"

namespace pyrasim::hw {

/// Where a stage or FIFO reports to: the stream, and its own place in it. Nowhere, as long as nobody listens.
class EventPort {
 public:
  EventPort() = default;
  EventPort(EventStream& stream, std::size_t source) : stream_(&stream), source_(static_cast<std::uint32_t>(source)) {}

  explicit operator bool() const { return stream_ != nullptr; }
  void read(Cycle at) const { stream_->put({.kind = Event::Kind::read, .source = source_, .at = at}); }
  void write(Cycle at, Cycle visible, const Subject& subject) const {
    stream_->put({.kind = Event::Kind::write, .source = source_, .at = at, .until = visible, .subject = subject});
  }
  void firing(StageState waited, std::uint32_t cause, Cycle since, Cycle at, Cycle until) const {
    stream_->put({.kind = Event::Kind::firing,
                  .waited = waited,
                  .source = source_,
                  .cause = cause,
                  .at = at,
                  .since = since,
                  .until = until});
  }
  /// The place of the stage or FIFO.
  std::uint32_t source() const { return source_; }

 private:
  EventStream* stream_ = nullptr;
  std::uint32_t source_ = 0;
};

}  // namespace pyrasim::hw
