// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <unordered_map>

#include "contact.h"

namespace pyrasim::silhouettes {

/// The object that a ray sees, exactly.
std::uint32_t object_seen(const ExactScene& scene, const Ray& ray);

/// That object by testing every surface near the ray in Real, never in double.
std::uint32_t object_seen_in_real(const ExactScene& scene, const Ray& ray);

/// A grid point as one number.
inline std::uint64_t address(GridPoint point) { return (std::uint64_t{point.row} << 32U) | point.column; }

/// The objects seen through the points of a screen's grid, each looked for once.
class Oracle {
 public:
  Oracle(const Scene& scene, int max_level) : scene_(scene), screen_(scene.camera.screen), max_level_(max_level) {}

  std::uint32_t object(GridPoint point) {
    const auto [entry, fresh] = seen_.try_emplace(address(point));
    if (fresh) entry->second = object_seen(scene_, ray(point));
    return entry->second;
  }
  Ray ray(GridPoint point) const { return {screen_, steps(), point}; }

  const ExactScene& scene() const { return scene_; }
  const Screen& screen() const { return screen_; }
  int max_level() const { return max_level_; }
  std::int64_t steps() const { return std::int64_t{1} << max_level_; }  ///< along a pixel's side

 private:
  ExactScene scene_;
  Screen screen_;
  int max_level_;
  std::unordered_map<std::uint64_t, std::uint32_t> seen_;
};

}  // namespace pyrasim::silhouettes
