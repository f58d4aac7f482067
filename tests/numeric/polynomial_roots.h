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

/// The root between `low` and `high`, where p has different signs: Newton's method, or by halves where that leaves
/// them.
template <class Number>
Number root_between(const Polynomial<Number>& p, const Polynomial<Number>& slope, Number low, Number high) {
  using std::abs;
  const Number fine(std::is_same_v<Number, double> ? 0x1p-53 : 0x1p-490);
  const bool rises = value_at(p, low) < Number(0);
  Number x = (low + high) / Number(2);
  for (int step = 0; step < 4000; ++step) {
    const Number value = value_at(p, x);
    ((value < Number(0)) == rises ? low : high) = x;
    const Number steepness = value_at(slope, x);
    Number next = steepness == Number(0) ? low : x - value / steepness;
    if (!(next > low && next < high)) next = (low + high) / Number(2);
    if (!(abs(next - x) > fine * (abs(low) + abs(high)))) return next;
    x = next;
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
