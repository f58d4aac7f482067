// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "intersect/work.h"
#include "pyramid/cell.h"
#include "texture/texture_work.h"

namespace pyrasim::hw {

/// Takes what each ray of a frame sees and takes, and what terminal nodes take of textures. None of it depends on the
/// machine; the order in which it comes does. To be attached before the simulation starts, and to outlive it.
class WorkSink {
 public:
  virtual ~WorkSink() = default;
  /// A ray through `point`; the same point may be asked for again.
  virtual void ray(GridPoint point, const Seen& seen, const Work& work) = 0;
  /// A terminal node on `cell`; in scenes with textures.
  virtual void node(const Cell& cell, const TextureWork& work) = 0;
};

}  // namespace pyrasim::hw
