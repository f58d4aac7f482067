// SPDX-License-Identifier: Apache-2.0
#include "trace/scene_tracer.h"

namespace pyrasim {

template class SceneTracer<double>;
template class SceneTracer<float>;

}  // namespace pyrasim
