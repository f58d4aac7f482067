// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "hw_model/record/ray_columns.h"
#include "hw_model/record/work_sink.h"
#include "hw_model/record/work_table.h"

namespace pyrasim::hw {

/// Keeps what it takes, as rows of RayColumns and of NodeColumns.
class RecordedWork final : public WorkSink {
 public:
  /// Of a scene of `contents`. Of work that takes more than `most` numbers nothing is kept.
  explicit RecordedWork(const SceneContents& contents, std::size_t most = SIZE_MAX);

  void ray(GridPoint point, const Seen& seen, const Work& work) override;
  void node(const Cell& cell, const TextureWork& work) override;
  /// Whether all is there.
  bool whole() const { return whole_; }

  /// Both tables as bytes.
  std::string packed() const;
  /// Adds the rows that packed() made `bytes` of; whether it did.
  bool add_packed(std::string_view bytes);

  const RayColumns columns;
  WorkTable rays;
  WorkTable nodes;  ///< that took something of textures

 private:
  bool has_room();  ///< for a further row; drops all where there is none

  std::size_t most_;
  bool whole_ = true;
};

}  // namespace pyrasim::hw
