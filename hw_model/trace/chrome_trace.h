// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "files/output_file.h"
#include "hw_model/processor.h"
#include "hw_model/trace/trace_writer.h"

namespace pyrasim::hw {

/// Writes the JSON trace format of Chrome (Trace Event Format), which Perfetto, speedscope and many others open: for
/// small traces. A thread for each unit with its states, a counter for each FIFO. One cycle is one microsecond.
///
/// The file is an array, whose end readers do not insist on: one that ends early opens up to there.
class ChromeTrace final : public TraceWriter {
 public:
  /// Of `processor`, elaborated; both outlive it.
  ChromeTrace(const Processor& processor, OutputFile& output);

  void span(const Span& span) override;
  void fill(std::size_t fifo, Cycle at, std::size_t tokens) override;
  void stretch(const PathStretch& stretch) override;
  void finish(Cycle cycles) override;

 private:
  void name_thread(std::size_t number, std::string_view name);

  const Processor& processor_;
  OutputFile& output_;
  bool path_is_named_ = false;
};

}  // namespace pyrasim::hw
