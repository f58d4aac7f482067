// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "hw_model/processor.h"
#include "hw_model/record/work_sink.h"
#include "hw_model/report/pixel_history.h"
#include "scene/scene.h"

namespace pyrasim::cli {

/// What rays see, by their points.
class SeenPoints final : public hw::WorkSink {
 public:
  void ray(GridPoint point, const Seen& seen, const Work& /*work*/) override {
    seen_[{point.row, point.column}] = seen;
  }
  void node(const Cell& /*cell*/, const TextureWork& /*work*/) override {}
  /// The ray has been traced.
  const Seen& at(GridPoint point) const { return seen_.at({point.row, point.column}); }

 private:
  std::map<std::pair<std::uint32_t, std::uint32_t>, Seen> seen_;
};

/// One pixel of a frame that is finished: its trace tree with each ray, and what it waited for.
std::string pixel_report(const Scene& scene, const hw::Processor& processor, const hw::PixelHistory& pixel,
                         const SeenPoints& seen);

}  // namespace pyrasim::cli
