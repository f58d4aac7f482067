// SPDX-License-Identifier: Apache-2.0
#include "camera/camera.h"

#include <cassert>

namespace pyrasim {

Screen resized(const Screen& screen, int columns, int rows) {
  assert(columns >= 1 && columns <= max_screen_size && rows >= 1 && rows <= max_screen_size);
  const double scale = static_cast<double>(screen.columns) / columns;
  return {columns, rows, screen.dx, screen.dy * scale, screen.dz * scale};
}

}  // namespace pyrasim
