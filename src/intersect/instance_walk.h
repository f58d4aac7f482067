// SPDX-License-Identifier: Apache-2.0
// How a ray goes through an instance of a mesh.
#pragma once

#include <cstdint>
#include <limits>

#include "intersect/instanced_triangle.h"
#include "intersect/prepared_scene.h"
#include "intersect/standing.h"
#include "intersect/traversal.h"

namespace pyrasim {

/// The query of traverse(). `sought.limit()`: up to which t hits count now.
template <class Sought>
struct InstanceQuery {
  const Sought& sought;
  BoxHierarchy::Query boxes;

  unsigned met(const BoxHierarchy::Node& node) const { return BoxHierarchy::met(node, boxes, sought.limit()); }
  bool behind(const BoxHierarchy::Node&, std::size_t) const { return !(sought.limit() >= 0); }
};

/// Calls sought.meet(place in the mesh, t) for each triangle that a ray along `along` is found to meet, from where the
/// instance's rays start; boxes are grown by `margin`. Adds the tests made.
template <class Scalar, class Sought>
void walk_instance(const PreparedScene<Scalar>& scene, const InstanceSurface<Scalar>& instance,
                   const Vector<Scalar>& along, double margin, Sought& sought, Tests& tests) {
  ++tests.surface_tests[index_of_kind<InstanceSurface>];
  const Vector<Scalar> direction = instance.direction(along);
  const auto shear = instance.shear(direction);
  if (!shear) return;
  const SharedMesh<Scalar>& mesh = scene.meshes[instance.mesh];
  const BoxHierarchy& hierarchy = *mesh.hierarchy;
  const double unit = 1 / static_cast<double>(instance.scale);  // boxes are not scaled, so rays are
  const InstanceQuery<Sought> query{sought,
                                    {in_double(instance.origin) * unit, in_double(direction) * unit, margin * unit}};
  const auto test_leaf = [&](std::int32_t reference) {
    const auto [first, count] = hierarchy.leaf(reference);
    tests.surface_tests[index_of_kind<TriangleSurface>] += count;
    for (std::uint32_t place = first; place < first + count; ++place) {
      const Scalar t = instance.placed(mesh.triangles[place]).intersect(*shear);
      if (t > Scalar(0)) sought.meet(place, t);
    }
  };
  traverse(hierarchy.nodes().data(), hierarchy.root(), query, test_leaf, tests);
}

/// Enters what a view ray meets of instances into its standing.
template <class Scalar, class Standing>
class InstanceHits {
 public:
  InstanceHits(const PreparedScene<Scalar>& scene, const Vector<Scalar>& direction, const Standing& standing)
      : scene_(scene), direction_(direction), standing_(standing) {}

  void test(const InstanceSurface<Scalar>& instance, Tests& tests) {
    instance_ = &instance;
    walk_instance(scene_, instance, direction_, instance.within.margin, *this, tests);
  }

  double limit() const { return standing_.highest(); }
  void meet(std::uint32_t place, Scalar t) {
    const Hit<Scalar> hit{t, kind_of<InstanceSurface>, instance_->first + place};
    standing_.enter(hit, Standing::by_relative_error ? relative_error(place, static_cast<double>(t))
                                                     : std::numeric_limits<double>::infinity());
  }
  const Standing& standing() const { return standing_; }

 private:
  /// Of a triangle too little is known before there is a ray: how far apart its errors lie, the next one says.
  double relative_error(std::uint32_t place, double t) const {
    const InstancedTriangle<Scalar> triangle(*instance_, scene_.meshes[instance_->mesh], place);
    const DistanceRange range = triangle.distance_range(direction_, t, scene_.rounding);
    return std::max(range.highest - t, t - range.lowest) / t * (1 + 0x1p-50);
  }

  const PreparedScene<Scalar>& scene_;
  Vector<Scalar> direction_;
  Standing standing_;
  const InstanceSurface<Scalar>* instance_ = nullptr;
};

/// `standing`, after a ray along `direction` has gone through the instances of a run. A function of its own, with its
/// own copy of what it changes: so that a walk that has no instances keeps its state in registers.
template <class Scalar, class Standing>
[[gnu::noinline]] Standing after_instances(const PreparedScene<Scalar>& scene, const Vector<Scalar>& direction,
                                           const SurfaceRun& run, Standing standing, Tests& tests) {
  InstanceHits<Scalar, Standing> hits(scene, direction, standing);
  const auto& instances = surfaces_of<InstanceSurface>(scene);
  for (std::uint32_t k = run.first; k < run.first + run.count; ++k) hits.test(instances[k], tests);
  return hits.standing();
}

}  // namespace pyrasim
