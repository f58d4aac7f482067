// SPDX-License-Identifier: Apache-2.0
// All surfaces. One more takes its own file, and its two names here.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "surface/box.h"
#include "surface/cone.h"
#include "surface/cylinder.h"
#include "surface/disc.h"
#include "surface/ellipsoid.h"
#include "surface/framed_quadric.h"
#include "surface/instance.h"
#include "surface/mesh.h"
#include "surface/parallelepiped.h"
#include "surface/plane.h"
#include "surface/polygon.h"
#include "surface/quadric.h"
#include "surface/shared.h"
#include "surface/sphere.h"
#include "surface/torus.h"
#include "surface/triangle.h"

namespace pyrasim {

/// What an object of a scene file may be.
using WrittenSurface =
    std::variant<Sphere, Plane, Triangle, Mesh, Disc, Box, Ellipsoid, Cylinder, Cone, Quadric, Polygon, Torus>;

namespace surface_list {

template <class Written, class... More>
struct Extended;
template <class... Surface, class... More>
struct Extended<std::variant<Surface...>, More...> {
  using Type = std::variant<Surface..., More...>;
};

}  // namespace surface_list

/// And what transforms may make of it; what is large stands apart, so that the others need no room for it.
using SceneSurface =
    surface_list::Extended<WrittenSurface, Shared<Parallelepiped>, Shared<FramedQuadric>, MeshInstance>::Type;

/// What a ray may meet; the order is that of counts, of costs, and within a leaf of the hierarchy.
template <class Scalar>
using SurfaceTypes =
    std::tuple<SphereSurface<Scalar>, PlaneSurface<Scalar>, TriangleSurface<Scalar>, DiscSurface<Scalar>,
               BoxSurface<Scalar>, EllipsoidSurface<Scalar>, CylinderSurface<Scalar>, ConeSurface<Scalar>,
               QuadricSurface<Scalar>, TorusSurface<Scalar>, InstanceSurface<Scalar>>;

inline constexpr std::size_t surface_kinds = std::tuple_size_v<SurfaceTypes<double>>;

/// The place in SurfaceTypes.
enum class SurfaceKind : std::uint8_t {};

/// Calls f(std::integral_constant<std::size_t, K>) for each kind, in order.
template <class F>
constexpr void for_each_kind(const F& f) {
  [&]<std::size_t... K>(std::index_sequence<K...>) { (f(std::integral_constant<std::size_t, K>()), ...); }
  (std::make_index_sequence<surface_kinds>());
}

/// f(std::integral_constant<std::size_t, K>) for `kind` alone.
template <std::size_t first = 0, class F>
[[gnu::always_inline]] constexpr auto with_kind(SurfaceKind kind, const F& f) {
  if constexpr (first + 1 < surface_kinds) {
    if (static_cast<std::size_t>(kind) != first) return with_kind<first + 1>(kind, f);
  }
  return f(std::integral_constant<std::size_t, first>());
}

/// The surfaces of one kind, and the shading of each: rays that miss do not read it.
template <class Surface>
struct SurfacesOfKind {
  std::vector<Surface> surfaces;
  std::vector<typename Surface::Shading> shading;
};

namespace surface_list {

template <class Types>
struct Of;
template <class... Surface>
struct Of<std::tuple<Surface...>> {
  using Store = std::tuple<SurfacesOfKind<Surface>...>;
  static constexpr std::array<SurfaceTraits, sizeof...(Surface)> traits{Surface::traits...};
  template <class Sought>
  static constexpr std::size_t index_of() {
    std::size_t index = 0;
    const bool found = ((std::is_same_v<Surface, Sought> || (++index, false)) || ...);
    return found ? index : throw "it is not in the list";
  }
};

}  // namespace surface_list

/// By SurfaceKind.
inline constexpr std::array<SurfaceTraits, surface_kinds> surface_traits =
    surface_list::Of<SurfaceTypes<double>>::traits;

template <template <class> class Surface>
inline constexpr std::size_t index_of_kind = surface_list::Of<SurfaceTypes<double>>::index_of<Surface<double>>();
template <std::size_t index>
inline constexpr SurfaceKind kind_at{index};
template <template <class> class Surface>
inline constexpr SurfaceKind kind_of = kind_at<index_of_kind<Surface>>;

/// All surfaces of a scene, by SurfaceKind.
template <class Scalar>
using SurfaceStore = typename surface_list::Of<SurfaceTypes<Scalar>>::Store;

}  // namespace pyrasim
