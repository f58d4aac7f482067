// SPDX-License-Identifier: Apache-2.0
// The intersection arithmetic behind one interface, so that its number format is chosen when the program runs.
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <memory>

#include "intersect/work.h"
#include "numeric/number_format.h"
#include "raster/sample.h"
#include "scene/scene.h"

namespace pyrasim {

/// What the scene asks of an intersection unit: what has a count of 0 need not be built.
struct SceneContents {
  std::array<std::size_t, surface_kinds> surfaces{};  ///< by SurfaceKind
  std::size_t inner_nodes = 0;                        ///< of the bounding volume hierarchy
  std::size_t shadow_inner_nodes = 0;                 ///< of the one for shadow rays
  std::size_t lights_with_shadows = 0;
};

/// Nearest hits in one scene, computed in one number format.
class Intersector {
 public:
  Intersector() = default;
  Intersector(const Intersector&) = delete;
  Intersector& operator=(const Intersector&) = delete;
  virtual ~Intersector() = default;

  /// The nearest hit of the ray from the observer along `view_vector`, decision D7; the vector is rounded to the format
  /// first. Adds the tests made to `work`. May be called from several threads.
  virtual Sample intersect(const glm::dvec3& view_vector, Work& work) const = 0;
  virtual SceneContents contents() const = 0;
};

/// How an intersector finds the nearest surface: by its hierarchy, or by testing every surface, to check the former.
enum class Search : bool { hierarchy, exhaustive };

std::unique_ptr<Intersector> make_intersector(const Scene& scene, const NumberFormat& format = {},
                                              Search search = Search::hierarchy);

}  // namespace pyrasim
