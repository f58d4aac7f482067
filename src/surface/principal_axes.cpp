// SPDX-License-Identifier: Apache-2.0
#include "surface/principal_axes.h"

#include <algorithm>

namespace pyrasim {
namespace {

/// A direction and how much the matrix stretches it.
struct Principal {
  Quadruple value;
  QuadrupleVector axis;
};

/// Turns axes p and q until matrix[p][q] is 0 (Jacobi's rotation; Golub, Van Loan, Matrix Computations, 8.5).
void rotate(std::array<QuadrupleVector, 3>& matrix, std::array<QuadrupleVector, 3>& axes, std::size_t p,
            std::size_t q) {
  if (matrix[p][q] == 0) return;
  const Quadruple ratio = (matrix[q][q] - matrix[p][p]) / (2 * matrix[p][q]);
  const Quadruple tangent = (ratio < 0 ? -1 : 1) / (magnitude(ratio) + square_root(ratio * ratio + 1));
  const Quadruple cosine = 1 / square_root(tangent * tangent + 1);
  const Quadruple sine = tangent * cosine;
  const auto turn = [&](Quadruple& of_p, Quadruple& of_q) {
    const Quadruple before = of_p;
    of_p = cosine * before - sine * of_q;
    of_q = sine * before + cosine * of_q;
  };
  for (std::size_t k = 0; k < 3; ++k) turn(matrix[k][p], matrix[k][q]);
  for (std::size_t k = 0; k < 3; ++k) turn(matrix[p][k], matrix[q][k]);
  matrix[p][q] = matrix[q][p] = 0;
  for (std::size_t k = 0; k < 3; ++k) turn(axes[p][k], axes[q][k]);
}

/// The largest values first, what is negligible last as 0.
std::array<Principal, 3> principals(std::array<QuadrupleVector, 3> matrix, double negligible) {
  std::array<QuadrupleVector, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  constexpr int sweeps = 12;  // each squares what is left
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    rotate(matrix, axes, 0, 1);
    rotate(matrix, axes, 0, 2);
    rotate(matrix, axes, 1, 2);
  }
  std::array<Principal, 3> result{};
  Quadruple largest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    result[k] = {matrix[k][k], axes[k]};
    largest = std::max(largest, magnitude(matrix[k][k]));
  }
  for (Principal& principal : result) {
    if (magnitude(principal.value) <= negligible * largest) principal.value = 0;
  }
  std::stable_sort(result.begin(), result.end(), [](const Principal& a, const Principal& b) {
    return (a.value != 0) != (b.value != 0) ? a.value != 0 : a.value > b.value;
  });
  return result;
}

/// Of two axes without a square, the second takes the whole of the linear term.
void gather_linear(std::array<Principal, 3>& principals, const QuadrupleVector& linear) {
  const Quadruple y = dot(principals[1].axis, linear);
  const Quadruple z = dot(principals[2].axis, linear);
  const Quadruple length = square_root(y * y + z * z);
  if (y == 0 || length == 0) return;
  const QuadrupleVector a = principals[1].axis;
  const QuadrupleVector b = principals[2].axis;
  for (std::size_t k = 0; k < 3; ++k) {
    principals[1].axis[k] = (z * a[k] - y * b[k]) / length;
    principals[2].axis[k] = (y * a[k] + z * b[k]) / length;
  }
}

}  // namespace

PrincipalAxes principal_axes(const GeneralQuadric& quadric, double negligible) {
  auto found = principals(quadric.matrix, negligible);
  if (found[1].value == 0) gather_linear(found, quadric.linear);
  PrincipalAxes result{};
  for (const Principal& principal : found) result.divisor = std::max(result.divisor, magnitude(principal.value));
  QuadricFrame& frame = result.frame;
  Quadruple constant = quadric.constant;
  Quadruple terms = magnitude(constant);  // that may cancel
  const auto move = [&](std::size_t k, Quadruple by) {
    for (std::size_t axis = 0; axis < 3; ++axis) frame.center[axis] += found[k].axis[axis] * by;
  };
  for (std::size_t k = 0; k < 3; ++k) {
    const Quadruple value = found[k].value;
    const Quadruple linear = dot(found[k].axis, quadric.linear);
    frame.axes[k] = found[k].axis;
    frame.signs[k] = value > 0 ? 1 : value < 0 ? -1 : 0;
    frame.scales[k] = square_root(magnitude(value) / result.divisor);
    if (value == 0) continue;
    move(k, -linear / value);
    constant -= linear * linear / value;
    terms += magnitude(linear * linear / value);
  }
  if (magnitude(constant) <= negligible / 8 * terms) constant = 0;
  const Quadruple left = found[2].value == 0 ? dot(found[2].axis, quadric.linear) : 0;
  Quadruple size = 0;
  for (const Quadruple x : quadric.linear) size = std::max(size, magnitude(x));
  if (magnitude(left) > negligible * size) {
    frame.scales[2] = 1;
    frame.linear = left / result.divisor;
    move(2, -constant / (2 * left));
    constant = 0;
  }
  frame.constant = constant / result.divisor;
  return result;
}

}  // namespace pyrasim
