// SPDX-License-Identifier: Apache-2.0
#include "surface/reading.h"

#include <fmt/format.h>

#include "numeric/vectors.h"

namespace pyrasim {

glm::dvec3 read_direction(const JsonReader& reader) {
  const glm::dvec3 direction = reader.vec3(coordinates);
  if (largest(direction) < min_length) {
    reader.fail("the vector is zero", fmt::format("a component of at least {} in magnitude is needed", min_length));
  }
  return direction;
}

}  // namespace pyrasim
