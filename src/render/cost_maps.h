// SPDX-License-Identifier: Apache-2.0
// What each pixel of a frame took, as pictures of the frame's size.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "image/image.h"
#include "pyramid/classifier.h"

namespace pyrasim {

enum class CostMap : std::uint8_t {
  cases,    ///< each terminal node's area in a colour of its case and level
  rays,     ///< that the pixel asked for: its own corner and five for each subdivision
  latency,  ///< cycles from its first ray on, on a machine
};
inline constexpr std::array<std::string_view, 3> cost_map_names{"cases", "rays", "latency"};

/// Filled while a frame is made; pixels may be filled by several threads, each by one. Pixels are numbered row by row
/// inside the window.
class CostMaps {
 public:
  /// Throws LimitError where picture and maps together do not fit into memory.
  CostMaps(const PixelWindow& window, int max_level);

  void add_terminal_node(std::size_t pixel, PyramidCase which, std::uint32_t log2_side) {
    Nodes& nodes = nodes_[pixel];
    const Color& color = colors_[level_of(log2_side, max_level_)][static_cast<std::size_t>(which)];
    for (std::size_t k = 0; k < 3; ++k) nodes.color[k] += static_cast<std::uint64_t>(color[k]) << 2 * log2_side;
    ++nodes.count;
  }
  void set_latency(std::size_t pixel, std::uint64_t cycles) { latency_[pixel] = cycles; }

  /// Of each pixel. A tree whose nodes are split in four s times has 1 + 3s terminal nodes.
  std::vector<std::uint64_t> rays() const;
  const std::vector<std::uint64_t>& latency() const { return latency_; }

  Image picture(CostMap map) const;
  /// The numbers themselves, in all three components; of cases, which are none, the picture.
  Image numbers(CostMap map) const;
  /// What the picture's colours say, in one line.
  std::string legend(CostMap map) const;

 private:
  using Color = std::array<std::uint16_t, 3>;  ///< linear, in parts of color_unit
  struct Nodes {
    std::array<std::uint64_t, 3> color{};  ///< times squares of the grid
    std::uint64_t count = 0;
  };

  PixelWindow window_;
  int max_level_;
  std::vector<std::array<Color, pyramid_cases>> colors_;  ///< [level][PyramidCase]
  std::vector<Nodes> nodes_;
  std::vector<std::uint64_t> latency_;
};

}  // namespace pyrasim
