// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "camera/observer_frame.h"
#include "surface/lighting.h"

namespace pyrasim {

/// 113 bits: a sum of products of doubles and what is left when such sums cancel come out exact to double's rounding.
__extension__ using Quadruple = __float128;

/// What surfaces are brought into: the observer's coordinates, and his scene's light.
struct Preparation {
  ObserverFrame frame;
  Lighting<double> lighting;
};

}  // namespace pyrasim
