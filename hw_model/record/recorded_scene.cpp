// SPDX-License-Identifier: Apache-2.0
#include "hw_model/record/recorded_scene.h"

#include <fmt/format.h>

#include <utility>

#include "error.h"

namespace pyrasim::hw {

RecordedScene::RecordedScene(std::string file, const SceneContents& contents, const ViewVectors& view_vectors,
                             PointTable rays)
    : file_(std::move(file)),
      contents_(contents),
      view_vectors_(view_vectors),
      columns_(contents),
      rays_(std::move(rays)) {}

Sample RecordedScene::intersect(const glm::dvec3& view_vector, Work& work) const {
  const GridPoint point = view_vectors_.point_of(view_vector);
  const std::uint32_t* row = rays_.find(point);
  if (row == nullptr) {
    throw InputError(
        fmt::format("{}: no ray through row {}, column {} of the grid is recorded; it has to be as simulate wrote it",
                    file_, point.row, point.column));
  }
  return {columns_.read(row, work), {}};
}

}  // namespace pyrasim::hw
