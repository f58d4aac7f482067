// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "trace/prepared_scene.h"

namespace pyrasim {

/// Builds the hierarchy over the bounded surfaces of `scene`, which stand in the order of the scene file, for rays
/// through `screen`. Surfaces end up in the order of the leaves, each leaf's of one kind side by side.
template <class Scalar>
void build_wide_hierarchy(PreparedScene<Scalar>& scene, const Screen& screen);

extern template void build_wide_hierarchy<double>(PreparedScene<double>&, const Screen&);
extern template void build_wide_hierarchy<float>(PreparedScene<float>&, const Screen&);

}  // namespace pyrasim
