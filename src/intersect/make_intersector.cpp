// SPDX-License-Identifier: Apache-2.0
#include "intersect/scene_intersector.h"

namespace pyrasim {

std::unique_ptr<Intersector> make_intersector(const Scene& scene, const NumberFormat& format, Search search) {
  return with_number_type(format, [&]<class Scalar>(std::type_identity<Scalar>) -> std::unique_ptr<Intersector> {
    return std::make_unique<SceneIntersector<Scalar>>(scene, search);
  });
}

}  // namespace pyrasim
