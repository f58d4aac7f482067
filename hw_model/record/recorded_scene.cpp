// SPDX-License-Identifier: Apache-2.0
#include "hw_model/record/recorded_scene.h"

#include <fmt/format.h>

#include <utility>

#include "error.h"

namespace pyrasim::hw {

RecordedScene::RecordedScene(const SceneContents& contents, const ViewVectors& view_vectors, WorkTable rays)
    : contents_(contents),
      view_vectors_(view_vectors),
      columns_(contents),
      rays_(std::move(rays)),
      index_(rays_.rows()) {
  for (std::size_t k = 0; k < rays_.rows(); ++k) {
    index_.set(RayColumns::point(rays_.row(k)), static_cast<std::uint32_t>(k));
  }
}

Sample RecordedScene::intersect(const glm::dvec3& view_vector, Work& work) const {
  const GridPoint point = view_vectors_.point_of(view_vector);
  const auto row = index_.find(point);
  if (!row) {
    throw InputError(fmt::format("no ray through row {}, column {} of the grid is recorded", point.row, point.column));
  }
  return {columns_.read(rays_.row(*row), work), {}};
}

}  // namespace pyrasim::hw
