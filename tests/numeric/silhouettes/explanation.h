// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "contact.h"
#include "raster/sample.h"

namespace pyrasim::silhouettes {

/// Which objects a datapath may see along one ray, by the error bounds of its rounding.
///
/// An object is explained where one of its surfaces may count as hit, not certainly behind a hit on another object that
/// is itself certain; and the background, where no hit is certain. A hit on a mesh is certain though the ray runs
/// through an edge, as long as triangles on both sides share it: rounding moves a vertex, not the triangles apart. Only
/// a silhouette of the mesh or its border lets the ray by, or a triangle so small that nothing is left of it.
///
/// Where the datapath grants two hits ranges that meet, it sees the first in the scene (decision D7): an object that
/// comes before all those that it lies behind is explained by that too. What counts is whose ranges meet that of the
/// nearest hit: one that comes first and lies in front does not matter, where its range begins behind the nearest's.
class Explanation {
 public:
  /// `contacts` are those of the ray for `rounding` or more.
  Explanation(const ExactScene& scene, const Ray& ray, const std::vector<Contact>& contacts, const Rounding& rounding);

  bool allows(std::uint32_t object) const;

 private:
  /// How far behind the nearest hit it lies at most, and its range ends.
  struct Certain {
    double behind, ends;
  };
  std::optional<Certain> certain_hit(std::size_t contact) const;
  bool allows(const Contact& contact, const Verdict& verdict) const;
  /// Whether the contact may tie with a hit that is nearer than a certain one, and come before it in the scene.
  bool ties_before(const Contact& contact, const Verdict& verdict, const Certain& certain) const;

  const ExactScene& scene_;
  const std::vector<Contact>& contacts_;
  std::vector<Verdict> verdicts_;
  std::unordered_map<std::uint32_t, std::size_t> facets_;  ///< contacts by the facet's index
  std::vector<std::optional<Certain>> certain_;            ///< of each contact
};

/// The part of its rounding unit by which a datapath's seeing `object` is explained: 1 if it errs by as much as its
/// bound allows; none if it cannot be explained.
std::optional<double> part_of_bound(const ExactScene& scene, const Ray& ray, const std::vector<Contact>& contacts,
                                    const Rounding& rounding, std::uint32_t object);

}  // namespace pyrasim::silhouettes
