// SPDX-License-Identifier: Apache-2.0
#include "surface/affine_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "numeric/length_range.h"
#include "numeric/vectors.h"
#include "surface/principal_axes.h"

namespace pyrasim {
namespace {

constexpr double rounding = 0x1p-48;  // of the matrix's numbers to double, and what comes of it

QuadrupleVector times(const QuadrupleMatrix& matrix, const QuadrupleVector& v) {
  return {dot(matrix[0], v), dot(matrix[1], v), dot(matrix[2], v)};
}

QuadrupleMatrix transposed(const QuadrupleMatrix& m) {
  QuadrupleMatrix result{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) result[i][j] = m[j][i];
  }
  return result;
}

/// The squares of lengths along the mapped axes, and their products.
QuadrupleMatrix products(const QuadrupleMatrix& matrix) {
  const QuadrupleMatrix columns = transposed(matrix);
  return {times(columns, columns[0]), times(columns, columns[1]), times(columns, columns[2])};
}

/// 0 where it is singular.
double largest_ratio(const QuadrupleMatrix& matrix) {
  const QuadrupleVector scales = principal_axes({products(matrix), {}, -1}).frame.scales;
  const Quadruple least = std::min({scales[0], scales[1], scales[2]});
  return least > 0 ? static_cast<double>(1 / least) : 0;
}

/// Whatever is stretched or shrunk by more has no length left that a scene may have.
constexpr double most_stretch = max_coordinate / min_length;

void check_stretch(const QuadrupleMatrix& matrix) {
  double most = 0;
  for (const QuadrupleVector& row : matrix) most = std::max(most, largest(rounded(row)));
  if (most >= 1 / most_stretch && most <= most_stretch) return;
  throw MapError(fmt::format("it makes lengths {:.3g} times as long", most),
                 fmt::format("factors from {:.3g} to {:.3g} are allowed", 1 / most_stretch, most_stretch));
}

/// By cross products of rows.
QuadrupleMatrix inverse_of(const QuadrupleMatrix& m) {
  QuadrupleMatrix columns{cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])};
  const Quadruple determinant = dot(m[0], columns[0]);
  for (QuadrupleVector& column : columns) {
    for (Quadruple& x : column) x /= determinant;
  }
  return transposed(columns);
}

struct Turn {
  Quadruple cosine, sine;
};

/// On the unit circle to 113 bits, at the angle to double's rounding.
Turn turn_by(double degrees) {
  const double turn = std::remainder(degrees, 360);
  const double quarters = std::nearbyint(turn / 90);
  const double angle = (turn - quarters * 90) * std::numbers::pi / 180;
  const Quadruple x = std::cos(angle);
  const Quadruple y = std::sin(angle);
  const Quadruple length = square_root(x * x + y * y);
  const Turn rest = angle == 0 ? Turn{1, 0} : Turn{x / length, y / length};
  switch (static_cast<int>(quarters) & 3) {
    case 0:
      return rest;
    case 1:
      return {-rest.sine, rest.cosine};
    case 2:
      return {-rest.cosine, -rest.sine};
    default:
      return {rest.sine, -rest.cosine};
  }
}

}  // namespace

AffineMap::AffineMap(const QuadrupleMatrix& matrix, const QuadrupleVector& offset)
    : matrix_(matrix), inverse_(inverse_of(matrix)), offset_(offset), unevenness_(largest_ratio(matrix)) {
  if (!(unevenness_ > 0 && unevenness_ <= max_unevenness)) {
    throw MapError(unevenness_ > 0
                       ? fmt::format("it stretches one direction {:.3g} times as much as another", unevenness_)
                       : "it is singular, or nearly: it flattens space",
                   fmt::format("ratios of at most {} between directions are allowed", max_unevenness));
  }
  check_stretch(matrix);
}

AffineMap AffineMap::translation(const glm::dvec3& by) {
  AffineMap map;
  map.offset_ = exactly(by);
  return map;
}

AffineMap AffineMap::scaling(const glm::dvec3& by) { return {{{{by.x, 0, 0}, {0, by.y, 0}, {0, 0, by.z}}}, {0, 0, 0}}; }

/// Rodrigues' formula.
AffineMap AffineMap::rotation(const glm::dvec3& axis, double degrees) {
  const QuadrupleVector k = unit(exactly(axis / largest(axis)));
  const auto [cosine, sine] = turn_by(degrees);
  QuadrupleMatrix matrix{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) matrix[i][j] = (1 - cosine) * k[i] * k[j] + (i == j ? cosine : 0);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t l = (i + 2) % 3;
    matrix[i][j] -= sine * k[l];
    matrix[j][i] += sine * k[l];
  }
  return {matrix, {0, 0, 0}};
}

QuadrupleVector AffineMap::point(const QuadrupleVector& p) const {
  const QuadrupleVector turned = direction(p);
  return {turned[0] + offset_[0], turned[1] + offset_[1], turned[2] + offset_[2]};
}

QuadrupleVector AffineMap::direction(const QuadrupleVector& v) const { return times(matrix_, v); }

QuadrupleVector AffineMap::normal(const QuadrupleVector& n) const { return times(transposed(inverse_), n); }

std::optional<Quadruple> AffineMap::similarity() const {
  const QuadrupleMatrix squares = products(matrix_);
  const Quadruple square = (squares[0][0] + squares[1][1] + squares[2][2]) / 3;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (magnitude(squares[i][j] - (i == j ? square : 0)) > rounding * square) return std::nullopt;
    }
  }
  return square_root(square);
}

bool AffineMap::keeps_axes() const {
  return std::all_of(matrix_.begin(), matrix_.end(),
                     [](const QuadrupleVector& row) { return std::count(row.begin(), row.end(), 0) == 2; });
}

AffineMap AffineMap::after(const AffineMap& inner) const {
  const QuadrupleMatrix columns = transposed(inner.matrix_);
  return {transposed({direction(columns[0]), direction(columns[1]), direction(columns[2])}), point(inner.offset_)};
}

glm::dvec3 mapped_point(const AffineMap& map, const glm::dvec3& point) {
  const glm::dvec3 mapped = rounded(map.point(exactly(point)));
  if (!(largest(mapped) <= max_coordinate)) {
    throw MapError("it moves a point beyond all coordinates",
                   fmt::format("coordinates of at most {} are allowed", max_coordinate));
  }
  return mapped;
}

double mapped_length(Quadruple length) {
  const auto mapped = static_cast<double>(length);
  if (!(mapped >= min_length && mapped <= max_coordinate)) {
    throw MapError(fmt::format("it makes a length {}", mapped),
                   fmt::format("lengths from {} to {} are allowed", min_length, max_coordinate));
  }
  return mapped;
}

void fail_without_area() {
  throw MapError("rounding its coordinates leaves no area",
                 "larger triangles, or a place nearer to the origin, are allowed");
}

Quadruple required_similarity(const AffineMap& map, const std::string& shape, const std::string& becomes) {
  const auto factor = map.similarity();
  if (factor) return *factor;
  throw MapError(fmt::format("it would make {} of a {}", becomes, shape),
                 "moving, turning, mirroring and scaling by the same in all directions are allowed");
}

}  // namespace pyrasim
