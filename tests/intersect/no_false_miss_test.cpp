// SPDX-License-Identifier: Apache-2.0
// What the hierarchy finds is what testing every surface finds, on scenes made to provoke a false miss.
#include <gtest/gtest.h>

#include <random>

#include "../numeric/ties/every_hit.h"
#include "error.h"
#include "intersect/datapath_formats.h"
#include "intersect/scene_intersector.h"

namespace pyrasim {
namespace {

class Provocation {
 public:
  explicit Provocation(std::uint64_t seed) : random_(seed) {
    screen_.columns = 64;
    screen_.rows = 48;
    screen_.dx = power(-10, 10);
    slope_ = power(-12, 6);  // from a hair to nearly 180 degrees
    screen_.dz = screen_.dy = 2 * screen_.dx * slope_ / 64;
    scene_.camera.screen = screen_;
    const double scale = power(-20, 20);
    for (auto k = 1 + random_() % 40; k > 0; --k) {
      const double distance = scale * power(-3, 12);
      scene_.objects.push_back({"", {1, 1, 1}, Sphere{}});
      if (random_() % 4 == 0) {
        scene_.objects.back().surface = triangle(distance);
      } else {
        scene_.objects.back().surface = sphere(distance);
      }
    }
  }

  const Scene& scene() const { return scene_; }

  /// Anywhere on the screen, its border and its axes included.
  glm::dvec3 view_vector() {
    const double half_y = 24 * screen_.dy;
    const double half_z = 32 * screen_.dz;
    const auto side = random_() % 8;
    const double y = side == 0 ? 0 : side == 2 ? half_y : uniform(-half_y, half_y);
    const double z = side == 1 ? 0 : side == 3 ? -half_z : uniform(-half_z, half_z);
    return {screen_.dx, y, z};
  }

  /// Through a point of the sphere's outline, a few roundings `epsilon` in or out.
  glm::dvec3 graze(const glm::dvec3& center, double radius, double epsilon) {
    const double squared = dot(center, center);
    const glm::dvec3 random(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
    const glm::dvec3 across = random - center * (dot(random, center) / squared);
    const double tangent = radius * std::sqrt(1 - radius * radius / squared) * (1 + uniform(-4, 4) * epsilon);
    const glm::dvec3 point =
        center * (1 - radius * radius / squared) + across * (tangent / std::sqrt(dot(across, across)));
    return point * (screen_.dx / point.x);
  }

 private:
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  double power(double low, double high) { return std::exp2(uniform(low, high)); }
  double sign() { return random_() % 2 == 0 ? -1 : 1; }

  glm::dvec3 somewhere(double distance) {
    return glm::dvec3(uniform(-0.3, 1), uniform(-1.2, 1.2) * slope_, uniform(-1.2, 1.2) * slope_) * distance;
  }

  /// Small, large, touching the observer or the plane beside him (nearly or exactly), or around everything.
  Sphere sphere(double distance) {
    const glm::dvec3 center = somewhere(distance);
    const double away = std::sqrt(dot(center, center));
    switch (random_() % 6) {
      case 0:
        return {center, away * power(-20, 0)};
      case 1:
        return {center, away * (1 + power(-30, -2) * sign())};
      case 2:
        return {center, std::abs(center.x) * (1 + power(-50, -2) * sign())};
      case 3:
        return {center, away * power(0, 10)};
      case 4:
        return {center, std::abs(center.x)};
      default:
        return {center, away * power(-6, -1)};
    }
  }

  /// Some with a vertex beside or behind the observer.
  Triangle triangle(double distance) {
    const glm::dvec3 middle = somewhere(distance);
    const double size = distance * power(-10, 2);
    Triangle triangle;
    for (glm::dvec3& vertex : triangle.vertices) {
      vertex = middle + glm::dvec3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)) * size;
    }
    if (random_() % 4 == 0) triangle.vertices[0].x = 0;
    if (random_() % 4 == 0) triangle.vertices[1].x *= -1;
    return triangle;
  }

  std::mt19937_64 random_;
  Screen screen_;
  double slope_ = 1;  ///< of the screen's border
  Scene scene_;
};

template <class Scalar>
void expect_no_false_miss(std::uint64_t seed) {
  Provocation provocation(seed);
  const SceneIntersector<Scalar> intersector(provocation.scene());
  const auto every_hit = make_every_hit(provocation.scene(), format_of<Scalar>());
  const auto& spheres = surfaces_of<SphereSurface>(intersector.scene());
  for (std::size_t k = 0; k < 600; ++k) {
    glm::dvec3 view_vector = provocation.view_vector();
    if (k % 2 == 0 && !spheres.empty()) {
      const auto& sphere = spheres[k % spheres.size()];
      const double radius = static_cast<double>(sphere.radius);
      const glm::dvec3 grazing =
          provocation.graze(glm::dvec3(sphere.center), radius, static_cast<double>(epsilon<Scalar>()));
      if (std::abs(grazing.y) <= std::abs(view_vector.y) && std::abs(grazing.z) <= std::abs(view_vector.z)) {
        view_vector = grazing;  // on the screen; none where the observer is inside
      }
    }
    const auto direction = to_scalar<Scalar>(view_vector / view_vector.x);
    Work work;
    ASSERT_EQ(intersector.intersect(direction, work).seen.object, object_seen(every_hit->of(direction))) << "ray " << k;
  }
}

void expect_no_false_miss(std::uint64_t seed, const NumberFormat& format) {
  SCOPED_TRACE(format.name() + ", seed " + std::to_string(seed));
  with_number_type(format, [seed]<class Scalar>(std::type_identity<Scalar>) { expect_no_false_miss<Scalar>(seed); });
}

TEST(Hierarchy, NeverMissesWhatTestingEverySurfaceHits) {
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    for (const NumberFormat& format : {NumberFormat(), NumberFormat::single(), fp24, tf32, bf16}) {
      expect_no_false_miss(seed, format);
    }
  }
}

/// Formats of any widths, as long as a machine with them is not refused.
TEST(Hierarchy, NorInRandomFormats) {
  std::mt19937_64 random(12);
  const auto draw = [&](int first, int last) { return std::uniform_int_distribution(first, last)(random); };
  int tested = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    const int bits = draw(min_fixed_bits, max_fixed_bits);
    const NumberFormat format = seed % 2 == 0
                                    ? NumberFormat::fixed(bits, draw(0, bits - 1))
                                    : NumberFormat::floating(draw(min_exponent_bits, max_exponent_bits),
                                                             draw(min_significand_bits, max_significand_bits));
    try {
      check_addressing({format, format}, Provocation(seed).scene().camera.screen, 1);
    } catch (const UsageError&) {
      continue;
    }
    ++tested;
    expect_no_false_miss(seed, format);
  }
  EXPECT_GT(tested, 150);
}

}  // namespace
}  // namespace pyrasim
