// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hw_model/plan/stage_list.h"

namespace pyrasim::hw {

/// Whether a stage of the machine is of one of these kinds: is_one_of<ColorUnit, TreeAccumulator>(stage).
template <class... Kind>
bool is_one_of(const Stage& stage) {
  return ((stage.box() == box_of<Kind>()) || ...);
}

}  // namespace pyrasim::hw
