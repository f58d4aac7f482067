// SPDX-License-Identifier: Apache-2.0
// Windows of a screen, and scenes that show something in them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/vec2.hpp>
#include <random>
#include <vector>

#include "image/image.h"
#include "test_scenes.h"

namespace pyrasim {

inline Scene seen_through(Scene scene, const PixelWindow& window) {
  scene.camera.window = window;
  return scene;
}

inline PixelWindow random_window(std::mt19937_64& random, const Screen& screen) {
  const auto below = [&](int limit) { return static_cast<int>(random() % static_cast<std::uint64_t>(limit)); };
  const int column = below(screen.columns);
  const int row = below(screen.rows);
  return {column, row, 1 + below(screen.columns - column), 1 + below(screen.rows - row)};
}

/// The pixels that two windows of one screen share are the same, bit for bit; and there are some.
inline void expect_same_pixels(const Image& a, const PixelWindow& at_a, const Image& b, const PixelWindow& at_b) {
  const int right = std::min(at_a.column + at_a.columns, at_b.column + at_b.columns);
  const int bottom = std::min(at_a.row + at_a.rows, at_b.row + at_b.rows);
  int shared = 0;
  for (int row = std::max(at_a.row, at_b.row); row < bottom; ++row) {
    for (int column = std::max(at_a.column, at_b.column); column < right; ++column) {
      ASSERT_EQ(a.at(row - at_a.row, column - at_a.column), b.at(row - at_b.row, column - at_b.column))
          << "row " << row << ", column " << column;
      ++shared;
    }
  }
  EXPECT_GT(shared, 0);
}

/// The point of a screen of empty_scene() at `row`, `column`, in pixels from its upper left corner.
inline glm::dvec3 on_screen(const Screen& screen, double row, double column) {
  return {1, (screen.rows / 2.0 - row) * screen.dy, (column - screen.columns / 2.0) * screen.dz};
}

/// A triangle that fills most of the 8 x 8 pixels from `row`, `column` on.
inline Object triangle_at(const Screen& screen, int row, int column) {
  const auto vertex = [&](double down, double right) { return on_screen(screen, row + down, column + right); };
  return object(Triangle{{vertex(1.3, 1.1), vertex(2.9, 6.7), vertex(6.4, 2.2)}});
}

/// All that lies to the left of an upright edge at `column`.
inline Object left_of(const Screen& screen, double column) {
  const double z = on_screen(screen, 0, column).z;
  return object(Triangle{{{{1, -900, z}, {1, 900, z}, {1, 0, -900}}}});
}

/// 8 x 8 pixels in the corners and the middle of a screen of 16384 x 16384, each with a triangle in it.
struct LargeScreen {
  Scene scene = empty_scene(16384, 16384, 1.0 / 16384);
  std::vector<PixelWindow> windows{
      {0, 0, 8, 8}, {16376, 0, 8, 8}, {0, 16376, 8, 8}, {16376, 16376, 8, 8}, {8188, 8188, 8, 8}};

  LargeScreen() {
    for (const PixelWindow& window : windows) {
      scene.objects.push_back(triangle_at(scene.camera.screen, window.row, window.column));
    }
  }
};

}  // namespace pyrasim
