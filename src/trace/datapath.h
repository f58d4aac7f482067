// SPDX-License-Identifier: Apache-2.0
// The machine's arithmetic behind one interface, so that the number format is chosen when the program runs.
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

#include "pyramid/sample.h"
#include "scene/scene.h"
#include "trace/surface.h"
#include "trace/view_vector.h"

namespace pyrasim {

/// The number formats that a datapath can have.
enum class ScalarFormat : std::uint8_t { double_precision, single_precision };

/// What the scene asks of an intersection unit: what has a count of 0 need not be built.
struct SceneContents {
  std::array<std::size_t, surface_kinds> surfaces{};  ///< by SurfaceKind
  std::size_t inner_nodes = 0;                        ///< of the bounding volume hierarchy
};

/// View vectors and intersections of one scene on one grid, in one number format.
class Datapath {
 public:
  Datapath() = default;
  Datapath(const Datapath&) = delete;
  Datapath& operator=(const Datapath&) = delete;
  virtual ~Datapath() = default;

  /// Formula (2). The components are the format's values, held exactly in double.
  virtual glm::dvec3 view_vector(GridPoint point) const = 0;
  /// The nearest hit along a view vector that came from view_vector(). Adds the tests made to `work`.
  virtual Sample trace(const glm::dvec3& view_vector, Work& work) const = 0;
  virtual SceneContents contents() const = 0;
};

/// `steps`: grid steps along a pixel's side, as for ViewVectors.
std::unique_ptr<Datapath> make_datapath(const Scene& scene, std::int64_t steps,
                                        ScalarFormat format = ScalarFormat::double_precision);

}  // namespace pyrasim
