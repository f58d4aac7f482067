// SPDX-License-Identifier: Apache-2.0
#include "surface/triangle.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "../test_scenes.h"

namespace pyrasim {
namespace {

template <class Scalar>
class TriangleOf : public testing::Test {
 protected:
  using V = Vector<Scalar>;
  static TriangleSurface<Scalar> surface(const V& a, const V& b, const V& c) {
    return {{{{a.x, a.y, a.z}, {b.x, b.y, b.z}, {c.x, c.y, c.z}}}, {0, 0}};
  }
  static Scalar hit(const V& a, const V& b, const V& c, const V& direction) {
    return surface(a, b, c).intersect(TriangleShear<Scalar>(direction));
  }
};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(TriangleOf, Scalars);

TYPED_TEST(TriangleOf, HandComputedFromEitherSide) {
  EXPECT_EQ(this->hit({2, -1, -1}, {2, 1, -1}, {2, 0, 1}, {1, 0, 0}), 2);
  EXPECT_EQ(this->hit({2, 1, -1}, {2, -1, -1}, {2, 0, 1}, {1, 0, 0}), 2);
  EXPECT_EQ(this->hit({2, -1, -1}, {2, 1, -1}, {2, 0, 1}, {4, 0, 0}), 0.5);
  EXPECT_EQ(this->hit({2, -1, -1}, {2, 1, -1}, {2, 0, 1}, {1, 0.25, 0}), 2);
  // A slope: x + y = 4 between z = -1 and 1; the ray (1, 1, 0) meets it at t = 2.
  EXPECT_EQ(this->hit({4, 0, -1}, {4, 0, 1}, {0, 4, 0}, {1, 1, 0}), 2);
}

TYPED_TEST(TriangleOf, EveryAxisCanBeTheLongest) {
  EXPECT_EQ(this->hit({-1, 2, -1}, {1, 2, -1}, {0, 2, 1}, {0, 1, 0}), 2);
  EXPECT_EQ(this->hit({-1, -1, 2}, {1, -1, 2}, {0, 1, 2}, {0, 0, 1}), 2);
  EXPECT_EQ(this->hit({-2, -1, -1}, {-2, 1, -1}, {-2, 0, 1}, {-1, 0, 0}), 2);
  EXPECT_EQ(this->hit({-1, -2, -1}, {1, -2, -1}, {0, -2, 1}, {0, -1, 0}), 2);
  EXPECT_EQ(this->hit({-1, -1, -2}, {1, -1, -2}, {0, 1, -2}, {0, 0, -1}), 2);
}

TYPED_TEST(TriangleOf, OutsideAndBehindAreNoHits) {
  EXPECT_EQ(this->hit({2, -1, -1}, {2, 1, -1}, {2, 0, 1}, {1, 0, 0.625}), 0);
  EXPECT_EQ(this->hit({2, -1, -1}, {2, 1, -1}, {2, 0, 1}, {1, 0.5, 0.5}), 0);
  EXPECT_EQ(this->hit({2, -1, -1}, {2, 1, -1}, {2, 0, 1}, {-1, 0, 0}), 0);
}

TYPED_TEST(TriangleOf, SeenEdgeOnIsNoHit) { EXPECT_EQ(this->hit({2, 0, -1}, {2, 0, 1}, {4, 0, 0}, {1, 0, 0}), 0); }

TYPED_TEST(TriangleOf, EdgesAndVerticesBelongToIt) {
  const Vector<TypeParam> a{2, -1, -1};
  const Vector<TypeParam> b{2, 1, -1};
  const Vector<TypeParam> c{2, 0, 1};
  for (const auto& vertex : {a, b, c}) EXPECT_EQ(this->hit(a, b, c, vertex), 1);
  for (const auto& middle : {a + b, b + c, c + a}) EXPECT_EQ(this->hit(a, b, c, middle), 0.5);
}

/// A sphere of triangles about the observer with its vertices moved at random: whatever a ray is aimed at, it must hit.
template <class Scalar>
std::vector<std::array<Vector<Scalar>, 3>> closed_mesh(std::uint64_t seed) {
  constexpr int rings = 9;
  constexpr int sectors = 13;
  std::mt19937_64 random(seed);
  const auto moved = [&](double x, double y, double z) {
    return to_scalar<Scalar>(glm::dvec3(x, y, z) * 3.0 + random_vector(random, glm::dvec3(-0.3), glm::dvec3(0.3)));
  };
  const Vector<Scalar> top = moved(0, 1, 0);
  const Vector<Scalar> bottom = moved(0, -1, 0);
  std::vector<std::vector<Vector<Scalar>>> ring(rings);
  for (int i = 0; i < rings; ++i) {
    const double latitude = 3.14159265 * (i + 1) / (rings + 1);
    for (int j = 0; j < sectors; ++j) {
      const double longitude = 2 * 3.14159265 * j / sectors;
      ring[i].push_back(moved(std::sin(latitude) * std::cos(longitude), std::cos(latitude),
                              std::sin(latitude) * std::sin(longitude)));
    }
  }
  std::vector<std::array<Vector<Scalar>, 3>> mesh;
  for (int j = 0; j < sectors; ++j) {
    const int k = (j + 1) % sectors;
    mesh.push_back({top, ring[0][j], ring[0][k]});
    mesh.push_back({bottom, ring[rings - 1][k], ring[rings - 1][j]});
    for (int i = 0; i + 1 < rings; ++i) {
      mesh.push_back({ring[i][j], ring[i + 1][j], ring[i + 1][k]});
      mesh.push_back({ring[i][k], ring[i][j], ring[i + 1][k]});
    }
  }
  return mesh;
}

TYPED_TEST(TriangleOf, SharedEdgesAndVerticesNeverLeak) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const auto mesh = closed_mesh<TypeParam>(seed);
    const auto hits = [&](const Vector<TypeParam>& direction) {
      const TriangleShear<TypeParam> shear(direction);
      int count = 0;
      for (const auto& [a, b, c] : mesh) count += this->surface(a, b, c).intersect(shear) > 0 ? 1 : 0;
      return count;
    };
    for (const auto& triangle : mesh) {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto& a = triangle[k];
        const auto& b = triangle[(k + 1) % 3];
        EXPECT_GE(hits(a), 1);
        EXPECT_GE(hits(a * TypeParam(0.7)), 1);
        for (int s = 1; s < 32; ++s) ASSERT_GE(hits(a + (b - a) * (TypeParam(s) / 32)), 1) << seed << " " << s;
      }
    }
  }
}

}  // namespace
}  // namespace pyrasim
