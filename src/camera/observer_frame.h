// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "camera/camera.h"

namespace pyrasim {

/// The observer's coordinates: x forward, y up, z right (right-handed), the centre of projection at the origin.
/// A scene is brought into them once, in double, so that no ray has to be turned or moved.
class ObserverFrame {
 public:
  explicit ObserverFrame(const Camera& camera);
  glm::dvec3 point(const glm::dvec3& world) const { return direction(world - position_); }
  glm::dvec3 direction(const glm::dvec3& world) const;
  const glm::dvec3& position() const { return position_; }
  /// His axes, of length 1, in the world's coordinates.
  const glm::dvec3& forward() const { return forward_; }
  const glm::dvec3& up() const { return up_; }
  const glm::dvec3& right() const { return right_; }

 private:
  glm::dvec3 position_;
  glm::dvec3 forward_;
  glm::dvec3 up_;
  glm::dvec3 right_;
};

/// `v` at length 1, without overflow or underflow on the way.
glm::dvec3 normalized(const glm::dvec3& v);

}  // namespace pyrasim
