// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "files/output_file.h"
#include "hw_model/processor.h"
#include "hw_model/trace/protobuf.h"
#include "hw_model/trace/trace_writer.h"

namespace pyrasim::hw {

/// Writes a trace that Perfetto (ui.perfetto.dev) opens: a track for each unit with its states as slices, a counter for
/// each FIFO, and a flow for each ray through the units that work on it. One cycle is one nanosecond of the trace.
///
/// The file is a sequence of packets (perfetto/trace/trace_packet.proto), each complete in itself: one that ends early
/// opens up to there.
class PerfettoTrace final : public TraceWriter {
 public:
  /// Of `processor`, elaborated; both outlive it.
  PerfettoTrace(const Processor& processor, OutputFile& output);

  void span(const Span& span) override;
  void fill(std::size_t fifo, Cycle at, std::size_t tokens) override;
  void stretch(const PathStretch& stretch) override;
  void finish(Cycle) override {}

 private:
  std::uint64_t track_of_fifo(std::size_t fifo) const;
  void write_track(std::uint64_t track, std::string_view name, bool counter);
  void write_descriptor(const Protobuf& track);
  void begin_event(std::uint64_t type, std::uint64_t track);
  void write_event(Cycle at);
  void write_packet();

  const Processor& processor_;
  OutputFile& output_;
  bool path_is_named_ = false;
  Protobuf packet_, event_;  ///< that are being made; kept so that they need no memory each
  Protobuf framed_;
};

}  // namespace pyrasim::hw
