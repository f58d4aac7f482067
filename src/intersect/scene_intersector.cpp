// SPDX-License-Identifier: Apache-2.0
#include "intersect/scene_intersector.h"

namespace pyrasim {

template class SceneIntersector<double>;
template class SceneIntersector<float>;

}  // namespace pyrasim
