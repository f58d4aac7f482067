// SPDX-License-Identifier: Apache-2.0
// The ways to render a frame, as a user names them.
#pragma once

#include <string>
#include <string_view>

#include "intersect/datapath_formats.h"
#include "render/baseline_renderer.h"

namespace pyrasim {

/// Pyramids, or one of the peers: `point`, `grid:N`, `jitter:N`.
struct Method {
  bool pyramid = true;
  PyramidOptions pyramids;   ///< where pyramid
  BaselineOptions sampling;  ///< otherwise

  /// "pyramid", "point", "grid:4", "jitter:4".
  std::string name() const;
  /// Steps along a pixel's side of the grid that its rays go through: what number formats have to address.
  std::int64_t grid_steps() const;
};

/// Reads a method's name; the other options stay at their defaults. Throws UsageError.
Method parse_method(std::string_view name);

/// Throws UsageError where the screen has more grid points at `max_level` than a GridPoint can address.
void check_addressable(const Screen& screen, int max_level);

/// Renders `scene` by `method` in the number formats `formats`, on `threads` threads (0: one for each core). Throws
/// UsageError where the screen has more grid points than can be addressed, LimitError where the picture is too large.
/// The picture is not finished where `progress` said to stop.
Rendering render(const Scene& scene, const Method& method, const DatapathFormats& formats, int threads,
                 const Progress& progress = {});

}  // namespace pyrasim
