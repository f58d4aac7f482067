// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <compare>
#include <limits>

namespace pyrasim {

/// A double that counts what is done with it.
class Counted {
 public:
  static inline long multiplications = 0;
  static inline long divisions = 0;
  static inline long roots = 0;

  constexpr Counted() = default;
  template <class Number>
  constexpr explicit Counted(Number x) : value_(static_cast<double>(x)) {}
  constexpr explicit operator double() const { return value_; }

  Counted operator-() const { return Counted(-value_); }
  friend Counted operator+(Counted a, Counted b) { return Counted(a.value_ + b.value_); }
  friend Counted operator-(Counted a, Counted b) { return Counted(a.value_ - b.value_); }
  friend Counted operator*(Counted a, Counted b) {
    ++multiplications;
    return Counted(a.value_ * b.value_);
  }
  friend Counted operator/(Counted a, Counted b) {
    ++divisions;
    return Counted(a.value_ / b.value_);
  }
  friend Counted sqrt(Counted a) {
    ++roots;
    return Counted(std::sqrt(a.value_));
  }
  Counted& operator+=(Counted b) { return *this = *this + b; }
  Counted& operator-=(Counted b) { return *this = *this - b; }
  Counted& operator*=(Counted b) { return *this = *this * b; }
  Counted& operator/=(Counted b) { return *this = *this / b; }
  friend bool operator==(Counted a, Counted b) = default;
  friend auto operator<=>(Counted a, Counted b) = default;

 private:
  double value_ = 0;
};

}  // namespace pyrasim

template <>
struct std::numeric_limits<pyrasim::Counted> : std::numeric_limits<double> {
  static pyrasim::Counted max() { return pyrasim::Counted(std::numeric_limits<double>::max()); }
  static pyrasim::Counted epsilon() { return pyrasim::Counted(std::numeric_limits<double>::epsilon()); }
  static pyrasim::Counted denorm_min() { return pyrasim::Counted(std::numeric_limits<double>::denorm_min()); }
};
