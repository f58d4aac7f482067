// SPDX-License-Identifier: Apache-2.0
// Surfaces as the datapath holds them: in observer's coordinates, so that every view ray starts at the origin, with
// all that does not depend on the ray worked out when the scene is loaded.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>

#include "numeric/scalar.h"

namespace pyrasim {

enum class SurfaceKind : std::uint8_t { sphere, plane, triangle };
inline constexpr std::size_t surface_kinds = 3;
inline constexpr std::array<std::string_view, surface_kinds> surface_kind_names{"sphere", "plane", "triangle"};

/// The work that one ray or one frame took: what the machine's intersection units pay cycles for.
struct Work {
  std::uint64_t box_tests = 0;                               ///< bounding boxes tested
  std::array<std::uint64_t, surface_kinds> surface_tests{};  ///< by SurfaceKind

  Work& operator+=(const Work& other) {
    box_tests += other.box_tests;
    for (std::size_t kind = 0; kind < surface_kinds; ++kind) surface_tests[kind] += other.surface_tests[kind];
    return *this;
  }
  friend bool operator==(const Work&, const Work&) = default;
};

/// Both count in the order of the scene file, objects and surfaces; they settle equal distances (decision D7).
struct SurfaceIdentity {
  std::uint32_t object;
  std::uint32_t order;
};

template <class Scalar>
struct SphereSurface {
  Vector<Scalar> center;
  Scalar radius_squared;
  Scalar power;   ///< |center|^2 - radius^2, the origin's power: positive outside; rounded once
  Scalar radius;  ///< for the normal
  SurfaceIdentity identity;
};

/// Shading of a flat surface takes one of two values, by the side that the ray meets.
template <class Scalar>
struct FlatShading {
  Vector<Scalar> normal;  ///< of any length
  Scalar front;           ///< where the ray runs against the normal
  Scalar back;
};

/// The points p with normal . p = offset; the normal is that of `shading`.
template <class Scalar>
struct PlaneSurface {
  Scalar offset;
  SurfaceIdentity identity;
  FlatShading<Scalar> shading;
  double relative_error = std::numeric_limits<double>::infinity();  ///< see relative_error.h
  double squared_length = 0;  ///< along a ray, up to which the relative error holds
};

template <class Scalar>
struct TriangleSurface {
  std::array<std::array<Scalar, 3>, 3> vertices;
  SurfaceIdentity identity;
};

}  // namespace pyrasim
