// SPDX-License-Identifier: Apache-2.0
// Surfaces of second order, worked out by hand.
#include "surface/quadric.h"

#include <gtest/gtest.h>

#include "surface/cone.h"
#include "surface/cylinder.h"
#include "surface/ellipsoid.h"

namespace pyrasim {
namespace {

/// Seen from the world's origin.
template <class Description>
auto seen(const Description& description, const glm::dvec3& from = {0, 0, 0}) {
  Camera camera;
  camera.position = from;
  camera.look_at = from + glm::dvec3(1, 0, 0);
  return description.prepared({ObserverFrame(camera), {}}).surface;
}

template <class Description>
double hit(const Description& description, const glm::dvec3& direction, const glm::dvec3& from = {0, 0, 0}) {
  return seen(description, from).intersect(ViewRay<double>(direction));
}

template <class Description>
glm::dvec3 normal(const Description& description, const glm::dvec3& direction) {
  const auto surface = seen(description);
  return normalized(surface.outward({}, direction, surface.intersect(ViewRay<double>(direction))));
}

const Ellipsoid egg{{8, 0, 0}, {2, 1, 4}};
const Cylinder column{{{8, -2, 0}, {8, 2, 0}}, 1};
const Cylinder tube{{{4, 0, 0}, {8, 0, 0}}, 1, false};
const Cone hat{{{4, 0, 0}, {8, 0, 0}}, 0, 2};

TEST(QuadricSurfaces, Ellipsoid) {
  EXPECT_EQ(hit(egg, {1, 0, 0}), 6);
  EXPECT_EQ(hit(egg, {-1, 0, 0}), 0);
  EXPECT_EQ(hit(egg, {1, 0.5, 0}), 0);
  EXPECT_EQ(hit(egg, {1, 0, 0}, {8, 0, 0}), 2);   // from inside
  EXPECT_EQ(hit(egg, {1, 0, 0}, {6, 0, 0}), 4);   // from its skin, through it
  EXPECT_EQ(hit(egg, {-1, 0, 0}, {6, 0, 0}), 0);  // and away from it
  EXPECT_EQ(normal(egg, {1, 0, 0}), glm::dvec3(-1, 0, 0));
}

TEST(QuadricSurfaces, CylinderAndItsEnds) {
  EXPECT_EQ(hit(column, {1, 0, 0}), 7);
  EXPECT_EQ(hit(column, {1, 0.25, 0}), 7);
  EXPECT_EQ(hit(column, {1, 0.3, 0}), 0);
  EXPECT_EQ(hit(column, {1, 0.25, 0}, {0, 0.5, 0}), 0);                                     // over it
  EXPECT_EQ(hit(column, {1, -0.25, 0}, {0, 4, 0}), 8);                                      // from above
  EXPECT_EQ(hit(column, {1, 0, 0}, {8, 0, 0}), 1);                                          // from inside
  EXPECT_EQ(normal(Cylinder{{{4, 0, 0}, {8, 0, 0}}, 1}, {1, 0, 0}), glm::dvec3(-1, 0, 0));  // a cap's
  EXPECT_EQ(hit(Cylinder{{{4, 0, 0}, {8, 0, 0}}, 1}, {1, 0, 0}), 4);
  EXPECT_EQ(hit(Cylinder{{{4, 0, 0}, {8, 0, 0}}, 1}, {1, 0, 0}, {5, 0, 0}), 3);
}

TEST(QuadricSurfaces, OpenTubesAreSeenFromInside) {
  EXPECT_EQ(hit(tube, {1, 0, 0}), 0);  // through it
  EXPECT_EQ(hit(tube, {1, 0.2, 0}), 5);
  EXPECT_EQ(normal(tube, {1, 0.2, 0}), glm::dvec3(0, 1, 0));
  EXPECT_EQ(hit(tube, {1, 0.25, 0}), 4);  // the rim belongs to it
  EXPECT_EQ(hit(tube, {1, 0.26, 0}), 0);
}

TEST(QuadricSurfaces, ConeWithOneNappe) {
  EXPECT_EQ(hit(hat, {1, 0, 0}), 4);     // its tip
  EXPECT_EQ(hit(hat, {1, 0.25, 0}), 8);  // a quarter of a height of 8, and half of one of 4
  EXPECT_EQ(hit(hat, {1, -0.1, 0}), 5);
  EXPECT_EQ(hit(hat, {1, 0.5, 0}), 0);
  EXPECT_EQ(hit(hat, {-1, 0.5, 0}), 0);
  EXPECT_EQ(hit(hat, {1, 0.5, 0}, {2, -1, 0}), 2);  // along its side
  EXPECT_EQ(hit(Cone{{{4, 0, 0}, {8, 0, 0}}, 2, 2}, {1, 0.3, 0}),
            hit(Cylinder{{{4, 0, 0}, {8, 0, 0}}, 2}, {1, 0.3, 0}));
}

Quadric quadric(const Quadric::Coefficients& coefficients, std::vector<HalfSpace<double>> clip = {},
                bool capped = false) {
  return {coefficients, std::move(clip), capped};
}

TEST(QuadricSurfaces, Paraboloid) {
  const Quadric dish = quadric({.yy = 1, .zz = 1, .x = -1, .constant = 4});  // y^2 + z^2 = x - 4
  EXPECT_EQ(hit(dish, {1, 0, 0}), 4);
  EXPECT_EQ(hit(dish, {1, 0.25, 0}), 8);  // touches it
  EXPECT_EQ(hit(dish, {1, 0.3, 0}), 0);
  EXPECT_EQ(hit(dish, {-1, 1, 0}, {8, 0, 0}), (std::sqrt(17.0) - 1) / 2);
  EXPECT_FALSE(bounds(seen(dish)));
  EXPECT_EQ(hit(quadric(dish.coefficients, {{{-1, 0, 0}, -5}}), {1, 0, 0}), 0);        // its tip is cut off
  EXPECT_EQ(hit(quadric(dish.coefficients, {{{-1, 0, 0}, -5}}, true), {1, 0, 0}), 5);  // and the cut closed
}

TEST(QuadricSurfaces, HyperboloidOfTwoSheets) {
  const Quadric sheets = quadric({.xx = -1, .yy = 1, .zz = 1, .x = 16, .constant = -60});  // r^2 = (x - 8)^2 - 4
  EXPECT_EQ(hit(sheets, {1, 0, 0}), 6);
  EXPECT_EQ(hit(sheets, {1, 0, 0}, {8, 0, 0}), 2);
  EXPECT_EQ(hit(quadric(sheets.coefficients, {{{-1, 0, 0}, -8}}, true), {1, 0, 0}), 10);
}

TEST(QuadricSurfaces, FormsThatHaveOtherNames) {
  const Quadric sphere = quadric({.xx = 2, .yy = 2, .zz = 2, .x = -32, .constant = 120});
  EXPECT_EQ(hit(sphere, {1, 0, 0}), 6);
  ASSERT_TRUE(bounds(seen(sphere)));
  EXPECT_EQ(bounds(seen(sphere))->lower, glm::dvec3(6, -2, -2));
  EXPECT_EQ(bounds(seen(sphere))->upper, glm::dvec3(10, 2, 2));
  const Quadric turned = quadric({.xy = 1, .constant = 4});  // x y = -4: a cylinder on a hyperbola
  EXPECT_NEAR(hit(turned, {1, -1, 0}), 2, 1e-15);
  EXPECT_EQ(hit(turned, {1, 1, 0}), 0);
  const Quadric sheet = quadric({.xx = 1, .y = -1});  // y = x^2: a cylinder on a parabola
  EXPECT_EQ(hit(sheet, {1, 2, 0}), 2);
  EXPECT_EQ(hit(sheet, {1, 0, 0}, {-1, 4, 0}), 3);
}

}  // namespace
}  // namespace pyrasim
