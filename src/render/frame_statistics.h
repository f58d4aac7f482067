// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "intersect/datapath_formats.h"
#include "intersect/work.h"
#include "pyramid/classifier.h"
#include "texture/texture_work.h"

namespace pyrasim {

/// What one frame took, whichever way it was rendered. All are counts.
struct FrameStatistics {
  std::array<std::uint64_t, max_level_limit + 1>
      rays_by_level{};  ///< [0] primary; [L] traced to form subpixels of level L
  std::array<std::array<std::uint64_t, pyramid_cases>, max_level_limit + 1> cases_by_level{};  ///< [L][PyramidCase]
  std::uint64_t subdivisions = 0;
  std::uint64_t terminal_nodes = 0;
  /// Rays of a subdivision that some policy need not trace (decision D3): points traced before for the same pixel, and
  /// points on the sides between pixels traced before for the neighbour.
  std::uint64_t repeated_in_pixel = 0;
  std::uint64_t repeated_between_pixels = 0;
  std::uint64_t lights_with_shadows = 0;  ///< of the scene, whatever of it the frame sees
  Work work;
  TextureWork texture;
  DatapathEvents arithmetic;  ///< of software number formats; double and float count nothing

  std::uint64_t primary_rays() const { return rays_by_level[0]; }
  std::uint64_t subdivision_rays_traced() const {
    std::uint64_t sum = 0;
    for (std::size_t level = 1; level < rays_by_level.size(); ++level) sum += rays_by_level[level];
    return sum;
  }
  std::uint64_t total_rays() const { return primary_rays() + subdivision_rays_traced(); }

  void count(PyramidCase which, std::uint32_t level) { ++cases_by_level[level][static_cast<std::size_t>(which)]; }

  FrameStatistics& operator+=(const FrameStatistics& other) {
    for (std::size_t level = 0; level < rays_by_level.size(); ++level) {
      rays_by_level[level] += other.rays_by_level[level];
      for (std::size_t k = 0; k < pyramid_cases; ++k) cases_by_level[level][k] += other.cases_by_level[level][k];
    }
    subdivisions += other.subdivisions;
    terminal_nodes += other.terminal_nodes;
    repeated_in_pixel += other.repeated_in_pixel;
    repeated_between_pixels += other.repeated_between_pixels;
    lights_with_shadows = std::max(lights_with_shadows, other.lights_with_shadows);  // parts show one scene
    work += other.work;
    texture += other.texture;
    arithmetic += other.arithmetic;
    return *this;
  }
  friend bool operator==(const FrameStatistics&, const FrameStatistics&) = default;
};

}  // namespace pyrasim
