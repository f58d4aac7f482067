// SPDX-License-Identifier: Apache-2.0
#include "intersect/scene_intersector.h"

#include "intersect/intersector_among.h"

namespace pyrasim {

template class SceneIntersector<double>;
template class SceneIntersector<float>;
template std::unique_ptr<Intersector> intersector_among(ProcessorNumbers, const Scene&, const NumberFormat&, Search);

}  // namespace pyrasim
