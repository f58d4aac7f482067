// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "hw_model/record/chunk_writer.h"
#include "hw_model/record/recorded_work.h"
#include "hw_model/trace/trace.h"

namespace pyrasim::hw {

/// Writes the program's own trace, .ptrace: what was run, what each ray and node took, and what came of it. From that
/// the frame can be simulated again without its scene, on any machine.
class RunTrace final : public Trace, public WorkSink {
 public:
  /// `run` describes scene and settings.
  RunTrace(Processor& processor, const nlohmann::ordered_json& run, OutputFile& output);

  void ray(GridPoint point, const Seen& seen, const Work& work) override;
  void node(const Cell& cell, const TextureWork& work) override;
  void finish(Cycle cycles) override;

 private:
  void write_header(const nlohmann::ordered_json& run);
  void write(ChunkType type, WorkTable& rows);

  Processor& processor_;
  ChunkWriter writer_;
  RecordedWork waiting_;     ///< rows, until they are enough for a chunk
  std::uint64_t rays_ = 0;   ///< written
  std::uint64_t nodes_ = 0;  ///< written
};

}  // namespace pyrasim::hw
