// SPDX-License-Identifier: Apache-2.0
#include "texture/textured_object.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "camera/observer_frame.h"
#include "texture/mesh_place.h"

namespace pyrasim {
namespace {

/// The corners of a pyramid in the order in which they follow each other.
constexpr std::array<std::size_t, 4> around{0, 1, 3, 2};

/// Corners that face each other are summed first, as elsewhere.
glm::dvec3 mean_of(const std::array<glm::dvec3, 4>& colors) {
  return ((colors[0] + colors[3]) + (colors[1] + colors[2])) * 0.25;
}

const TriangleMesh* mesh_of(const SceneSurface& surface) {
  if (const auto* instance = std::get_if<MeshInstance>(&surface)) return &instance->of->mesh;
  return std::get_if<Mesh>(&surface);
}

PreparedScene<double> prepared_alone(const Scene& scene, std::size_t object) {
  Scene alone;
  alone.camera = scene.camera;
  alone.objects = {scene.objects[object]};
  return prepare_scene(alone, {});
}

}  // namespace

TexturedObject::TexturedObject(const Scene& scene, std::size_t object)
    : texture_(*scene.objects[object].texture),
      mesh_(mesh_of(*texture_.written)),
      alone_(prepared_alone(scene, object)),
      boxes_(alone_, {}) {
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

std::optional<TexturedObject::Seen> TexturedObject::seen(const glm::dvec3& view_vector) const {
  Tests tests;
  const auto hit = rays_.nearest({glm::dvec3(0), view_vector}, tests);
  if (!hit) return std::nullopt;
  return Seen{view_vector, hit->t, hit->surface.order};
}

glm::dvec3 TexturedObject::written_direction(const glm::dvec3& v) const {
  return {dot(rows_[0], v), dot(rows_[1], v), dot(rows_[2], v)};
}

TexturedObject::Place TexturedObject::coordinates(const std::optional<Seen>& seen) const {
  if (!seen) return std::nullopt;
  if (mesh_ != nullptr) {
    const auto place = place_along(*mesh_, seen->triangle, offset_, written_direction(seen->view_vector));
    return place ? std::optional(SurfaceCoordinates{place->at.x, place->at.y}) : std::nullopt;
  }
  const glm::dvec3 written = written_direction(seen->view_vector * seen->t) + offset_;
  return std::visit(
      [&](const auto& surface) -> Place {
        if constexpr (requires { surface.coordinates_at(written); }) {
          return surface.coordinates_at(written);
        } else {
          return std::nullopt;
        }
      },
      *texture_.written);
}

glm::dvec3 TexturedObject::color_of(const Place& place) const {
  if (!place) return texture_.texture.mean();
  return texture_.texture.at(texture_.texture.cell(place->u, place->v));
}

glm::dvec3 TexturedObject::color_at(const glm::dvec3& view_vector, TextureWork& work) const {
  ++work.places;
  return color_of(coordinates(seen(view_vector)));
}

std::optional<Footprint> TexturedObject::footprint_on(const Seen& seen, const std::array<glm::dvec3, 4>& corners,
                                                      const std::array<std::optional<Seen>, 4>& hits) const {
  Footprint footprint;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t corner = around[k];
    const auto place = place_along(*mesh_, seen.triangle, offset_, written_direction(corners[corner]));
    const double t = hits[corner].value_or(seen).t;
    const bool near = place && place->t < 2 * t && t < 2 * place->t;
    if (!near) return std::nullopt;
    footprint[k] = texture_.texture.cell(place->at.x, place->at.y);
  }
  return footprint;
}

glm::dvec3 TexturedObject::color_over_mesh(const std::array<glm::dvec3, 4>& corners,
                                           const std::array<std::optional<Seen>, 4>& hits, TextureWork& work) const {
  std::map<std::uint32_t, std::optional<glm::dvec3>> means;  // by triangle
  std::array<glm::dvec3, 4> colors;
  for (std::size_t k = 0; k < 4; ++k) {
    if (!hits[k]) {
      colors[k] = texture_.texture.mean();
      continue;
    }
    const auto [mean, is_new] = means.emplace(hits[k]->triangle, std::nullopt);
    if (is_new) {
      work.places += corners.size();
      const auto footprint = footprint_on(*hits[k], corners, hits);
      if (footprint) mean->second = texture_.texture.mean(*footprint, work);
    }
    colors[k] = mean->second ? *mean->second : color_of(coordinates(hits[k]));
  }
  return mean_of(colors);
}

glm::dvec3 TexturedObject::color_over(const std::array<glm::dvec3, 4>& corners, TextureFilter filter,
                                      TextureWork& work) const {
  std::array<std::optional<Seen>, 4> hits;
  std::transform(corners.begin(), corners.end(), hits.begin(), [&](const glm::dvec3& v) { return seen(v); });
  if (filter == TextureFilter::integral && mesh_ != nullptr) return color_over_mesh(corners, hits, work);
  work.places += corners.size();
  std::array<Place, 4> places;
  std::transform(hits.begin(), hits.end(), places.begin(), [&](const auto& hit) { return coordinates(hit); });
  const bool whole = std::all_of(places.begin(), places.end(),
                                 [&](const auto& place) { return place && place->chart == places[0]->chart; });
  if (filter == TextureFilter::point || !whole) {
    return mean_of({color_of(places[0]), color_of(places[1]), color_of(places[2]), color_of(places[3])});
  }
  Footprint footprint;
  for (std::size_t k = 0; k < 4; ++k) {
    auto [u, v, chart, u_turns, v_turns] = *places[around[k]];
    if (u_turns) u += std::round(places[0]->u - u);
    if (v_turns) v += std::round(places[0]->v - v);
    footprint[k] = texture_.texture.cell(u, v);
  }
  return texture_.texture.mean(footprint, work);
}

}  // namespace pyrasim
