// SPDX-License-Identifier: Apache-2.0
#include "intersect/ray_boxes.h"

#include "numeric/vectors.h"

namespace pyrasim {
namespace {

constexpr double longest_squared = 3;

}  // namespace

RayBoxes::RayBoxes(const PreparedScene<double>& scene, const NumberFormat& format)
    : margin_(format, longest_squared, scene.rounding) {
  std::vector<BoundingBox> boxes;
  std::vector<Item> bounded;
  for_each_kind([&](auto kind) {
    const auto& surfaces = std::get<kind>(scene.kinds).surfaces;
    for (std::uint32_t k = 0; k < surfaces.size(); ++k) {
      const auto box = bounds(surfaces[k]);
      if (!box) continue;  // it stands apart, and no box is asked for it
      const double margin = 2 * margin_.of(surfaces[k]);
      if constexpr (requires { has_generators(surfaces[k]); }) generators_ = generators_ || has_generators(surfaces[k]);
      boxes.push_back({box->lower - margin, box->upper + margin});
      bounded.push_back({kind_at<kind>, k});
    }
  });
  hierarchy_ = BoxHierarchy(boxes);
  items_.reserve(bounded.size());
  for (const std::uint32_t item : hierarchy_.items()) items_.push_back(bounded[item]);
}

BoxHierarchy::Query RayBoxes::query(const GeneralRay& ray) const {
  const double away = largest(ray.origin);
  const double margin = 2 * margin_.of(away) + (generators_ ? margin_.along_generators(away) : 0);
  return {ray.origin, ray.direction, margin};
}

}  // namespace pyrasim
