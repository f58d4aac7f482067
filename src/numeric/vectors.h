// SPDX-License-Identifier: Apache-2.0
// Sizes of vectors, in double: what error bounds and preparation ask for.
#pragma once

#include <algorithm>
#include <cmath>

#include "numeric/scalar.h"

namespace pyrasim {

inline Vector<double> magnitudes(const Vector<double>& v) { return {std::abs(v.x), std::abs(v.y), std::abs(v.z)}; }
inline double sum(const Vector<double>& v) { return v.x + (v.y + v.z); }
/// The largest magnitude of a component.
inline double largest(const Vector<double>& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }
inline double length(const Vector<double>& v) { return std::sqrt(dot(v, v)); }

}  // namespace pyrasim
