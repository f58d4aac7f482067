// SPDX-License-Identifier: Apache-2.0
// Which of the hits of a ray leads, decision D7: by what is known of their errors before there is a ray, where that is
// enough, and else by what each hit's range says.
#pragma once

#include <limits>

#include "intersect/contest.h"
#include "intersect/instanced_triangle.h"
#include "intersect/prepared_scene.h"
#include "intersect/rounded_scene.h"
#include "raster/sample.h"

namespace pyrasim {

/// A surface that a ray met: where, and which.
template <class Scalar>
struct Hit {
  Scalar t{0};
  SurfaceKind kind{};
  std::uint32_t index = 0;  ///< among the surfaces of its kind; of instances instanced_triangle.h says more
};

/// Hits that lie clearly apart: the nearer leads, whatever they err by.
template <class Scalar>
class ClearStanding {
 public:
  static constexpr bool by_relative_error = true;

  /// Enters a hit whose t errs by `relative_error` of itself at most; whether it leads now.
  bool enter(const Hit<Scalar>& hit, double relative_error) {
    const auto t = static_cast<double>(hit.t);
    const double error = t * relative_error;
    if (t - error > highest_) return false;
    if (!(t + error < lowest_)) [[unlikely]] {
      highest_ = -infinity;  // all else is behind, and the walk soon over
      return true;
    }
    lowest_ = t - error;
    highest_ = t + error;
    leader_ = hit;
    return true;
  }

  /// None as long as nothing was met.
  const Hit<Scalar>* leader() const { return leader_.t > Scalar(0) ? &leader_ : nullptr; }
  double highest() const { return highest_; }               ///< what begins beyond is behind
  bool undecided() const { return highest_ == -infinity; }  ///< whether two hits lay too close: nobody leads

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  Hit<Scalar> leader_;
  double lowest_ = infinity;
  double highest_ = infinity;
};

/// Any hits.
template <class Scalar>
class CloseStanding {
 public:
  static constexpr bool by_relative_error = false;  ///< it asks further

  CloseStanding(const PreparedScene<Scalar>& scene, const Vector<Scalar>& direction)
      : scene_(&scene), direction_(&direction) {}

  /// Enters a hit; whether it leads now, or ends nearer than all before.
  bool enter(const Hit<Scalar>& hit, double relative_error) {
    const auto t = static_cast<double>(hit.t);
    if (t - t * relative_error > contest_.highest()) return false;
    return with_kind(hit.kind, [&](auto kind) {
      if constexpr (kind == index_of_kind<InstanceSurface>) {
        const InstancedTriangle<Scalar> triangle = triangle_of_hit(*scene_, hit.index);
        return enter(hit, triangle.distance_range(*direction_, t, scene_->rounding), triangle.identity);
      } else {
        const auto& surface = std::get<kind>(scene_->kinds).surfaces[hit.index];
        const DistanceRange range = distance_range(in_double(surface), in_double(*direction_), t, scene_->rounding);
        return enter(hit, range, surface.identity);
      }
    });
  }

  const Hit<Scalar>* leader() const { return leader_.t > Scalar(0) ? &leader_ : nullptr; }
  double highest() const { return contest_.highest(); }

  /// Once all hits have entered: whether they have to once more.
  bool repeats() {
    if (!contest_.in_doubt()) return false;
    contest_.repeat();
    return true;
  }

 private:
  bool enter(const Hit<Scalar>& hit, const DistanceRange& range, const SurfaceIdentity& identity) {
    const double end = contest_.highest();
    const auto [object, order] = identity;
    const bool leads = contest_.enter(range, {object, static_cast<double>(hit.t), order});
    if (leads) leader_ = hit;
    return leads || contest_.highest() < end;
  }

  const PreparedScene<Scalar>* scene_;
  const Vector<Scalar>* direction_;
  Contest contest_;
  Hit<Scalar> leader_;
};

}  // namespace pyrasim
