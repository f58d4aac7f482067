// SPDX-License-Identifier: Apache-2.0
// Apart from scene_intersector.cpp: called from one place there, the kernels are inlined into the walk that all rays
// take.
#include "intersect/walk.h"

namespace pyrasim {

template Sample nearest_of_close_hits(const PreparedScene<double>&, const Vector<double>&, std::int32_t, const Tests&,
                                      Work&);

}  // namespace pyrasim
