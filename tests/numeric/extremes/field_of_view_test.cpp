// SPDX-License-Identifier: Apache-2.0
// Extremes: the narrowest and the widest view, and a sphere that fills it.
#include <numbers>

#include "../real.h"
#include "camera/view_vector.h"
#include "formats.h"

namespace pyrasim {
namespace {

constexpr int size = 32;

/// A square screen `degrees` wide.
Screen screen_of(double degrees) {
  const double pixel = 2 * std::tan(degrees / 2 * std::numbers::pi / 180) / size;
  return {size, size, 1, pixel, pixel};
}

/// The sphere that a view vector meets first, exactly, and the smallest of |passes by - radius| / distance to a sphere
/// that decides it: what a format may turn round when it is that small.
struct Exact {
  std::uint32_t object = no_object;
  double margin = 1e300;
};

Exact nearest_sphere(const Scene& scene, const glm::dvec3& view_vector) {
  Exact exact;
  Real nearest = 1e300;
  const RealVector d = real(view_vector);
  const Real length_squared = dot(d, d);
  for (std::uint32_t k = 0; k < scene.objects.size(); ++k) {
    const auto& sphere = std::get<Sphere>(scene.objects[k].surface);
    const RealVector c = real(sphere.center);
    const Real along = dot(c, d);
    const Real center_squared = dot(c, c);
    const Real across = sqrt(center_squared - along * along / length_squared);
    const Real distance = abs(across - Real(sphere.radius)) / sqrt(center_squared);
    exact.margin = std::min(exact.margin, static_cast<double>(distance));
    const Real power = center_squared - Real(sphere.radius) * Real(sphere.radius);
    const Real discriminant = along * along - length_squared * power;
    if (discriminant < Real(0)) continue;
    const Real root = sqrt(discriminant);
    const Real near = (along - root) / length_squared;
    const Real t = near > Real(0) ? near : (along + root) / length_squared;
    if (t > Real(0) && t < nearest) {
      nearest = t;
      exact.object = k;
    }
  }
  return exact;
}

/// Spheres all over the screen, their centres no format's numbers, at distances apart from each other.
Scene spheres_in_view(double degrees) {
  Random random(51);
  Scene scene = empty_scene(1, 1, 1);
  scene.camera.screen = screen_of(degrees);
  const double half = size / 2 * scene.camera.screen.dy;
  for (int k = 0; k < 12; ++k) {
    const glm::dvec3 direction(1, random.uniform(-half, half), random.uniform(-half, half));
    const double distance = 10 + 5 * k;
    const glm::dvec3 center = direction * (distance / std::sqrt(dot(direction, direction)));
    scene.objects.push_back(object(Sphere{center, std::min(2.0, distance * half * random.uniform(0.05, 0.3))}));
  }
  return scene;
}

/// Each corner of the screen's pixels, in formats that tell them apart, sees what it must: what the oracle sees along
/// the same view vector, but where that passes a sphere's outline by less than 8 roundings of the distance. Formats in
/// which that is more than a pixel have no picture of such a view: the rounding of centres moves spheres by as much.
void expect_as_the_oracle(double degrees) {
  const Scene scene = spheres_in_view(degrees);
  for (const NumberFormat& format : number_formats()) {
    SCOPED_TRACE(format.name());
    const double roundings = std::ldexp(8, -format.significand_bits);
    if (format.kind == NumberKind::fixed || roundings > scene.camera.screen.dy) continue;
    const auto intersector = make_intersector(scene, format);
    const ViewVectors view_vectors(scene.camera.screen, 1, format);
    int hits = 0;
    int doubtful = 0;
    for (std::uint32_t row = 0; row <= size; row += 2) {
      for (std::uint32_t column = 0; column <= size; column += 2) {
        const glm::dvec3 v = view_vectors({row, column});
        Work work;
        const auto seen = intersector->intersect(v, work).seen.object;
        const Exact exact = nearest_sphere(scene, v);
        if (exact.margin < roundings) {
          ++doubtful;
          continue;
        }
        ASSERT_EQ(seen, exact.object) << row << " " << column << " " << exact.margin;
        hits += seen == no_object ? 0 : 1;
      }
    }
    print_figure(fmt::format("{} degrees", degrees), format, fmt::format("{} hits, {} doubtful", hits, doubtful));
    EXPECT_GE(hits, 10);
  }
}

TEST(ExtremesFieldOfView, AThousandthOfADegree) { expect_as_the_oracle(0.001); }
TEST(ExtremesFieldOfView, OneHundredAndSeventyNineDegrees) { expect_as_the_oracle(179); }

/// A sphere that fills the view, from outside, nearly touching, and from inside: every pixel is its color, unsplit.
TEST(ExtremesFieldOfView, ASphereThatFillsIt) {
  for (const auto& [degrees, sphere] : {std::pair(0.001, Sphere{{1e5, 0, 0}, 10}),
                                        {60.0, Sphere{{100, 0, 0}, 90}},
                                        {179.0, Sphere{{100, 0, 0}, 99.999}},
                                        {179.0, Sphere{{1, 0.5, 0}, 3}}}) {
    Scene scene = empty_scene(1, 1, 1);
    scene.camera.screen = screen_of(degrees);
    scene.objects = {object(sphere, {0.25, 0.5, 1})};
    for (const NumberFormat& format : number_formats()) {
      if (format.kind == NumberKind::fixed || format.significand_bits < 17) continue;
      const Rendering rendering =
          render_pyramids(scene, *make_intersector(scene, format), {.threads = 1, .view_vectors = format});
      EXPECT_EQ(rendering.statistics.subdivisions, 0U) << degrees << " " << format.name();
      EXPECT_EQ(rendering.image.at(0, 0), glm::vec3(0.25, 0.5, 1)) << degrees << " " << format.name();
    }
  }
}

}  // namespace
}  // namespace pyrasim
