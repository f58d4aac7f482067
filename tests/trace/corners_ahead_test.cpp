// SPDX-License-Identifier: Apache-2.0
#include "trace/corners_ahead.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "../test_scenes.h"

namespace pyrasim {
namespace {

/// All corners of a screen, each once, within `out_of_order` of the raster's order.
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
  for (const auto& [columns, rows] : {std::pair{1, 1}, {1, 300}, {300, 1}, {33, 41}, {5000, 6}}) {
    for (const std::size_t out_of_order : {0, 1, 7, 200}) {
      const Scene scene = random_scene(3, {20, 20, 1}, columns, rows);
      constexpr std::uint32_t steps = 8;
      const auto tracer = make_tracer(scene);
      const ViewVectors view_vectors(scene.camera.screen, steps);
      CornersAhead ahead(*tracer, view_vectors, scene.camera.screen, steps, out_of_order);
      const auto width = static_cast<std::size_t>(columns) + 1;
      for (const std::size_t corner :
           nearly_in_order(width * (static_cast<std::size_t>(rows) + 1), out_of_order, random)) {
        const GridPoint point{static_cast<std::uint32_t>(corner / width) * steps,
                              static_cast<std::uint32_t>(corner % width) * steps};
        const glm::dvec3 view_vector = view_vectors(point);
        Work work;
        Work expected_work;
        const Sample sample = ahead.trace(point, view_vector, work);
        ASSERT_EQ(sample, tracer->trace(view_vector, expected_work)) << columns << "x" << rows << " " << corner;
        ASSERT_EQ(work, expected_work) << columns << "x" << rows << " " << corner;
      }
    }
  }
}

TEST(CornersAhead, CanBeLeftAtAnyTime) {
  const Scene scene = random_scene(3, {5, 5, 0}, 640, 480);
  const auto tracer = make_tracer(scene);
  const ViewVectors view_vectors(scene.camera.screen, 1);
  for (std::uint32_t asked = 0; asked < 20; ++asked) {
    CornersAhead ahead(*tracer, view_vectors, scene.camera.screen, 1, 0);
    for (std::uint32_t column = 0; column < asked; ++column) {
      Work work;
      ahead.trace({0, column}, view_vectors({0, column}), work);
    }
  }
}

}  // namespace
}  // namespace pyrasim
