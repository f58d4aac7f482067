// SPDX-License-Identifier: Apache-2.0
#include "intersect/scene_intersector.h"

template class pyrasim::SceneIntersector<pyrasim::Flt>;
