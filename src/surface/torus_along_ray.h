// SPDX-License-Identifier: Apache-2.0
// A torus along a ray: f = (rho - R)^2 + z^2 - r^2, negative within the tube, where rho is the distance from the axis
// and z the height above the torus' plane. That is |p|^2 + R^2 - r^2 - 2 R rho: a parabola along the ray less a convex
// function, rho. A ray meets the tube twice at most, f is least once or twice, and all places that tell roots apart are
// found by Newton's method from where it runs one way only:
//
// - f' / 2 = a (s - s0) - R rho', where a = |d|^2 and the ray is nearest to the centre at s0. rho' never exceeds m, the
//   length of what d has across the axis. So no place where f' is 0 is further from s0 than R m / a.
// - rho is the side of a hyperbola, least at w. rho' is convex before w and concave after it. Outside of the first and
//   the last minimum f' is therefore steeper than at the minimum: Newton's steps from s0 -+ R m / a never pass it.
// - If there are two minima, w lies between them, and f' between w and the maximum is steepest at w.
#pragma once

#include <algorithm>
#include <cmath>

#include "surface/bracketed_root.h"
#include "surface/view_ray.h"

namespace pyrasim {

/// Places along the ray are values of its parameter less `start()`, that of where it comes nearest to the centre,
/// nearly: the parameter there is rounded once, and what is worked out from it is about the rounded one.
template <class Scalar>
class TorusAlongRay {
 public:
  template <class Torus>
  TorusAlongRay(const Torus& torus, const ViewRay<Scalar>& ray)
      : major_(torus.major),
        minor_squared_(torus.minor * torus.minor),
        start_(dot(torus.center, ray.direction) * ray.inverse_length_squared),
        place_(ray.direction * start_ - torus.center),
        height_(dot(torus.axis, place_)),
        rise_(dot(torus.axis, ray.direction)),
        across_(place_ - torus.axis * height_),
        moving_(ray.direction - torus.axis * rise_),
        moving_squared_(dot(moving_, moving_)),
        length_squared_(moving_squared_ + rise_ * rise_),
        nearest_(-(dot(place_, ray.direction) * ray.inverse_length_squared)) {
    using std::sqrt;  // or that of the number format
    const Vector<Scalar> from_center = place_ + ray.direction * nearest_;
    const Scalar reach = torus.major + torus.minor;
    room_ = reach * reach - dot(from_center, from_center);
    half_chord_ = sqrt(std::max(room_, Scalar(0)) * ray.inverse_length_squared);
    waist_ = moving_squared_ > Scalar(0) ? -(dot(across_, moving_) / moving_squared_) : nearest_;
    steepest_ = major_ * sqrt(moving_squared_) * ray.inverse_length_squared;
  }

  Scalar start() const { return start_; }
  /// Whether the ray meets the sphere about the torus, and between which places.
  bool meets_sphere() const { return room_ >= Scalar(0); }
  Scalar sphere_begin() const { return nearest_ - half_chord_; }
  Scalar sphere_end() const { return nearest_ + half_chord_; }

  Expansion<Scalar> operator()(Scalar s) const {
    using std::sqrt;
    const Vector<Scalar> across = across_ + moving_ * s;
    const Scalar height = height_ + rise_ * s;
    const Scalar rho = sqrt(dot(across, across));
    const Scalar beyond = rho - major_;
    const Scalar value = (beyond * beyond + height * height) - minor_squared_;
    if (!(rho > Scalar(0))) return {value, height * rise_, -length_squared_};  // on the axis: f has a ridge
    const Scalar rho_slope = dot(across, moving_) / rho;
    const Scalar rho_curvature = (moving_squared_ - rho_slope * rho_slope) / rho;
    return {value, beyond * rho_slope + height * rise_, length_squared_ - major_ * rho_curvature};
  }

  /// Where the ray comes nearest to the axis.
  Scalar waist() const { return waist_; }
  /// The first and the last minimum of f, or the waist where there is none before, or after it.
  Scalar first_least() const { return least(nearest_ - steepest_); }
  Scalar last_least() const { return least(nearest_ + steepest_); }

  /// The maximum of f between its minima, or the waist where there is none.
  Scalar greatest() const {
    Scalar s = waist_;
    bool after = false;
    for (int step = 0; step < most_steps; ++step) {
      const auto [value, slope, curvature] = (*this)(s);
      if (!(curvature < Scalar(0))) return waist_;
      const Scalar next = s - slope / curvature;
      if (step == 0) after = next > s;
      if (after ? !(next > s) : !(next < s)) return s;
      s = next;
    }
    return s;
  }

 private:
  /// From `s` towards the waist.
  Scalar least(Scalar s) const {
    const bool before = s < waist_;
    for (int step = 0; step < most_steps; ++step) {
      const auto [value, slope, curvature] = (*this)(s);
      if (!(curvature > Scalar(0))) return waist_;
      const Scalar next = s - slope / curvature;
      if (before ? !(next > s) : !(next < s)) return s;
      if (before ? !(next < waist_) : !(next > waist_)) return waist_;
      s = next;
    }
    return s;
  }

  Scalar major_;
  Scalar minor_squared_;
  Scalar start_;
  Vector<Scalar> place_;   ///< at start(), from the centre
  Scalar height_;          ///< z
  Scalar rise_;            ///< its change along the ray
  Vector<Scalar> across_;  ///< from the axis
  Vector<Scalar> moving_;  ///< its change along the ray
  Scalar moving_squared_;  ///< m^2
  Scalar length_squared_;  ///< a
  Scalar nearest_;         ///< s0
  Scalar room_;            ///< the sphere's radius squared less that of the ray's distance from the centre
  Scalar half_chord_;      ///< of the sphere
  Scalar waist_;           ///< w
  Scalar steepest_;        ///< R m / a
};

}  // namespace pyrasim
