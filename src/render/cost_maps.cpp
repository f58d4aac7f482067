// SPDX-License-Identifier: Apache-2.0
#include "render/cost_maps.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/common.hpp>

#include "image/map_colors.h"
#include "render/picture_memory.h"
#include "text/counted.h"

namespace pyrasim {
namespace {

constexpr int color_unit = 4095;

std::size_t pixels_of(const PixelWindow& window) {
  return static_cast<std::size_t>(window.columns) * static_cast<std::size_t>(window.rows);
}

/// Pixels that are one node are night blue where they see nothing, steel blue where they see an object; the finer a
/// node, the more of the orange does it take, and an edge that is left at the deepest level is light yellow.
glm::vec3 node_color(PyramidCase which, int level, int max_level) {
  if (which == PyramidCase::edge) return linear_from_srgb_bytes(255, 244, 170);
  const glm::vec3 own =
      which == PyramidCase::empty ? linear_from_srgb_bytes(18, 22, 46) : linear_from_srgb_bytes(70, 104, 150);
  if (level == 0) return own;
  const float share = 0.3F + 0.6F * static_cast<float>(level) / static_cast<float>(max_level);
  return glm::mix(own, linear_from_srgb_bytes(236, 106, 34), share);
}

}  // namespace

CostMaps::CostMaps(const PixelWindow& window, int max_level) : window_(window), max_level_(max_level) {
  const std::size_t pixels = pixels_of(window);
  check_picture_fits(window, physical_memory(), pixels * (sizeof(Nodes) + 2 * sizeof(std::uint64_t)));
  nodes_.resize(pixels);
  latency_.resize(pixels);
  for (int level = 0; level <= max_level; ++level) {
    colors_.emplace_back();
    for (std::size_t which = 0; which < pyramid_cases; ++which) {
      const glm::vec3 color = node_color(static_cast<PyramidCase>(which), level, max_level);
      for (int k = 0; k < 3; ++k) {
        colors_.back()[which][static_cast<std::size_t>(k)] =
            static_cast<std::uint16_t>(std::lround(color[k] * color_unit));
      }
    }
  }
}

std::vector<std::uint64_t> CostMaps::rays() const {
  std::vector<std::uint64_t> rays;
  rays.reserve(nodes_.size());
  for (const Nodes& nodes : nodes_) rays.push_back(1 + subdivision_rays * ((nodes.count - 1) / 3));
  return rays;
}

Image CostMaps::picture(CostMap map) const {
  if (map == CostMap::rays) return heat_map(rays(), window_.columns, window_.rows);
  if (map == CostMap::latency) return heat_map(latency_, window_.columns, window_.rows);
  Image image(window_.columns, window_.rows);
  for (std::size_t pixel = 0; pixel < nodes_.size(); ++pixel) {
    for (int k = 0; k < 3; ++k) {
      const double sum =
          std::ldexp(static_cast<double>(nodes_[pixel].color[static_cast<std::size_t>(k)]), -2 * max_level_);
      image.pixels()[pixel][k] = static_cast<float>(sum / color_unit);
    }
  }
  return image;
}

Image CostMaps::numbers(CostMap map) const {
  if (map == CostMap::cases) return picture(map);
  const std::vector<std::uint64_t> values = map == CostMap::rays ? rays() : latency_;
  Image image(window_.columns, window_.rows);
  for (std::size_t pixel = 0; pixel < values.size(); ++pixel) {
    image.pixels()[pixel] = glm::vec3(static_cast<float>(values[pixel]));
  }
  return image;
}

std::string CostMaps::legend(CostMap map) const {
  if (map == CostMap::cases) {
    return "night blue: empty, steel blue: covered, both the more orange the deeper their level; light yellow: an edge "
           "at the deepest";
  }
  const auto [least, most] = heat_scale(map == CostMap::rays ? rays() : latency_);
  return fmt::format("{} a pixel, dark, to {}, light; by logarithms",
                     counted(least, map == CostMap::rays ? "ray" : "cycle"), most);
}

}  // namespace pyrasim
