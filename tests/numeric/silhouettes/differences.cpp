// SPDX-License-Identifier: Apache-2.0
#include "differences.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <vector>

#include "explanation.h"
#include "frame_pyramids.h"
#include "numeric/round_to_format.h"

namespace pyrasim::silhouettes {
namespace {

/// Compares what an intersector of one format sees with the oracle's.
class Comparison {
 public:
  Comparison(const NumberFormat& format, const ExactScene& scene, Slopes slopes)
      : format_(format), scene_(scene), rounding_(rounding_of(format, ExactScene::exponent_of(format), slopes)) {}

  void add(const Ray& ray, std::uint32_t object, std::uint32_t exact) {
    ++differences_.all;
    if (object == exact) return;
    ++differences_.different;
    if (const auto error = part_of_bound(scene_, ray, contacts_of(ray), rounding_, object)) {
      differences_.largest_error = std::max(differences_.largest_error, *error);
    } else if (differences_.unexplained++ == 0) {
      differences_.first_unexplained =
          fmt::format("ray (1, {}, {}): object {} instead of {}", ray.y<double>(), ray.z<double>(),
                      static_cast<std::int32_t>(object), static_cast<std::int32_t>(exact));
    }
  }

  const Differences& result() const { return differences_; }

 private:
  /// Margins in double are right to a thousandth of the bounds of all formats but double itself.
  std::vector<Contact> contacts_of(const Ray& ray) const {
    return format_ == NumberFormat() ? contacts<Real>(scene_, ray, rounding_)
                                     : contacts<double>(scene_, ray, rounding_);
  }

  NumberFormat format_;
  const ExactScene& scene_;
  Rounding rounding_;
  Differences differences_;
};

using Neighbors = std::array<GridPoint, 2>;

/// Neighbouring corners of pixels that see different objects; evenly chosen where there are more than `most`.
std::vector<Neighbors> neighbors_across_outline(Oracle& oracle, std::size_t most) {
  std::vector<Neighbors> all;
  const auto offer = [&](GridPoint a, GridPoint b) {
    if (oracle.object(a) != oracle.object(b)) all.push_back({a, b});
  };
  const auto step = static_cast<std::uint32_t>(oracle.steps());
  for (std::uint32_t row = 0; row < static_cast<std::uint32_t>(oracle.screen().rows); ++row) {
    for (std::uint32_t column = 0; column < static_cast<std::uint32_t>(oracle.screen().columns); ++column) {
      const GridPoint corner{row * step, column * step};
      offer(corner, {corner.row, corner.column + step});
      offer(corner, {corner.row + step, corner.column});
    }
  }
  std::vector<Neighbors> chosen;
  for (std::size_t k = 0; k < all.size(); k += all.size() / most + 1) chosen.push_back(all[k]);
  return chosen;
}

/// View vectors `a` and `b` of the format see different objects. Moves them towards each other along `axis` until they
/// are neighbours that do.
void narrow_down(const Intersector& intersector, const RoundToFormat& round, int axis, glm::dvec3& a, glm::dvec3& b) {
  Work work;
  const std::uint32_t object = intersector.intersect(a, work).seen.object;
  for (;;) {
    glm::dvec3 middle = a;
    middle[axis] = round(middle[axis] + (b[axis] - a[axis]) / 2);
    if (middle[axis] == a[axis] || middle[axis] == b[axis]) return;
    (intersector.intersect(middle, work).seen.object == object ? a : b) = middle;
  }
}

/// Moves neighbours of the format to the doubles half-way between them, which are rounded to them.
void move_to_boundary(int axis, glm::dvec3& a, glm::dvec3& b) {
  const double boundary = a[axis] + (b[axis] - a[axis]) / 2;
  if (boundary == a[axis] || boundary == b[axis]) return;  // double itself
  a[axis] = std::nextafter(boundary, a[axis]);
  b[axis] = std::nextafter(boundary, b[axis]);
}

}  // namespace

FrameDifferences differences_in_frame(const Intersector& intersector, const NumberFormat& format, Oracle& oracle) {
  const ViewVectors view_vectors(oracle.screen(), oracle.steps(), format);
  Comparison comparison(format, oracle.scene(), Slopes::computed);
  FrameDifferences differences;
  std::unordered_map<std::uint64_t, Sample> traced;
  const auto sample = [&](GridPoint point) {
    const auto [entry, fresh] = traced.try_emplace(address(point));
    if (fresh) {
      Work work;
      entry->second = intersector.intersect(view_vectors(point), work);
      comparison.add(oracle.ray(point), entry->second.seen.object, oracle.object(point));
    }
    return entry->second;
  };
  const auto visit = [&](const std::array<GridPoint, 4>& corners, const CornerSamples& samples) {
    CornerSamples exact;
    for (std::size_t k = 0; k < 4; ++k) exact[k].seen.object = oracle.object(corners[k]);
    ++differences.pyramids;
    if (classify(samples) != classify(exact)) ++differences.different_pyramids;
  };
  FramePyramids(oracle.max_level(), sample, visit).visit_all(oracle.screen());
  differences.rays = comparison.result();
  return differences;
}

Differences differences_by_outline(const Intersector& intersector, const NumberFormat& format, Oracle& oracle) {
  constexpr std::size_t places = 60;
  const ViewVectors view_vectors(oracle.screen(), oracle.steps(), format);
  Comparison comparison(format, oracle.scene(), Slopes::rounded);
  Work work;
  for (const auto& [first, second] : neighbors_across_outline(oracle, places)) {
    glm::dvec3 a = view_vectors(first);
    glm::dvec3 b = view_vectors(second);
    if (intersector.intersect(a, work).seen.object == intersector.intersect(b, work).seen.object) continue;
    const int axis = first.row == second.row ? 2 : 1;
    narrow_down(intersector, RoundToFormat(format), axis, a, b);
    move_to_boundary(axis, a, b);
    for (const glm::dvec3& v : {a, b}) {
      const Ray ray(v.y, v.z);
      comparison.add(ray, intersector.intersect(v, work).seen.object, object_seen(oracle.scene(), ray));
    }
  }
  return comparison.result();
}

}  // namespace pyrasim::silhouettes
