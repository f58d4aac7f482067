// SPDX-License-Identifier: Apache-2.0
// The hierarchy of ordinary boxes over the surfaces of a prepared scene.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "intersect/box_hierarchy.h"
#include "intersect/margin.h"
#include "intersect/prepared_scene.h"

namespace pyrasim {

/// A ray from anywhere, in the prepared scene's coordinates; in double, its numbers are values of the datapath's
/// format. It ends at `limit` times its direction.
struct GeneralRay {
  glm::dvec3 origin;
  glm::dvec3 direction;  ///< of any length but 0; in fixed point at most the root of 3
  double limit = std::numeric_limits<double>::infinity();
};

class RayBoxes {
 public:
  /// For a datapath of `format`; `scene` is not yet rounded to it.
  RayBoxes(const PreparedScene<double>& scene, const NumberFormat& format);

  /// A bounded surface: the place of one in PreparedScene::kinds.
  struct Item {
    SurfaceKind kind;
    std::uint32_t index;
  };

  /// By half of which boxes are grown: no hit that the datapath counts is missed, whatever the format.
  const Margin& margin() const { return margin_; }
  const BoxHierarchy& hierarchy() const { return hierarchy_; }
  BoxHierarchy::Query query(const GeneralRay& ray) const;
  /// What a leaf of the hierarchy holds.
  std::span<const Item> leaf(std::int32_t reference) const {
    const auto [first, count] = hierarchy_.leaf(reference);
    return std::span(items_).subspan(first, count);
  }

 private:
  Margin margin_;
  bool generators_ = false;  ///< a surface has some
  BoxHierarchy hierarchy_;
  std::vector<Item> items_;  ///< in the order of leaves
};

}  // namespace pyrasim
