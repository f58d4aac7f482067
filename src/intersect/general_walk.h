// SPDX-License-Identifier: Apache-2.0
// What a ray from anywhere meets: the nearest surface, or whether any. For shadows, mirrors and glass.
#pragma once

#include <optional>
#include <type_traits>

#include "intersect/instance_walk.h"
#include "intersect/ray_boxes.h"
#include "intersect/rounded_scene.h"
#include "intersect/traversal.h"
#include "surface/view_ray.h"

namespace pyrasim {

/// A surface that a ray met, the first in the scene of those at the same t.
struct GeneralHit {
  double t;
  SurfaceIdentity surface;
  friend bool operator==(const GeneralHit& a, const GeneralHit& b) {
    return a.t == b.t && a.surface.order == b.surface.order;
  }
};

/// A scene for rays from anywhere, in one number format: each surface is moved so that the ray starts at the origin,
/// and met by the arithmetic of view rays. Holds references: scene and boxes must outlive it.
template <class Scalar>
class GeneralScene {
 public:
  GeneralScene(const PreparedScene<Scalar>& scene, const RayBoxes& boxes) : scene_(scene), boxes_(boxes) {}

  /// The hit of the least t within the ray's limit.
  std::optional<GeneralHit> nearest(const GeneralRay& ray, Tests& work) const {
    Nearest sought{{ray, boxes_.query(ray)}};
    walk(sought, work);
    return sought.hit;
  }

  /// Whether there is a hit within the ray's limit that counts(kind, index, t) says counts. The walk ends at the first.
  template <class Counts>
  bool any(const GeneralRay& ray, const Counts& counts, Tests& work) const {
    Any<Counts> sought{{ray, boxes_.query(ray)}, counts};
    walk(sought, work);
    return sought.met_one;
  }
  bool any(const GeneralRay& ray, Tests& work) const {
    return any(
        ray, [](auto, std::uint32_t, double) { return true; }, work);
  }

 private:
  /// The part of a query that is the ray's.
  struct Boxes {
    GeneralRay ray;
    BoxHierarchy::Query query;

    unsigned met(const BoxHierarchy::Node& node) const { return BoxHierarchy::met(node, query, ray.limit); }
  };
  /// The ray's limit is that of the nearest hit so far.
  struct Nearest : Boxes {
    std::optional<GeneralHit> hit{};

    bool over() const { return false; }
    bool behind(const BoxHierarchy::Node&, std::size_t) const { return false; }
    void enter(auto, std::uint32_t, double t, const SurfaceIdentity& surface) {
      if (t > this->ray.limit || (hit && t == hit->t && hit->surface.order < surface.order)) return;
      hit = GeneralHit{t, surface};
      this->ray.limit = t;
    }
  };
  template <class Counts>
  struct Any : Boxes {
    const Counts& counts;
    bool met_one = false;

    bool over() const { return met_one; }
    bool behind(const BoxHierarchy::Node&, std::size_t) const { return met_one; }
    void enter(auto kind, std::uint32_t index, double t, const SurfaceIdentity&) {
      met_one = met_one || (t <= this->ray.limit && counts(kind, index, t));
    }
  };

  template <class Sought>
  void walk(Sought& sought, Tests& work) const {
    const FormatScope<Scalar> scope(scene_.numbers);
    const Vector<Scalar> origin = to_scalar<Scalar>(sought.ray.origin);
    const ViewRay<Scalar> moved(to_scalar<Scalar>(sought.ray.direction));
    if (scene_.apart) test_apart(*scene_.apart, origin, moved, sought, work);
    const auto test_leaf = [&](std::int32_t leaf) {
      for (const auto [kind, index] : boxes_.leaf(leaf)) {
        if (sought.over()) return;
        with_kind(kind, [&, k = index](auto of) { test<of>(k, origin, moved, sought, work); });
      }
    };
    const BoxHierarchy& hierarchy = boxes_.hierarchy();
    traverse(hierarchy.nodes().data(), hierarchy.root(), sought, test_leaf, work);
  }

  template <class Sought>
  void test_apart(std::int32_t leaf, const Vector<Scalar>& origin, const ViewRay<Scalar>& moved, Sought& sought,
                  Tests& work) const {
    const SurfaceRun* run = first_run(scene_.runs, leaf);
    do {
      with_kind(run->kind, [&](auto kind) {
        for (std::uint32_t k = run->first; k < run->first + run->count && !sought.over(); ++k) {
          test<kind>(k, origin, moved, sought, work);
        }
      });
    } while (run++->more && !sought.over());
  }

  /// What walk_instance() finds, as `sought` asks for it.
  template <class Sought>
  struct MetInInstance {
    Sought& sought;
    SurfaceIdentity identity;
    const TriangleSurface<Scalar>* triangles;
    std::uint32_t index;  ///< the instance's

    double limit() const { return sought.over() ? -1 : sought.ray.limit; }
    void meet(std::uint32_t place, Scalar t) {
      sought.enter(std::integral_constant<std::size_t, index_of_kind<InstanceSurface>>(), index, static_cast<double>(t),
                   {identity.object, identity.order + triangles[place].identity.order});
    }
  };

  template <std::size_t kind, class Sought>
  void test(std::uint32_t index, const Vector<Scalar>& origin, const ViewRay<Scalar>& moved, Sought& sought,
            Tests& work) const {
    using Surface = std::tuple_element_t<kind, SurfaceTypes<Scalar>>;
    const typename Surface::Terms terms(moved);
    const Surface& surface = std::get<kind>(scene_.kinds).surfaces[index];
    if constexpr (kind == index_of_kind<InstanceSurface>) {
      const double margin = 2 * boxes_.margin().of(surface.within.reach + largest(sought.ray.origin));
      MetInInstance<Sought> met{sought, surface.identity, scene_.meshes[surface.mesh].triangles.data(), index};
      walk_instance(scene_, surface.seen_from(origin), moved.direction, margin, met, work);
    } else {
      const Scalar t = surface.seen_from(origin).intersect(terms);
      ++work.surface_tests[kind];
      if (t > Scalar(0))
        sought.enter(std::integral_constant<std::size_t, kind>(), index, static_cast<double>(t), surface.identity);
    }
  }

  const PreparedScene<Scalar>& scene_;
  const RayBoxes& boxes_;
};

}  // namespace pyrasim
