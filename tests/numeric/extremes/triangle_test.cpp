// SPDX-License-Identifier: Apache-2.0
// Extremes: rays aimed at the edges and vertices that triangles share.
#include "surface/triangle.h"

#include <array>
#include <numbers>
#include <vector>

#include "../real.h"
#include "formats.h"

namespace pyrasim {
namespace {

template <class Scalar>
using Corners = std::array<Vector<Scalar>, 3>;

/// A closed surface of rings and sectors about a point, its vertices moved at random and rounded to the format. With
/// `thinness` 1 its triangles are about as wide as long; with less, sectors pair up into needles so much thinner.
struct Shape {
  double radius = 3;
  double thinness = 1;
  glm::dvec3 center{0, 0, 0};
};

template <class Scalar>
std::vector<Corners<Scalar>> closed_mesh(Random& random, const Shape& shape) {
  constexpr int rings = 9;
  constexpr int sectors = 14;
  const auto vertex = [&](double latitude, double longitude) {
    const glm::dvec3 unit(std::sin(latitude) * std::cos(longitude), std::cos(latitude),
                          std::sin(latitude) * std::sin(longitude));
    return to_scalar<Scalar>(shape.center + unit * (shape.radius * random.uniform(0.9, 1.1)));
  };
  std::vector<std::vector<Vector<Scalar>>> ring(rings);
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < sectors; ++j) {
      const double step = j % 2 == 0 ? j : j - 1 + shape.thinness;
      ring[static_cast<std::size_t>(i)].push_back(
          vertex(std::numbers::pi * (i + 1) / (rings + 1), 2 * std::numbers::pi * step / sectors));
    }
  }
  const Vector<Scalar> top = vertex(0, 0);
  const Vector<Scalar> bottom = vertex(std::numbers::pi, 0);
  std::vector<Corners<Scalar>> mesh;
  for (std::size_t j = 0; j < sectors; ++j) {
    const std::size_t k = (j + 1) % sectors;
    mesh.push_back({top, ring[0][j], ring[0][k]});
    mesh.push_back({bottom, ring[rings - 1][k], ring[rings - 1][j]});
    for (std::size_t i = 0; i + 1 < rings; ++i) {
      mesh.push_back({ring[i][j], ring[i + 1][j], ring[i + 1][k]});
      mesh.push_back({ring[i][k], ring[i][j], ring[i + 1][k]});
    }
  }
  return mesh;
}

template <class Scalar>
int hits(const std::vector<Corners<Scalar>>& mesh, const Vector<Scalar>& direction) {
  const TriangleShear<Scalar> shear(direction);
  int count = 0;
  for (const auto& [a, b, c] : mesh) {
    const TriangleSurface<Scalar> triangle{{{{a.x, a.y, a.z}, {b.x, b.y, b.z}, {c.x, c.y, c.z}}}, {0, 0}};
    count += triangle.intersect(shear) > Scalar(0) ? 1 : 0;
  }
  return count;
}

/// Aimed at a random triangle's vertex, at a point of its edge, or (one of four) at its inside.
template <class Scalar>
Vector<Scalar> aimed_at(Random& random, const Corners<Scalar>& triangle) {
  const std::size_t k = random.below(3);
  const glm::dvec3 a(triangle[k]);
  const glm::dvec3 b(triangle[(k + 1) % 3]);
  const glm::dvec3 c(triangle[(k + 2) % 3]);
  const auto kind = random.below(4);
  if (kind == 0) return triangle[k];
  const glm::dvec3 on_edge = a + (b - a) * random.uniform(0, 1);
  return to_scalar<Scalar>(kind == 3 ? on_edge + (c - on_edge) * random.uniform(0, 1) : on_edge);
}

/// Rays from inside a closed mesh that meet nothing.
template <class Scalar>
int leaks(const Shape& shape, int rays) {
  Random random(4);
  int leaked = 0;
  constexpr int rays_per_mesh = 200;
  for (int done = 0; done < rays; done += rays_per_mesh) {
    const auto mesh = closed_mesh<Scalar>(random, shape);
    for (int k = 0; k < rays_per_mesh; ++k) {
      const auto direction = aimed_at<Scalar>(random, mesh[random.below(mesh.size())]);
      leaked += hits(mesh, direction) > 0 ? 0 : 1;
    }
  }
  return leaked;
}

