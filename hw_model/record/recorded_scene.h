// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "camera/view_vector.h"
#include "hw_model/record/point_table.h"
#include "hw_model/record/ray_columns.h"
#include "intersect/intersector.h"

namespace pyrasim::hw {

/// A scene of which nothing is there but what the rays of one frame saw and took. It answers these rays alone, and says
/// what they saw but not how bright that was.
class RecordedScene final : public Intersector {
 public:
  /// `rays`: rows of RayColumns. `view_vectors`: the frame's in double, in which all rays differ.
  /// `file`: that they come from, for messages.
  RecordedScene(std::string file, const SceneContents& contents, const ViewVectors& view_vectors, PointTable rays);

  /// Throws InputError for a ray that is not recorded.
  Sample intersect(const glm::dvec3& view_vector, Work& work) const override;
  SceneContents contents() const override { return contents_; }

 private:
  std::string file_;
  SceneContents contents_;
  ViewVectors view_vectors_;
  RayColumns columns_;
  PointTable rays_;
};

}  // namespace pyrasim::hw
