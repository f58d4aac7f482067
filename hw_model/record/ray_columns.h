// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "intersect/intersector.h"
#include "pyramid/cell.h"
#include "texture/texture_work.h"

namespace pyrasim::hw {

/// What is recorded of a ray, as the numbers of a row: the grid point, what was seen there, and how often it was
/// tested, of each kind of surface and each light with shadows that the scene has.
class RayColumns {
 public:
  /// How many there are where a scene has every kind of surface, and as many lights with shadows as are allowed.
  static constexpr std::size_t most = 4 + 2 * (1 + surface_kinds) + max_shadow_lights;

  explicit RayColumns(const SceneContents& contents);

  /// Of each number: "row", "column", "object" (counted from 1; 0: none), "lights", "box_tests", "surface_tests.sphere"
  /// ...
  const std::vector<std::string>& names() const { return names_; }
  std::size_t size() const { return names_.size(); }
  void write(std::uint32_t* row, GridPoint point, const Seen& seen, const Work& work) const;

  /// Counted from 1; 0: none.
  static std::uint32_t object(const std::uint32_t* row) { return row[2]; }
  /// Adds the row's work to `work`.
  Seen read(const std::uint32_t* row, Work& work) const;

 private:
  /// visit(count) of each that there is a number for, in their order.
  template <class AnyWork, class Visit>
  void for_each_count(AnyWork& work, const Visit& visit) const;

  std::vector<std::size_t> kinds_;  ///< SurfaceKind
  std::size_t lights_;              ///< with shadows
  std::vector<std::string> names_;
};

/// What is recorded of a terminal node, likewise: the corner of its cell, which tells nodes apart, and its texture
/// work.
struct NodeColumns {
  static std::vector<std::string> names() { return {"row", "column", "log2_side", "places", "lines", "texels"}; }
  static constexpr std::size_t size = 6;
  static void write(std::uint32_t* row, const Cell& cell, const TextureWork& work);
  static TextureWork read(const std::uint32_t* row) { return {row[3], row[4], row[5]}; }
};

}  // namespace pyrasim::hw
