// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "camera/observer_frame.h"
#include "surface/lighting.h"

namespace pyrasim {

/// What surfaces are brought into: the observer's coordinates, and his scene's light.
struct Preparation {
  ObserverFrame frame;
  Lighting<double> lighting;
};

}  // namespace pyrasim
