// SPDX-License-Identifier: Apache-2.0
// The one place where the kernels are compiled for every number format.
#include "trace/scene_tracer.h"

namespace pyrasim {

std::unique_ptr<Tracer> make_tracer(const Scene& scene, const NumberFormat& format) {
  return with_number_type(format, [&]<class Scalar>(std::type_identity<Scalar>) -> std::unique_ptr<Tracer> {
    return std::make_unique<SceneTracer<Scalar>>(scene);
  });
}

}  // namespace pyrasim
