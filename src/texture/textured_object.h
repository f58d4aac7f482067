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
  /// leave none: then the mean of what the corners see counts. On a mesh each corner has a footprint, on the plane of
  /// the triangle that it sees, so that seams do not matter; and their means' mean counts.
  glm::dvec3 color_over(const std::array<glm::dvec3, 4>& corners, TextureFilter filter, TextureWork& work) const;

 private:
  /// What a ray sees of the object.
  struct Seen {
    glm::dvec3 view_vector;
    double t;
    std::uint32_t triangle;  ///< of a mesh, from 0
  };
  using Place = std::optional<SurfaceCoordinates>;

  std::optional<Seen> seen(const glm::dvec3& view_vector) const;
  Place coordinates(const std::optional<Seen>& seen) const;
  glm::dvec3 color_of(const Place& place) const;
  glm::dvec3 color_over_mesh(const std::array<glm::dvec3, 4>& corners, const std::array<std::optional<Seen>, 4>& hits,
                             TextureWork& work) const;
  /// What a pyramid covers of the plane of a triangle that one of its corners sees, if it meets the plane about as far
  /// away as the object.
  std::optional<Footprint> footprint_on(const Seen& seen, const std::array<glm::dvec3, 4>& corners,
                                        const std::array<std::optional<Seen>, 4>& hits) const;
  /// A direction of the prepared scene in the coordinates that the surface was written in.
  glm::dvec3 written_direction(const glm::dvec3& v) const;

  ObjectTexture texture_;
  const TriangleMesh* mesh_;  ///< that the texture is laid out by, if the surface is one
  /// From the prepared scene's coordinates to those that the surface was written in.
  std::array<glm::dvec3, 3> rows_;
  glm::dvec3 offset_;
  PreparedScene<double> alone_;
  RayBoxes boxes_;
  GeneralScene<double> rays_{alone_, boxes_};
};

}  // namespace pyrasim
