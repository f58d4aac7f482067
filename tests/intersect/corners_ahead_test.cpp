// SPDX-License-Identifier: Apache-2.0
#include "intersect/corners_ahead.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <numeric>
#include <random>
#include <thread>

#include "../test_scenes.h"

namespace pyrasim {
namespace {

/// All corners of a raster, each once, within `out_of_order` of the raster's order.
std::vector<std::size_t> nearly_in_order(std::size_t corners, std::size_t out_of_order, std::mt19937_64& random) {
  std::vector<std::size_t> order(corners);
  std::iota(order.begin(), order.end(), 0U);
  for (std::size_t k = 0; k < corners; k += out_of_order + 1) {
    const std::size_t end = std::min(k + out_of_order + 1, corners);
    std::shuffle(order.begin() + static_cast<std::ptrdiff_t>(k), order.begin() + static_cast<std::ptrdiff_t>(end),
                 random);
  }
  return order;
}

TEST(CornersAhead, AreThoseOfTheTracerInWhateverOrder) {
  std::mt19937_64 random(1);
  for (const PixelWindow& window : std::vector<PixelWindow>{
           {0, 0, 1, 1}, {0, 0, 1, 300}, {0, 0, 300, 1}, {0, 0, 33, 41}, {0, 0, 5000, 6}, {17, 23, 33, 41}}) {
    for (const std::size_t out_of_order : {0, 1, 7, 200}) {
      const auto& [left, top, columns, rows] = window;
      Scene scene = random_scene(3, {20, 20, 1, 10, 10, 10}, 2 * left + columns, 2 * top + rows);
      if (out_of_order == 7) scene = under_lights(std::move(scene), random);
      constexpr std::uint32_t steps = 8;
      const auto intersector = make_intersector(scene);
      const ViewVectors view_vectors(scene.camera.screen, steps);
      CornersAhead ahead(*intersector, view_vectors, window, steps, out_of_order);
      const auto width = static_cast<std::size_t>(columns) + 1;
      for (const std::size_t corner :
           nearly_in_order(width * (static_cast<std::size_t>(rows) + 1), out_of_order, random)) {
        const GridPoint point{(static_cast<std::uint32_t>(top) + static_cast<std::uint32_t>(corner / width)) * steps,
                              (static_cast<std::uint32_t>(left) + static_cast<std::uint32_t>(corner % width)) * steps};
        const glm::dvec3 view_vector = view_vectors(point);
        Work work;
        Work expected_work;
        const Sample sample = ahead.trace(point, view_vector, work);
        ASSERT_EQ(sample, intersector->intersect(view_vector, expected_work))
            << columns << "x" << rows << " " << corner;
        ASSERT_EQ(work, expected_work) << columns << "x" << rows << " " << corner;
      }
    }
  }
}

/// Counts the rays of another intersector.
class CountingTracer final : public Intersector {
 public:
  explicit CountingTracer(const Scene& scene) : intersector_(make_intersector(scene)) {}
  Sample intersect(const glm::dvec3& view_vector, Work& work) const override {
    ++rays_;
    return intersector_->intersect(view_vector, work);
  }
  SceneContents contents() const override { return intersector_->contents(); }
  std::size_t rays() const { return rays_; }

 private:
  std::unique_ptr<Intersector> intersector_;
  mutable std::atomic<std::size_t> rays_{0};
};

/// Given time, the thread has traced all rows but the first, wherever the window lies; nobody traces them again. Its
/// last row may still lack its number.
TEST(CornersAhead, SpareWhoAsksHisRays) {
  const Scene scene = random_scene(3, {5, 5, 0}, 200, 100);
  for (const PixelWindow& window : std::vector<PixelWindow>{{0, 0, 20, 30}, {150, 60, 20, 30}}) {
    const CountingTracer intersector(scene);
    const ViewVectors view_vectors(scene.camera.screen, 1);
    CornersAhead ahead(intersector, view_vectors, window, 1, 0);
    while (intersector.rays() < std::size_t{30} * 21) std::this_thread::yield();
    for (std::uint32_t corner = 0; corner < 31 * 21; ++corner) {
      const GridPoint point = {static_cast<std::uint32_t>(window.row) + corner / 21,
                               static_cast<std::uint32_t>(window.column) + corner % 21};
      Work work;
      ahead.trace(point, view_vectors(point), work);
    }
    EXPECT_LE(intersector.rays(), 32U * 21);
  }
}

TEST(CornersAhead, CanBeLeftAtAnyTime) {
  const Scene scene = random_scene(3, {5, 5, 0}, 640, 480);
  const auto intersector = make_intersector(scene);
  const ViewVectors view_vectors(scene.camera.screen, 1);
  for (std::uint32_t asked = 0; asked < 20; ++asked) {
    CornersAhead ahead(*intersector, view_vectors, scene.camera.rendered(), 1, 0);
    for (std::uint32_t column = 0; column < asked; ++column) {
      Work work;
      ahead.trace({0, column}, view_vectors({0, column}), work);
    }
  }
}

}  // namespace
}  // namespace pyrasim
