// SPDX-License-Identifier: Apache-2.0
#include "texture/textured_object.h"

#include <algorithm>
#include <cmath>

#include "camera/observer_frame.h"

namespace pyrasim {
namespace {

PreparedScene<double> prepared_alone(const Scene& scene, std::size_t object) {
  Scene alone;
  alone.camera = scene.camera;
  alone.objects = {scene.objects[object]};
  return prepare_scene(alone, {});
}

}  // namespace

TexturedObject::TexturedObject(const Scene& scene, std::size_t object)
    : texture_(*scene.objects[object].texture), alone_(prepared_alone(scene, object)), boxes_(alone_, {}) {
  const ObserverFrame frame(scene.camera);
  const std::array axes{exactly(frame.forward()), exactly(frame.up()), exactly(frame.right())};
  const QuadrupleVector place = difference(exactly(frame.position()), texture_.map.offset());
  for (std::size_t i = 0; i < 3; ++i) {
    const QuadrupleVector& row = texture_.map.inverse()[i];
    const auto component = [&](std::size_t j) {
      return std::ldexp(static_cast<double>(dot(row, axes[j])), -alone_.exponent);
    };
    rows_[i] = {component(0), component(1), component(2)};
    offset_[static_cast<int>(i)] = static_cast<double>(dot(row, place));
  }
}

std::optional<SurfaceCoordinates> TexturedObject::coordinates(const glm::dvec3& view_vector) const {
  Tests tests;
  const auto hit = rays_.nearest({glm::dvec3(0), view_vector}, tests);
  if (!hit) return std::nullopt;
  const glm::dvec3 seen = view_vector * hit->t;
  const glm::dvec3 written(dot(rows_[0], seen) + offset_.x, dot(rows_[1], seen) + offset_.y,
                           dot(rows_[2], seen) + offset_.z);
  return std::visit(
      [&](const auto& surface) -> std::optional<SurfaceCoordinates> {
        if constexpr (requires { surface.coordinates_at(written); }) {
          return surface.coordinates_at(written);
        } else {
          return std::nullopt;
        }
      },
      *texture_.written);
}

glm::dvec3 TexturedObject::color_of(const std::optional<SurfaceCoordinates>& place) const {
  if (!place) return texture_.texture.mean();
  return texture_.texture.at(texture_.texture.cell(place->u, place->v));
}

glm::dvec3 TexturedObject::color_at(const glm::dvec3& view_vector, TextureWork& work) const {
  ++work.places;
  return color_of(coordinates(view_vector));
}

glm::dvec3 TexturedObject::color_over(const std::array<glm::dvec3, 4>& corners, TextureFilter filter,
                                      TextureWork& work) const {
  work.places += corners.size();
  std::array<std::optional<SurfaceCoordinates>, 4> places;
  std::transform(corners.begin(), corners.end(), places.begin(), [&](const glm::dvec3& v) { return coordinates(v); });
  const bool whole = std::all_of(places.begin(), places.end(),
                                 [&](const auto& place) { return place && place->chart == places[0]->chart; });
  if (filter == TextureFilter::point || !whole) {
    return ((color_of(places[0]) + color_of(places[3])) + (color_of(places[1]) + color_of(places[2]))) * 0.25;
  }
  Footprint footprint;
  constexpr std::array<std::size_t, 4> around{0, 1, 3, 2};
  for (std::size_t k = 0; k < 4; ++k) {
    auto [u, v, chart, u_turns, v_turns] = *places[around[k]];
    if (u_turns) u += std::round(places[0]->u - u);
    if (v_turns) v += std::round(places[0]->v - v);
    footprint[k] = texture_.texture.cell(u, v);
  }
  return texture_.texture.mean(footprint, work);
}

}  // namespace pyrasim
