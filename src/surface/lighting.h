// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "numeric/scalar.h"

namespace pyrasim {

/// The scene's light as the datapath holds it: one directional light, without shadows.
template <class Scalar>
struct Lighting {
  bool lit = false;  ///< without a light, colours are emitted as they are
  Scalar ambient{1};
  Vector<Scalar> towards_light{0, 0, 0};  ///< of length 1, observer's coordinates
};

/// Lambert's cosine law: ambient + (1 - ambient) cosine.
template <class Scalar>
Scalar lambert(const Lighting<Scalar>& lighting, Scalar cosine) {
  return lighting.ambient + (Scalar(1) - lighting.ambient) * cosine;
}

}  // namespace pyrasim
