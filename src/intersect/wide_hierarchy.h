// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "intersect/margin.h"
#include "intersect/prepared_scene.h"

namespace pyrasim {

/// For rays through `screen` and a datapath of `format`.
Margin margin_of_view_rays(const PreparedScene<double>& scene, const Screen& screen, const NumberFormat& format);

/// Builds the hierarchy over the bounded surfaces of `scene`, which stand in the order of the scene file, for rays
/// through `screen`. Surfaces end up in the order of the leaves, each leaf's of one kind
/// side by side.
void build_wide_hierarchy(PreparedScene<double>& scene, const Screen& screen, const Margin& margin);

}  // namespace pyrasim
