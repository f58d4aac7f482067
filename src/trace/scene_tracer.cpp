// SPDX-License-Identifier: Apache-2.0
#include "trace/scene_tracer.h"

#include "trace/tracer_among.h"

namespace pyrasim {

template class SceneTracer<double>;
template class SceneTracer<float>;
template std::unique_ptr<Tracer> tracer_among(ProcessorNumbers, const Scene&, const NumberFormat&, Search);

}  // namespace pyrasim
