// SPDX-License-Identifier: Apache-2.0
// Sums whose terms cancel, with the rounding errors of the way summed up beside them.
#pragma once

#include <cmath>
#include <concepts>

#include "numeric/fix.h"
#include "numeric/flt.h"
#include "numeric/scalar.h"

namespace pyrasim {

/// a * b - product, where product is a * b rounded: what the rounding took. Exact unless it underflows.
template <std::floating_point Scalar>
Scalar product_error(Scalar a, Scalar b, Scalar product) {
  return std::fma(a, b, -product);
}
/// Two numbers of P bits have a product of 2P <= 50, which a double holds, and with it the difference.
inline Flt product_error(Flt a, Flt b, Flt product) {
  return Flt(static_cast<double>(a) * static_cast<double>(b) - static_cast<double>(product));
}
/// Below the last place of a fixed-point number there is nothing that could hold it.
template <Rounding R, Overflow O>
BasicFix<R, O> product_error(BasicFix<R, O>, BasicFix<R, O>, BasicFix<R, O>) {
  return {};
}

/// a + b - sum, where sum is a + b rounded (Knuth, The Art of Computer Programming, volume 2, 4.2.2). Exact without
/// overflow.
template <class Scalar>
Scalar sum_error(Scalar a, Scalar b, Scalar sum) {
  const Scalar b_there = sum - a;
  return (a - (sum - b_there)) + (b - b_there);
}

/// a . b as if computed with twice the bits and rounded once (Ogita, Rump, Oishi, Accurate sum and dot product, SIAM
/// Journal on Scientific Computing 26, 2005): its error is at most u |a . b| + 9/2 u^2 |a| . |b| with u = 2^-P, so that
/// it stays below 2 ulp while the terms cancel to no less than u of their size. In fixed point, where the errors of
/// products cannot be held, it is the plain sum: 3/2 units of the last place. y and z come together first, as in dot().
template <class Scalar>
Scalar compensated_dot(const Vector<Scalar>& a, const Vector<Scalar>& b) {
  const Scalar x = a.x * b.x;
  const Scalar y = a.y * b.y;
  const Scalar z = a.z * b.z;
  const Scalar yz = y + z;
  const Scalar sum = x + yz;
  const Scalar products = product_error(a.x, b.x, x) + (product_error(a.y, b.y, y) + product_error(a.z, b.z, z));
  return sum + (products + (sum_error(y, z, yz) + sum_error(x, yz, sum)));
}

}  // namespace pyrasim
