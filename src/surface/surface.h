// SPDX-License-Identifier: Apache-2.0
// What every surface brings; list.h names them all.
//
// A surface is two types in one file: what a scene file says of it (Sphere), and the surface as the datapath holds it
// (SphereSurface<Scalar>), in observer's coordinates, so that every view ray starts at the origin, with all that does
// not depend on the ray worked out when the scene is prepared. docs/extending.md lists their members.
#pragma once

#include <cstdint>
#include <string_view>

namespace pyrasim {

class PovWriter;

/// Whether surfaces of a kind have bounds, by which a hierarchy can hold them.
enum class Extent : std::uint8_t { bounded, unbounded, either };

struct SurfaceTraits {
  std::string_view name;  ///< in statistics, and of its cost in machine files
  unsigned default_cost;  ///< of one test, cycles of an intersection unit
  Extent extent;
};

/// Both count in the order of the scene file, objects and surfaces; they settle equal distances (decision D7).
struct SurfaceIdentity {
  std::uint32_t object = 0;
  std::uint32_t order = 0;
};

/// A surface that was prepared, in double, with what its shading takes.
template <template <class> class Surface>
struct Prepared {
  Surface<double> surface;
  typename Surface<double>::Shading shading;
};

/// Of a surface whose shading takes no more than the surface itself.
template <class Scalar>
struct NoShading {
  template <class Other, class Number>
  NoShading<Other> mapped(const Number&) const {
    return {};
  }
};

}  // namespace pyrasim
