// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <utility>

#include "surface/affine_map.h"
#include "surface/pov_writer.h"
#include "surface/preparation.h"

namespace pyrasim {

/// A surface that stands apart, and once for all its copies.
template <class Surface>
class Shared {
 public:
  // Not explicit: it is the surface.
  Shared(Surface surface) : surface_(std::make_shared<const Surface>(std::move(surface))) {}
  operator const Surface&() const { return *surface_; }

  auto transformed(const AffineMap& map) const { return surface_->transformed(map); }
  auto prepared(const Preparation& preparation) const { return surface_->prepared(preparation); }
  void write_pov(PovWriter& pov) const { surface_->write_pov(pov); }

 private:
  std::shared_ptr<const Surface> surface_;
};

}  // namespace pyrasim
