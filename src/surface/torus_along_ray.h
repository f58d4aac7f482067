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

/// A ray about a centre. Places along it are values of its parameter less `start`, that of where it comes nearest,
/// nearly: the parameter there is rounded once, and what is worked out from it is about the rounded one.
template <class Scalar>
struct CenteredRay {
  const Vector<Scalar>& direction;
  Scalar inverse_length_squared;
  Scalar start;
  Vector<Scalar> place;  ///< at start, from the centre
  Scalar nearest;        ///< where it really is
  Scalar room;           ///< the square of a radius less that of the distance there

  CenteredRay(const Vector<Scalar>& center, Scalar radius, const ViewRay<Scalar>& ray)
      : direction(ray.direction),
        inverse_length_squared(ray.inverse_length_squared),
        start(dot(center, direction) * inverse_length_squared),
        place(direction * start - center),
        nearest(-(dot(place, direction) * inverse_length_squared)) {
    const Vector<Scalar> from_center = place + direction * nearest;
    room = radius * radius - dot(from_center, from_center);
  }
};

template <class Scalar>
class TorusAlongRay {
 public:
  template <class Torus>
  TorusAlongRay(const Torus& torus, const CenteredRay<Scalar>& ray)
      : major_(torus.major),
        minor_squared_(torus.minor * torus.minor),
        nearest_(ray.nearest),
        height_(dot(torus.axis, ray.place)),
        rise_(dot(torus.axis, ray.direction)),
        across_(ray.place - torus.axis * height_),
        moving_(ray.direction - torus.axis * rise_),
        moving_squared_(dot(moving_, moving_)),
        length_squared_(moving_squared_ + rise_ * rise_) {
    using std::sqrt;  // or that of the number format
    waist_ = moving_squared_ > Scalar(0) ? -(dot(across_, moving_) / moving_squared_) : nearest_;
    steepest_ = major_ * sqrt(moving_squared_) * ray.inverse_length_squared;
  }

  /// A place, and f there.
  struct Place {
    Scalar s;
    Expansion<Scalar> f;
  };

  Expansion<Scalar> operator()(Scalar s) const {
    using std::sqrt;
    const Vector<Scalar> across = across_ + moving_ * s;
    const Scalar height = height_ + rise_ * s;
    const Scalar rho = sqrt(dot(across, across));
    const Scalar beyond = rho - major_;
    const Scalar value = (beyond * beyond + height * height) - minor_squared_;
    if (!(rho > Scalar(0))) return {value, height * rise_, -length_squared_};  // on the axis: f has a ridge
    const Scalar rho_slope = dot(across, moving_) / rho;
    const Scalar bend = major_ * (moving_squared_ - rho_slope * rho_slope) / rho;  // R rho''
    return {value, beyond * rho_slope + height * rise_, length_squared_ - bend};
  }

  /// The first and the last minimum of f, or the waist where there is none before, or after it. Any place on the way
  /// there will do that comes after `enough` and at which f is not positive.
  Place first_least(Scalar enough) const { return least(nearest_ - steepest_, enough); }
  Place last_least(Scalar enough) const { return least(nearest_ + steepest_, enough); }

  /// The maximum of f between its minima, or the waist where there is none.
  Place greatest() const {
    Place at{waist_, (*this)(waist_)};
    bool after = false;
    for (int step = 0; step < most_steps && at.f.curvature < Scalar(0); ++step) {
      const Scalar next = at.s - at.f.slope / at.f.curvature;
      if (step == 0) after = next > at.s;
      if (after ? !(next > at.s) : !(next < at.s)) break;
      at = {next, (*this)(next)};
    }
    return at;
  }

 private:
  /// From `s` towards the waist.
  Place least(Scalar s, Scalar enough) const {
    const bool before = s < waist_;
    for (int step = 0; step < most_steps; ++step) {
      const Expansion<Scalar> f = (*this)(s);
      if (s > enough && f.value <= Scalar(0)) return {s, f};
      if (!(f.curvature > Scalar(0))) break;
      const Scalar next = s - f.slope / f.curvature;
      if (before ? !(next > s) : !(next < s)) return {s, f};
      if (before ? !(next < waist_) : !(next > waist_)) break;
      s = next;
    }
    return {waist_, (*this)(waist_)};
  }

  Scalar major_;
  Scalar minor_squared_;
  Scalar nearest_;         ///< s0
  Scalar height_;          ///< z at the ray's start
  Scalar rise_;            ///< its change along the ray
  Vector<Scalar> across_;  ///< from the axis, there
  Vector<Scalar> moving_;  ///< its change along the ray
  Scalar moving_squared_;  ///< m^2
  Scalar length_squared_;  ///< a
  Scalar waist_;           ///< w
  Scalar steepest_;        ///< R m / a
};

}  // namespace pyrasim
