// SPDX-License-Identifier: Apache-2.0
// All numbers of a surface, one by one: a surface says once which it has and what power of a length each is,
// `mapped<Other>(number)` with number(value, power), and is so rounded to a format, taken back to double and scaled.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "numeric/scalar.h"

namespace pyrasim {

/// Each number to the nearest value of `To`.
template <class To>
struct ToFormat {
  template <class From>
  To operator()(const From& value, int) const {
    return static_cast<To>(value);
  }
  template <class From>
  Vector<To> operator()(const Vector<From>& v, int) const {
    return {static_cast<To>(v.x), static_cast<To>(v.y), static_cast<To>(v.z)};
  }
  template <class From, std::size_t count>
  auto operator()(const std::array<From, count>& values, int power) const {
    return [&]<std::size_t... k>(std::index_sequence<k...>) {
      return std::array<decltype((*this)(values[0], power)), count>{(*this)(values[k], power)...};
    }
    (std::make_index_sequence<count>());
  }
};

/// Each length times 2^exponent.
struct Scaling {
  int exponent;

  double operator()(double value, int power) const { return std::ldexp(value, power * exponent); }
  Vector<double> operator()(const Vector<double>& v, int power) const {
    return {(*this)(v.x, power), (*this)(v.y, power), (*this)(v.z, power)};
  }
  template <class Value, std::size_t count>
  std::array<Value, count> operator()(std::array<Value, count> values, int power) const {
    for (Value& value : values) value = (*this)(value, power);
    return values;
  }
};

/// `surface`, or its shading, in the numbers of another format.
template <class To, template <class> class Surface, class From>
Surface<To> rounded(const Surface<From>& surface) {
  return surface.template mapped<To>(ToFormat<To>());
}

template <class From>
Vector<double> in_double(const Vector<From>& v) {
  return ToFormat<double>()(v, 0);
}

/// `surface`, or its shading, as double holds it: exactly.
template <template <class> class Surface, class From>
Surface<double> in_double(const Surface<From>& surface) {
  return rounded<double>(surface);
}
template <template <class> class Surface>
const Surface<double>& in_double(const Surface<double>& surface) {
  return surface;
}
template <template <class> class Surface>
const Surface<double>& in_double(const Surface<double>&& surface) = delete;

}  // namespace pyrasim
