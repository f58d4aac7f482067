// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <queue>
#include <vector>

#include "mesh/orientation.h"

namespace pyrasim {

/// Cuts a polygon into triangles by clipping one corner after the other (Meisters, Polygons have ears, American
/// Mathematical Monthly 82, 1975).
///
/// What a corner's triangle covers is what the polygon's winding numbers lose by the clip: where all triangles turn
/// left, their number over each point is its winding number. So a polygon whose winding numbers are 0 and 1 is covered
/// exactly, whichever corners were clipped, and choosing them well only keeps triangles that turn right away.
class EarClipping {
 public:
  /// The polygon's area must not be negative. `slack`: a distance that does not matter.
  EarClipping(const PlanePoints& corners, double slack);

  /// Positions in the list of corners; all turn left.
  const std::vector<std::array<std::uint32_t, 3>>& triangles() const { return triangles_; }

  /// The area of those triangles that turned right when they were clipped, as a share of the area of all. It is 0 but
  /// for polygons that cross themselves.
  double reversed_share() const { return total_area_ > 0 ? reversed_area_ / total_area_ : 0; }

 private:
  /// What may be clipped; each pass begins when the one before finds nothing more. Corners that fold the polygon onto
  /// itself, without an area, go in every pass.
  enum class Pass {
    clean,     ///< ears that the rest of the polygon does not touch, but in the ear's corners
    touching,  ///< ears that it does not enter
    slack,     ///< ears that it enters no deeper than the slack
    blocked,   ///< all corners that turn left
    any
  };
  enum class Contact { none, touching, inside };

  struct Node {
    glm::dvec2 at;
    std::uint32_t previous;
    std::uint32_t next;
    bool clipped = false;
  };

  /// The shortest cut comes first, then the place decides: not where in the list a corner is.
  struct Candidate {
    double cut;  ///< squared length
    glm::dvec2 at;
    std::uint32_t corner;
    std::uint32_t previous;  ///< of the corner, when the cut was measured
    std::uint32_t next;
    bool operator<(const Candidate& other) const;
  };

  void push(std::uint32_t corner);
  void run(Pass pass);
  bool may_be_clipped(std::uint32_t corner, Pass pass) const;
  /// How the rest of the polygon meets the triangle of a corner that turns left.
  Contact contact_of(std::uint32_t corner, double slack) const;
  void clip(std::uint32_t corner);

  std::vector<Node> nodes_;
  double slack_;
  std::size_t left_;        ///< nodes that are not clipped
  std::uint32_t some_ = 0;  ///< one of them
  std::priority_queue<Candidate> candidates_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  double total_area_ = 0;
  double reversed_area_ = 0;
};

}  // namespace pyrasim
