// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

#include "real.h"

namespace pyrasim {

/// By powers of x, the constant first.
template <class Number>
using Polynomial = std::vector<Number>;

template <class Number>
Number value_at(const Polynomial<Number>& p, const Number& x) {
  Number value(0);
  for (std::size_t k = p.size(); k-- > 0;) value = value * x + p[k];
  return value;
}

template <class Number>
Polynomial<Number> derivative(const Polynomial<Number>& p) {
  Polynomial<Number> result;
  for (std::size_t k = 1; k < p.size(); ++k) result.push_back(p[k] * Number(static_cast<double>(k)));
  return result;
}

template <class Number>
Polynomial<Number> product(const Polynomial<Number>& p, const Polynomial<Number>& q) {
  Polynomial<Number> result(p.size() + q.size() - 1, Number(0));
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t k = 0; k < q.size(); ++k) result[i + k] = result[i + k] + p[i] * q[k];
  }
  return result;
}

template <class Number>
Polynomial<double> in_double(const Polynomial<Number>& p) {
  Polynomial<double> result;
  for (const Number& coefficient : p) result.push_back(static_cast<double>(coefficient));
  return result;
}

/// The root between `low` and `high`, where p has different signs: Newton's method, or by halves where that leaves
/// them. Real numbers begin where doubles end.
template <class Number>
Number root_between(const Polynomial<Number>& p, const Polynomial<Number>& slope, Number low, Number high) {
  using std::abs;
  constexpr bool is_double = std::is_same_v<Number, double>;
  const Number fine(is_double ? 0x1p-47 : 0x1p-490);
  const Number size = fine * (abs(low) + abs(high));
  const bool rises = value_at(p, low) < Number(0);
  Number x = (low + high) / Number(2);
  if constexpr (!is_double) {
    const Number nearly(
        root_between(in_double(p), in_double(slope), static_cast<double>(low), static_cast<double>(high)));
    if (nearly > low && nearly < high) x = nearly;
  }
  for (int step = 0; step < 1000; ++step) {
    const Number value = value_at(p, x);
    ((value < Number(0)) == rises ? low : high) = x;
    const Number steepness = value_at(slope, x);
    const Number newton = steepness == Number(0) ? low : x - value / steepness;
    if (!(abs(newton - x) > size)) return x;
    const bool between = newton > low && newton < high;
    x = between ? newton : (low + high) / Number(2);
    if (!(high - low > size)) return x;
  }
  return x;
}

/// The roots between `low` and `high` at which p changes its sign, in order: one at most lies between two neighbouring
/// roots of its derivative.
template <class Number>
std::vector<Number> roots_between(const Polynomial<Number>& p, const Number& low, const Number& high) {
  if (p.size() < 2) return {};
  const Polynomial<Number> slope = derivative(p);
  std::vector<Number> ends = roots_between(slope, low, high);
  ends.insert(ends.begin(), low);
  ends.push_back(high);
  std::vector<Number> roots;
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    const bool changes = (value_at(p, ends[k]) < Number(0)) != (value_at(p, ends[k + 1]) < Number(0));
    if (changes) roots.push_back(root_between(p, slope, ends[k], ends[k + 1]));
  }
  return roots;
}

}  // namespace pyrasim
