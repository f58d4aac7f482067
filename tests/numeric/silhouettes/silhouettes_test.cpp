// SPDX-License-Identifier: Apache-2.0
// What every number format sees of the shipped scenes, against what there is to see: a ray that comes back with another
// object than the oracle's has to have run so close to a silhouette that the format's error bound reaches it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <ostream>

#include "../../shipped_scene.h"
#include "differences.h"
#include "error.h"
#include "intersect/datapath_formats.h"
#include "intersect/rounded_scene.h"
#include "numeric/number_types.h"

namespace pyrasim::silhouettes {
namespace {

constexpr int max_level = 3;

struct ShippedScene {
  const char* name;
  int columns, rows;
  friend void PrintTo(const ShippedScene& scene, std::ostream* out) { *out << scene.name; }
};

Scene load(const ShippedScene& shipped) {
  Scene scene = shipped_scene(shipped.name);
  scene.camera.screen = resized(scene.camera.screen, shipped.columns, shipped.rows);
  return scene;
}

/// Whether a machine with this datapath is refused, because it cannot address the screen.
bool refused(const NumberFormat& format, const Screen& screen) {
  try {
    check_addressing({format, format}, screen, std::int64_t{1} << max_level);
    return false;
  } catch (const UsageError&) {
    return true;
  }
}

class Silhouettes : public testing::TestWithParam<ShippedScene> {};

/// Also prints, for each format, how many rays and pyramids of the frame differ, and the largest error as a part of its
/// bound, in the frame and by its outline.
TEST_P(Silhouettes, DifferOnlyWithinTheErrorBound) {
  const Scene scene = load(GetParam());
  Oracle oracle(scene, max_level);
  int left_out = 0;
  fmt::print("{:10}{:>8}{:>8}{:>10}{:>8}{:>8}{:>9}\n", GetParam().name, "rays", "differ", "pyramids", "differ", "error",
             "outline");
  for (const NumberFormat& format : number_formats()) {
    if (refused(format, scene.camera.screen)) {
      ++left_out;
      continue;
    }
    const auto intersector = make_intersector(scene, format);
    const FrameDifferences frame = differences_in_frame(*intersector, format, oracle);
    const Differences outline = differences_by_outline(*intersector, format, oracle);
    fmt::print("{:10}{:>8}{:>8}{:>10}{:>8}{:>8.3f}{:>9.3f}\n", format.name(), frame.rays.all, frame.rays.different,
               frame.pyramids, frame.different_pyramids, frame.rays.largest_error, outline.largest_error);
    RecordProperty(format.name() + "_rays", std::to_string(frame.rays.different));
    RecordProperty(format.name() + "_pyramids", std::to_string(frame.different_pyramids));
    EXPECT_EQ(frame.rays.unexplained, 0) << format.name() << '\n' << frame.rays.first_unexplained;
    EXPECT_EQ(outline.unexplained, 0) << format.name() << '\n' << outline.first_unexplained;
    EXPECT_GT(outline.largest_error, 0.1) << format.name() << ": a tenth of the bound would do";
  }
  RecordProperty("refused_formats", std::to_string(left_out));
}

/// The oracle decides in double where that is beyond doubt.
TEST_P(Silhouettes, OfTheOracleAreThoseOfRealNumbers) {
  const Scene scene = load(GetParam());
  Oracle oracle(scene, max_level);
  const auto& [columns, rows] = std::pair(GetParam().columns << max_level, GetParam().rows << max_level);
  for (std::uint32_t k = 0; k < 500; ++k) {
    const GridPoint point{k * 7919 % static_cast<std::uint32_t>(rows),
                          k * 104729 % static_cast<std::uint32_t>(columns)};
    EXPECT_EQ(oracle.object(point), object_seen_in_real(oracle.scene(), oracle.ray(point)))
        << point.row << ' ' << point.column;
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Silhouettes,
                         testing::Values(ShippedScene{"keel", 64, 48}, ShippedScene{"spheres", 64, 48},
                                         ShippedScene{"fins", 64, 48}, ShippedScene{"bunny", 24, 18},
                                         ShippedScene{"blocks", 64, 48}, ShippedScene{"quadrics", 64, 48},
                                         ShippedScene{"tori", 64, 48}, ShippedScene{"crystals", 64, 48}),
                         [](const auto& tested) { return std::string(tested.param.name); });

/// Spheres by the textbook's b^2 - 4ac, which cancels.
template <class Scalar>
class TextbookSpheres final : public Intersector {
 public:
  explicit TextbookSpheres(const Scene& scene) : scene_(rounded<Scalar>(prepare_scene(scene, format_of<Scalar>()))) {}

  Sample intersect(const glm::dvec3& view_vector, Work&) const override {
    const FormatScope<Scalar> scope(scene_.numbers);
    const auto d = to_scalar<Scalar>(view_vector);
    Scalar nearest = std::numeric_limits<Scalar>::infinity();
    Sample sample;
    for (const auto& sphere : surfaces_of<SphereSurface>(scene_)) {
      const Scalar a = dot(d, d);
      const Scalar b = Scalar(2) * dot(d, sphere.center);
      const Scalar discriminant = b * b - Scalar(4) * a * (dot(sphere.center, sphere.center) - sphere.radius_squared);
      if (discriminant < Scalar(0)) continue;
      const Scalar t = (b - sqrt(discriminant)) / (Scalar(2) * a);
      if (!(t > Scalar(0) && t < nearest)) continue;
      nearest = t;
      sample.seen.object = sphere.identity.object;
    }
    return sample;
  }
  SceneContents contents() const override { return {}; }

 private:
  PreparedScene<Scalar> scene_;
};

TEST(SilhouettesOfTextbookSpheres, AreNotExplained) {
  const Scene scene = load({"spheres", 64, 48});
  Oracle oracle(scene, max_level);
  const NumberFormat format = NumberFormat::floating(8, 16);
  const FormatScope<Flt> scope(format);
  const TextbookSpheres<Flt> intersector(scene);
  EXPECT_GT(differences_in_frame(intersector, format, oracle).rays.unexplained, 10);
}

}  // namespace
}  // namespace pyrasim::silhouettes
