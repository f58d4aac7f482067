// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "hw_model/record/chunk_writer.h"
#include "hw_model/record/ray_columns.h"
#include "hw_model/record/work_sink.h"
#include "hw_model/record/work_table.h"
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
  /// Rows that wait until they are enough for a chunk.
  struct Rows {
    ChunkType type;
    WorkTable table;
    std::uint64_t written = 0;
  };
  void write_header(const nlohmann::ordered_json& run);
  void write(Rows& rows);

  Processor& processor_;
  ChunkWriter writer_;
  RayColumns ray_columns_;
  Rows rays_;
  Rows nodes_;
};

}  // namespace pyrasim::hw
