// SPDX-License-Identifier: Apache-2.0
// What a ray meets of an instance: a triangle of its mesh, with all that surfaces of the list have for those who ask
// about a hit.
#pragma once

#include <algorithm>
#include <cstdint>

#include "intersect/prepared_scene.h"
#include "numeric/arithmetic_events.h"
#include "surface/curved_shading.h"

namespace pyrasim {

/// Lengths in the instance's coordinates; numbers are those that the datapath holds.
struct InstancedHit {
  TriangleSurface<double> placed;
  Vector<double> direction;       ///< of the ray
  Vector<double> terms;           ///< sizes of what its components are sums of
  double vertex = 0, origin = 0;  ///< the largest coordinates that the triangle's are differences of
  InstanceBounds within;
};

/// Where the exact hit lies, on the ray along `direction` in the observer's coordinates.
DistanceRange distance_range(const InstancedHit& hit, const Vector<double>& direction, double t,
                             const RoundingUnits& rounding);

template <class Scalar>
class InstancedTriangle {
 public:
  using Terms = const ViewRay<Scalar>&;

  /// The triangle that stands at `place` in the mesh, which must outlive it.
  InstancedTriangle(const InstanceSurface<Scalar>& instance, const SharedMesh<Scalar>& mesh, std::uint32_t place)
      : instance_(instance),
        triangle_(mesh.triangles[place]),
        normal_(mesh.normals[place]),
        smooth_(mesh.smooth.empty() ? nullptr : &mesh.smooth[place]),
        identity{instance.identity.object, instance.identity.order + triangle_.identity.order} {}

  Scalar intersect(const ViewRay<Scalar>& ray) const {
    const auto shear = instance_.shear(instance_.direction(ray.direction));
    return shear ? instance_.placed(triangle_).intersect(*shear) : Scalar(0);
  }
  InstancedTriangle seen_from(const Vector<Scalar>& place) const {
    InstancedTriangle moved = *this;
    moved.instance_ = instance_.seen_from(place);
    return moved;
  }
  Vector<Scalar> outward() const { return instance_.normal(normal_); }
  bool smooth() const { return smooth_ != nullptr; }
  /// What outward() is to be taken for where light falls on it, where a ray along `direction` meets it.
  Vector<Scalar> shading_normal(const Vector<Scalar>& direction) const {
    const auto shear = instance_.shear(instance_.direction(direction));
    if (smooth_ == nullptr || !shear) return outward();
    return on_side_of(outward(), instance_.normal(mean_normal(*smooth_, instance_.placed(triangle_).weights(*shear))));
  }
  Scalar shade(const Lighting<Scalar>& lighting, const Vector<Scalar>& direction) const {
    if (!lighting.lit) return Scalar(1);
    return lambert_of_curved(lighting, shading_normal(direction), direction, outward());
  }

  /// Worked out beside the datapath, from numbers as it has them.
  DistanceRange distance_range(const Vector<Scalar>& direction, double t, const RoundingUnits& rounding) const;

 private:
  InstanceSurface<Scalar> instance_;
  TriangleSurface<Scalar> triangle_;
  Vector<Scalar> normal_;
  const VertexNormals<Scalar>* smooth_;  ///< the mesh's, where it is smooth

 public:
  SurfaceIdentity identity;
};

template <class Scalar>
DistanceRange InstancedTriangle<Scalar>::distance_range(const Vector<Scalar>& direction, double t,
                                                        const RoundingUnits& rounding) const {
  const ArithmeticEvents counted = arithmetic_events;
  const Vector<double> along = in_double(direction);
  const TriangleSurface<Scalar> placed = instance_.placed(triangle_);
  InstancedHit hit{.placed = in_double(placed),
                   .direction = in_double(instance_.direction(direction)),
                   .terms = {},
                   .vertex = reach(in_double(triangle_)) * static_cast<double>(instance_.scale),
                   .origin = largest(in_double(instance_.origin)),
                   .within = instance_.within};
  for (int k = 0; k < 3; ++k) {
    hit.terms[k] = dot(magnitudes(in_double(instance_.rows[static_cast<std::size_t>(k)])), magnitudes(along));
  }
  arithmetic_events = counted;
  return pyrasim::distance_range(hit, along, t, rounding);
}

/// What Hit::index says of an instance: triangles of instances are numbered through, instance by instance, as if each
/// had a copy of them. This is the place of the instance.
template <class Scalar>
std::uint32_t instance_of_hit(const PreparedScene<Scalar>& scene, std::uint32_t index) {
  const auto& instances = surfaces_of<InstanceSurface>(scene);
  const auto after =
      std::upper_bound(instances.begin(), instances.end(), index,
                       [](std::uint32_t sought, const InstanceSurface<Scalar>& of) { return sought < of.first; });
  return static_cast<std::uint32_t>(after - instances.begin() - 1);
}

template <class Scalar>
InstancedTriangle<Scalar> triangle_of_hit(const PreparedScene<Scalar>& scene, std::uint32_t index) {
  const auto& instance = surfaces_of<InstanceSurface>(scene)[instance_of_hit(scene, index)];
  return {instance, scene.meshes[instance.mesh], index - instance.first};
}

}  // namespace pyrasim
