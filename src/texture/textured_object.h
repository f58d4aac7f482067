// SPDX-License-Identifier: Apache-2.0
// What rays see of an object's texture. Worked out in double, whatever the datapath's format: samples carry no place,
// so that rays through a pyramid's corners meet the object once more, alone.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "intersect/general_walk.h"
#include "scene/scene.h"

namespace pyrasim {

class TexturedObject {
 public:
  /// `scene.objects[object]` has a texture.
  TexturedObject(const Scene& scene, std::size_t object);
  TexturedObject(const TexturedObject&) = delete;
  TexturedObject& operator=(const TexturedObject&) = delete;

  /// The texture's colour where a view vector of the scene's camera meets the object; its mean where that, in double,
  /// passes it by. Adds the work.
  glm::dvec3 color_at(const glm::dvec3& view_vector, TextureWork& work) const;
  /// The mean over what a pyramid covers of it. `corners`: 0 upper left, 1 upper right, 2 lower left, 3 lower right.
  ///
  /// The footprint is the quadrilateral between the four places in the surface's coordinates: what a pyramid covers of
  /// a plane, and an approximation on curved surfaces. Corners on different charts, or one that passes the object by,
  /// leave none: then the mean of what the corners see counts.
  glm::dvec3 color_over(const std::array<glm::dvec3, 4>& corners, TextureFilter filter, TextureWork& work) const;

 private:
  std::optional<SurfaceCoordinates> coordinates(const glm::dvec3& view_vector) const;
  glm::dvec3 color_of(const std::optional<SurfaceCoordinates>& place) const;

  ObjectTexture texture_;
  /// From the prepared scene's coordinates to those that the surface was written in.
  std::array<glm::dvec3, 3> rows_;
  glm::dvec3 offset_;
  PreparedScene<double> alone_;
  RayBoxes boxes_;
  GeneralScene<double> rays_{alone_, boxes_};
};

}  // namespace pyrasim
