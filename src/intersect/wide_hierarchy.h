// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "intersect/prepared_scene.h"

namespace pyrasim {

/// Builds the hierarchy over the bounded surfaces of `scene`, which stand in the order of the scene file, for rays
/// through `screen` and a datapath of `format`. Surfaces end up in the order of the leaves, each leaf's of one kind
/// side by side.
void build_wide_hierarchy(PreparedScene<double>& scene, const Screen& screen, const NumberFormat& format);

}  // namespace pyrasim
