// SPDX-License-Identifier: Apache-2.0
// Lights as one place sees them.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "camera/observer_frame.h"
#include "shading/light.h"

namespace pyrasim {

/// What comes from one light.
struct Incidence {
  glm::dvec3 towards;   ///< of length 1
  double distance = 0;  ///< in the unit of the place; infinite where the light is directional
  glm::dvec3 color;     ///< where it meets a surface at a right angle; infinite at the light itself
};

/// The lights of a scene in observer's coordinates times 2^exponent.
class PreparedLights {
 public:
  /// `shadows`: something casts them.
  PreparedLights(const std::vector<Light>& lights, const ObserverFrame& frame, int exponent, bool shadows);

  const glm::dvec3& ambient() const { return ambient_; }
  /// Those with shadows, up to max_shadow_lights.
  std::size_t with_shadows() const { return with_shadows_; }

  /// visit(incidence, shadow) for each light but ambient ones. shadow: its number among those with shadows, or none.
  template <class Visit>
  void for_each_at(const glm::dvec3& place, const Visit& visit) const {
    for (const Source& source : sources_) visit(source.at(place), source.shadow);
  }

 private:
  struct Source {
    glm::dvec3 color;
    std::optional<std::size_t> shadow;
    bool directional;
    glm::dvec3 where;  ///< its direction or its place
    Falloff falloff = Falloff::none;
    double unit = 1;  ///< of the scene's lengths
    Incidence at(const glm::dvec3& place) const;
  };

  glm::dvec3 ambient_{0, 0, 0};
  std::vector<Source> sources_;
  std::size_t with_shadows_ = 0;
};

}  // namespace pyrasim
