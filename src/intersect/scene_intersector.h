// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "intersect/illumination.h"
#include "intersect/intersector.h"
#include "intersect/prepared_scene.h"
#include "intersect/rounded_scene.h"
#include "intersect/walk.h"
#include "numeric/number_types.h"

namespace pyrasim {

/// Traces the view rays of one scene in the number format of `Scalar` that is set where it is made.
template <class Scalar>
class SceneIntersector final : public Intersector {
 public:
  explicit SceneIntersector(const Scene& scene, Search search = Search::hierarchy);

  Sample intersect(const glm::dvec3& view_vector, Work& work) const override;
  SceneContents contents() const override {
    SceneContents contents;
    for_each_kind([&](auto kind) { contents.surfaces[kind] = std::get<kind>(scene_.kinds).surfaces.size(); });
    contents.inner_nodes = scene_.nodes.size();
    for (const SharedMesh<Scalar>& mesh : scene_.meshes) {
      contents.surfaces[index_of_kind<TriangleSurface>] += mesh.triangles.size();
      contents.inner_nodes += mesh.hierarchy->nodes().size();
    }
    if (illumination_) {
      contents.lights_with_shadows = illumination_->lights_with_shadows();
      contents.shadow_inner_nodes = illumination_->inner_nodes();
    }
    return contents;
  }
  const PreparedScene<Scalar>& scene() const { return scene_; }

 private:
  PreparedScene<Scalar> scene_;
  std::optional<Illumination<Scalar>> illumination_;
};

template <class Scalar>
SceneIntersector<Scalar>::SceneIntersector(const Scene& scene, Search search) {
  PreparedScene<double> prepared = prepare_scene(scene, format_of<Scalar>());
  if (search == Search::exhaustive) prepared.root = prepared.everything;
  if (scene.lights) illumination_.emplace(scene, prepared, scene_);
  scene_ = rounded<Scalar>(std::move(prepared));
  if (illumination_) scene_.illumination = &*illumination_;
}

template <class Scalar>
Sample SceneIntersector<Scalar>::intersect(const glm::dvec3& view_vector, Work& work) const {
  const FormatScope<Scalar> scope(scene_.numbers);
  const auto direction = to_scalar<Scalar>(view_vector);
  // Boxes are bounds of slopes: of use to rays that run forward, as all rays through a screen do.
  const bool forward = direction.x >= std::numeric_limits<Scalar>::min();
  return nearest_hit(scene_, direction, forward ? scene_.root : scene_.everything, work);
}

extern template class SceneIntersector<double>;
extern template class SceneIntersector<float>;
extern template class SceneIntersector<Flt>;
extern template class SceneIntersector<Fix>;

}  // namespace pyrasim
