// SPDX-License-Identifier: Apache-2.0
// Scenes as users write them: decimal numbers, which no double holds, and a camera that looks anywhere.
#pragma once

#include "../extremes/formats.h"
#include "../real.h"

namespace pyrasim {

/// Numbers in these scenes have three decimals.
constexpr double decimals = 1000;

/// The double that a decimal number is read as.
inline double read_as(double whole) { return whole / decimals; }
inline double decimal(double x) { return read_as(std::round(x * decimals)); }
inline glm::dvec3 decimal(const glm::dvec3& v) { return {decimal(v.x), decimal(v.y), decimal(v.z)}; }

/// The decimal number that was written, exactly.
inline Real written(double x) { return Real(std::round(x * decimals)) / Real(decimals); }
inline RealVector written(const glm::dvec3& v) { return {written(v.x), written(v.y), written(v.z)}; }

/// A camera anywhere within `reach` of the world's origin.
inline Camera decimal_camera(Random& random, double reach) {
  Camera camera;
  camera.position = decimal(random.vector(-1, 1) * reach);
  camera.look_at = camera.position + decimal(random.unit_vector() * 3.0);
  camera.up = decimal(random.unit_vector());
  camera.screen = {96, 96, 1, 2.0 / 96, 2.0 / 96};
  return camera;
}

}  // namespace pyrasim