const std::array<std::pair<const char*, Shape>, 4> shapes{{{"triangles", {}},
                                                           {"needles of 1e-4", {.thinness = 1e-4}},
                                                           {"off centre", {.radius = 3, .center = {1.5, 1, -1.2}}},
                                                           {"off-centre needles", {3, 1e-4, {1.5, 1, -1.2}}}}};

template <class Scalar>
void expect_no_leaks(int rays) {
  for (const auto& [name, shape] : shapes) {
    const int leaked = leaks<Scalar>(shape, rays);
    print_figure(fmt::format("leaks, {}", name), format_of<Scalar>(), fmt::format("{} of {}", leaked, rays));
    EXPECT_EQ(leaked, 0) << name;
  }
}

TEST(ExtremesTriangle, SharedEdgesNeverLeakInDouble) { expect_no_leaks<double>(100'000); }
TEST(ExtremesTriangle, SharedEdgesNeverLeakInFloat) { expect_no_leaks<float>(100'000); }

TEST(ExtremesTriangle, SharedEdgesNeverLeakInAnyFormat) {
  for_every_format([]<class Scalar>() { expect_no_leaks<Scalar>(400); });
}

/// Fixed point has a size below which it leaks: t's numerator is a product of three coordinates, and where that is less
/// than the last place nothing is left of it. It keeps a surface of radius 2^(1-F/4), and loses one of half or a
/// quarter of that. A scene's scale keeps the largest coordinate far from there.
TEST(ExtremesTriangle, FixedPointLeaksOnlyWhereProductsOfThreeCoordinatesVanish) {
  for_every_format([]<class Scalar>() {
    if (is_floating<Scalar>) return;
    const double kept = std::ldexp(1.0, 1 - format_of<Scalar>().fraction_bits / 4);
    EXPECT_EQ(leaks<Scalar>({.radius = kept}, 400), 0);
    EXPECT_GT(leaks<Scalar>({.radius = kept / 4}, 400), 0);
    print_figure("no leaks in surfaces down to", format_of<Scalar>(), fmt::format("radius {}", kept));
  });
}

/// From outside as many crossings go in as out: the edge functions' signs say which. A ray through an edge or a vertex
/// counts on both sides of it, so rays that touch one (a function of 0) are left out, as are none of the others.
template <class Scalar>
void expect_even_crossings(int rays) {
  Random random(8);
  int crossed = 0;
  for (int k = 0; k < rays; k += 50) {
    const auto mesh = closed_mesh<Scalar>(random, {.radius = 1, .center = {4, 0.5, -0.5}});
    for (int j = 0; j < 50; ++j) {
      const auto direction = to_scalar<Scalar>({1, random.uniform(-0.3, 0.5), random.uniform(-0.5, 0.3)});
      const TriangleShear<Scalar> shear(direction);
      int count = 0;
      bool touches = false;
      for (const auto& [a, b, c] : mesh) {
        const TriangleSurface<Scalar> triangle{{{{a.x, a.y, a.z}, {b.x, b.y, b.z}, {c.x, c.y, c.z}}}, {0, 0}};
        if (triangle.intersect(shear) > Scalar(0)) ++count;
        const auto sheared = [&](const Vector<Scalar>& v) {
          return std::pair(v.y - shear.sx * v.x, v.z - shear.sy * v.x);  // kz is 0: x is the largest component
        };
        for (const auto& [p, q] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
          const auto [px, py] = sheared(p);
          const auto [qx, qy] = sheared(q);
          touches = touches || px * qy - py * qx == Scalar(0);
        }
      }
      if (touches) continue;
      ASSERT_EQ(count % 2, 0) << static_cast<double>(direction.y) << " " << static_cast<double>(direction.z);
      crossed += count;
    }
  }
  EXPECT_GT(crossed, rays / 10);
}

TEST(ExtremesTriangle, CrossingsOfAClosedSurfaceAreEven) {
  expect_even_crossings<double>(10'000);
  expect_even_crossings<float>(10'000);
  const FormatScope<Flt> scope(fp24);
  expect_even_crossings<Flt>(2000);
}

}  // namespace
}  // namespace pyrasim
