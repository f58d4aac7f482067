// SPDX-License-Identifier: Apache-2.0
// Traces view rays: the nearest surface over planes and a bounding volume hierarchy, and its shading.
#pragma once

#include <cstdint>

#include "pyramid/sample.h"
#include "trace/prepared_scene.h"

namespace pyrasim {

/// Traces the view rays of one scene through a datapath of one number format.
template <class Scalar>
class SceneTracer {
 public:
  explicit SceneTracer(const Scene& scene) : scene_(prepare_scene<Scalar>(scene)) {}

  /// The nearest hit of the ray from the observer along `view_vector`, decision D7. Adds the tests made to `work`.
  Sample trace(const Vector<Scalar>& view_vector, Work& work) const;

  const PreparedScene<Scalar>& scene() const { return scene_; }

 private:
  PreparedScene<Scalar> scene_;
};

extern template class SceneTracer<double>;
extern template class SceneTracer<float>;

}  // namespace pyrasim
