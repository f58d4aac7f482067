// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "surface/affine_map.h"
#include "surface/box.h"

namespace pyrasim {

/// What affine maps make of a box.
struct Parallelepiped {
  QuadrupleVector corner;
  QuadrupleMatrix edges;  ///< from the corner

  Parallelepiped transformed(const AffineMap& map) const;
  Prepared<BoxSurface> prepared(const Preparation& preparation) const;
  void write_pov(PovWriter& pov) const;
};

}  // namespace pyrasim
