// SPDX-License-Identifier: Apache-2.0
#include "trace/datapath.h"

#include "trace/scene_tracer.h"

namespace pyrasim {
namespace {

template <class Scalar>
class DatapathOf final : public Datapath {
 public:
  DatapathOf(const Scene& scene, std::int64_t steps) : tracer_(scene), view_vectors_(scene.camera.screen, steps) {}

  glm::dvec3 view_vector(GridPoint point) const override { return glm::dvec3(view_vectors_(point)); }
  Sample trace(const glm::dvec3& view_vector, Work& work) const override {
    return tracer_.trace(to_scalar<Scalar>(view_vector), work);
  }
  SceneContents contents() const override {
    const PreparedScene<Scalar>& scene = tracer_.scene();
    return {{scene.spheres.size(), scene.planes.size(), scene.triangles.size()}, scene.nodes.size()};
  }

 private:
  SceneTracer<Scalar> tracer_;
  ViewVectors<Scalar> view_vectors_;
};

}  // namespace

std::unique_ptr<Datapath> make_datapath(const Scene& scene, std::int64_t steps, ScalarFormat format) {
  if (format == ScalarFormat::single_precision) return std::make_unique<DatapathOf<float>>(scene, steps);
  return std::make_unique<DatapathOf<double>>(scene, steps);
}

}  // namespace pyrasim
