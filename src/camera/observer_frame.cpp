// SPDX-License-Identifier: Apache-2.0
#include "camera/observer_frame.h"

#include <cmath>

#include "numeric/vectors.h"

namespace pyrasim {

glm::dvec3 normalized(const glm::dvec3& v) {
  const int exponent =
      -std::ilogb(largest(v));  // beyond what a double holds if the vector is subnormal; ldexp takes it
  const glm::dvec3 scaled(std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent));
  return scaled / std::sqrt(dot(scaled, scaled));
}

ObserverFrame::ObserverFrame(const Camera& camera)
    : position_(camera.position), forward_(normalized(camera.look_at - camera.position)) {
  right_ = normalized(cross(forward_, normalized(camera.up)));
  up_ = cross(right_, forward_);
}

glm::dvec3 ObserverFrame::direction(const glm::dvec3& world) const {
  return {dot(forward_, world), dot(up_, world), dot(right_, world)};
}

}  // namespace pyrasim
