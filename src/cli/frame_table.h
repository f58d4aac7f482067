// SPDX-License-Identifier: Apache-2.0
// A frame's counts as text for people.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "render/frame_statistics.h"
#include "render/method.h"
#include "scene/scene.h"

namespace pyrasim::cli {

/// 1234567 as "1,234,567".
std::string grouped(std::uint64_t number);

/// "scenes/keel.json at 640x480 pixels", and which of them where there is a window.
std::string frame_title(const std::string& scene, const Screen& screen, const std::optional<PixelWindow>& window);

/// Rays, subdivisions, and the cases of each level.
std::string frame_lines(const FrameStatistics& frame, int max_level);

/// A rendered frame's counts; a peer has rays alone.
std::string rendering_table(const std::string& scene, const Camera& camera, const Method& method,
                            const FrameStatistics& frame);

}  // namespace pyrasim::cli
