// SPDX-License-Identifier: Apache-2.0
// What a unit that traces rays is made of: a walker of the hierarchy, and a tester for each kind of surface.
#pragma once

#include <vector>

#include "hw_model/machine_spec.h"
#include "hw_model/plan/need.h"
#include "intersect/intersector.h"

namespace pyrasim::hw {

/// A part of a stage. A stage that has parts lists them: parts().
struct StagePart {
  std::string name;
  Need need;
  Cycle busy = 0;  ///< of the stage's busy cycles those that it took
};

/// Of a unit that made `tests` at `cost`, for so many surfaces of each kind and inner nodes of a hierarchy. What is
/// left of the unit's busy cycles is what each ray costs beside.
std::vector<StagePart> tester_parts(const std::array<std::size_t, surface_kinds>& surfaces, std::size_t inner_nodes,
                                    const Tests& tests, const IntersectionCost& cost);

}  // namespace pyrasim::hw
