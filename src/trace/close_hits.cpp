// SPDX-License-Identifier: Apache-2.0
// Apart from scene_tracer.cpp: called from one place there, the kernels are inlined into the walk that all rays take.
#include "trace/walk.h"

namespace pyrasim {

template Sample nearest_of_close_hits(const PreparedScene<double>&, const Vector<double>&, std::int32_t, const Work&,
                                      Work&);
template Sample nearest_of_close_hits(const PreparedScene<float>&, const Vector<float>&, std::int32_t, const Work&,
                                      Work&);

}  // namespace pyrasim
