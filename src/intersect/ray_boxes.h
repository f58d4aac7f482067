// SPDX-License-Identifier: Apache-2.0
// Ordinary boxes for the hierarchy of a prepared scene, for rays that start anywhere and run anywhere: those of slope
// space serve rays from the observer only.
#pragma once

#include <array>
#include <vector>

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
  /// Of the hierarchy below `scene`.root, for a datapath of `format`; `scene` is not yet rounded to it.
  RayBoxes(const PreparedScene<double>& scene, const NumberFormat& format);

  /// By half of which boxes are grown.
  const Margin& margin() const { return margin_; }

  /// What boxes ask of a ray, worked out once.
  struct Query {
    glm::dvec3 above;    ///< the origin, and the margin on
    glm::dvec3 below;    ///< and the margin off
    glm::dvec3 inverse;  ///< 1 / direction; where the ray runs along an axis' planes, the largest number
  };
  Query query(const GeneralRay& ray) const;

  /// The boxes of the children of node `node` as one ray asks for them: bit k, the ray may meet what box k holds at a t
  /// of at most `limit`. Compared in double, whatever the format, with all that the datapath may err by added to the
  /// boxes: no hit that the datapath counts is missed.
  unsigned met(std::size_t node, const Query& query, double limit) const;

 private:
  /// The boxes of a node's children side by side.
  struct alignas(64) Node {
    using Bound = std::array<double, node_width>;
    std::array<Bound, 3> lower{};  ///< by axis
    std::array<Bound, 3> upper{};
    unsigned children = 0;  ///< a bit each
  };

  BoundingBox add(const PreparedScene<double>& scene, std::int32_t reference);

  Margin margin_;
  bool generators_ = false;  ///< a surface has some
  std::vector<Node> nodes_;
};

}  // namespace pyrasim
