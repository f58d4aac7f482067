// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "surface/list.h"
#include "texture/texture.h"

namespace pyrasim {

/// A texture on a surface as it was written: transforms move both.
struct ObjectTexture {
  Texture texture;
  std::shared_ptr<const SceneSurface> written;
  AffineMap map;  ///< that made the object's surface of it
};

}  // namespace pyrasim
