// SPDX-License-Identifier: Apache-2.0
#include "surface/quadric.h"

#include <algorithm>
#include <cmath>

#include "numeric/vectors.h"
#include "surface/clip_box.h"
#include "surface/framed_quadric.h"
#include "surface/pov_writer.h"
#include "surface/principal_axes.h"

namespace pyrasim {
namespace {

constexpr double largest_coefficient = 1e60;  // as of squares of lengths
constexpr double least_square = 1e-60;

GeneralQuadric general(const Quadric::Coefficients& q) {
  const auto half = [](double x) { return static_cast<Quadruple>(x) / 2; };
  return {{{{q.xx, half(q.xy), half(q.xz)}, {half(q.xy), q.yy, half(q.yz)}, {half(q.xz), half(q.yz), q.zz}}},
          {half(q.x), half(q.y), half(q.z)},
          q.constant};
}

Quadric::Coefficients read_coefficients(const JsonReader& reader) {
  using Coefficients = Quadric::Coefficients;
  constexpr std::array<std::pair<std::string_view, double Coefficients::*>, 10> members{
      {{"xx", &Coefficients::xx},
       {"yy", &Coefficients::yy},
       {"zz", &Coefficients::zz},
       {"xy", &Coefficients::xy},
       {"xz", &Coefficients::xz},
       {"yz", &Coefficients::yz},
       {"x", &Coefficients::x},
       {"y", &Coefficients::y},
       {"z", &Coefficients::z},
       {"constant", &Coefficients::constant}}};
  std::vector<std::string_view> keys(members.size());
  std::transform(members.begin(), members.end(), keys.begin(), [](const auto& member) { return member.first; });
  reader.allow_keys(keys);
  Coefficients q;
  for (const auto& [key, to] : members) {
    q.*to = reader.optional_number(key, {-largest_coefficient, largest_coefficient}).value_or(0);
  }
  const double largest_square = std::max(largest({q.xx, q.yy, q.zz}), largest({q.xy, q.xz, q.yz}));
  if (largest_square < least_square) {
    reader.fail("no square is left", "one of xx, yy, zz, xy, xz and yz has to be at least 1e-60 in magnitude");
  }
  return q;
}

std::vector<ExactHalfSpace> exact(const std::vector<HalfSpace<double>>& clip) {
  std::vector<ExactHalfSpace> result;
  result.reserve(clip.size());
  for (const auto& [normal, offset] : clip) result.push_back({exactly(normal), offset});
  return result;
}

void read_bound(const JsonReader& reader, double outward, std::vector<HalfSpace<double>>& clip) {
  const glm::dvec3 bound = reader.vec3(coordinates);
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 normal(0);
    normal[axis] = outward;
    clip.push_back({normal, outward * bound[axis]});
  }
}

std::vector<HalfSpace<double>> read_clip(const JsonReader& reader) {
  reader.allow_keys({"min", "max", "planes"});
  std::vector<HalfSpace<double>> clip;
  if (const auto min = reader.find("min")) read_bound(*min, -1, clip);
  if (const auto max = reader.find("max")) read_bound(*max, 1, clip);
  if (const auto planes = reader.find("planes")) {
    for (const JsonReader& plane : planes->elements(0, max_clips - clip.size())) {
      plane.allow_keys({"normal", "offset"});
      clip.push_back({read_direction(plane.member("normal")), plane.member("offset").number(coordinates)});
    }
  }
  const auto left = clip_box(exact(clip), {});
  if (!left) reader.fail("nothing is left", "the half-spaces have to have a point in common");
  const glm::dvec3 sides = left->upper - left->lower;
  if (!(std::min({sides.x, sides.y, sides.z}) > 0)) {
    reader.fail("what is left is flat", "half-spaces that have a volume in common are allowed");
  }
  return clip;
}

double sum_of_squares(const Quadric::Coefficients& q) {
  return sum(magnitudes({q.xx, q.yy, q.zz})) + sum(magnitudes({q.xy, q.xz, q.yz}));
}

/// The box about an ellipsoid.
std::optional<BoundingBox> ellipsoid_box(const QuadricFrame& frame) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (frame.signs[k] != frame.signs[0] || frame.signs[k] == 0) return std::nullopt;
  }
  if (!(frame.constant * frame.signs[0] <= 0)) return std::nullopt;
  const glm::dvec3 center = rounded(frame.center);
  glm::dvec3 half(0);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Quadruple squared = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Quadruple part = frame.axes[k][axis] / frame.scales[k];
      squared -= frame.signs[0] * frame.constant * part * part;
    }
    half[static_cast<int>(axis)] = static_cast<double>(square_root(squared));
  }
  return BoundingBox{center - half, center + half};
}

FramedQuadric framed(const Quadric& quadric) {
  const auto& q = quadric.coefficients;
  const auto [frame, divisor] = principal_axes(general(q));
  FramedQuadric result{.frame = frame, .clip = exact(quadric.clip), .capped = quadric.capped};
  result.convex =
      (quadric.capped || quadric.clip.empty()) && std::min({frame.signs[0], frame.signs[1], frame.signs[2]}) >= 0;
  result.written = {sum_of_squares(q), sum(magnitudes({q.x, q.y, q.z})), std::abs(q.constant),
                    static_cast<double>(divisor)};
  result.size = largest(rounded(frame.center));
  const bool outside = quadric.capped && frame.signs[0] < 0;
  const auto box = clip_box(result.clip, outside ? std::nullopt : ellipsoid_box(frame));
  if (!box || !(box->reach() < beyond_all)) return result;
  result.size = std::max(result.size, box->reach());
  const glm::dvec3 half = (box->upper - box->lower) / 2.0;
  result.enclosure = {exactly(box->center()), {{{half.x, 0, 0}, {0, half.y, 0}, {0, 0, half.z}}}};
  return result;
}

}  // namespace

Quadric Quadric::read(const JsonReader& reader, const SceneReading&) {
  Quadric quadric{read_coefficients(reader.member("coefficients"))};
  if (const auto clip = reader.find("clip")) quadric.clip = read_clip(*clip);
  quadric.capped = reader.optional_boolean("capped").value_or(false);
  return quadric;
}

Prepared<QuadricSurface> Quadric::prepared(const Preparation& preparation) const {
  return framed(*this).prepared(preparation);
}

FramedQuadric Quadric::transformed(const AffineMap& map) const { return framed(*this).transformed(map); }

/// A skin that is clipped, or what a solid has in common with half-spaces.
void Quadric::write_pov(PovWriter& pov) const {
  const auto& q = coefficients;
  const bool clipped = !clip.empty();
  pov.begin(capped && clipped ? "intersection" : "object");
  // POV-Ray bounds the inside of a quadric as if that were round; the outside of its negative it does not.
  const bool hollow = capped && std::min({q.xx, q.yy, q.zz}) < 0;
  const double sign = hollow ? -1 : 1;
  pov.begin("quadric");
  pov.add(sign * glm::dvec3(q.xx, q.yy, q.zz), sign * glm::dvec3(q.xy, q.xz, q.yz), sign * glm::dvec3(q.x, q.y, q.z),
          sign * q.constant);
  if (hollow) pov.add("inverse");
  pov.end();
  if (!capped && clipped) pov.begin("clipped_by");
  for (const auto& [normal, offset] : clip) pov.plane(normal, offset);
  if (!capped && clipped) pov.end();
  pov.end();
}

/// About the y axis; closed ends too.
SurfaceCoordinates Quadric::coordinates_at(const glm::dvec3& point) const {
  return about_axis({0, 1, 0}, glm::dvec3(0), point);
}

}  // namespace pyrasim
