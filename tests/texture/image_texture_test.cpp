// SPDX-License-Identifier: Apache-2.0
#include "texture/image_texture.h"

#include <gtest/gtest.h>

#include "clipped_area.h"

namespace pyrasim {
namespace {

Image random_image(int columns, int rows) {
  Random random(17);
  Image image(columns, rows);
  for (glm::vec3& pixel : image.pixels()) {
    for (int k = 0; k < 3; ++k) pixel[k] = static_cast<float>(random.uniform(0, 1));
  }
  return image;
}

glm::dvec3 mean(const ImageTexture& texture, const Footprint& footprint) {
  TextureWork work;
  return texture.mean(footprint, work);
}

/// Of texel (i, j), from below.
double green(const Image& image, Wrap wrap, double i, double j) {
  const auto within = [&](double index, int count) {
    if (wrap == Wrap::repeat) return static_cast<int>(index - count * std::floor(index / count));
    return static_cast<int>(std::clamp(index, 0.0, count - 1.0));
  };
  return image.at(image.rows() - 1 - within(j, image.rows()), within(i, image.columns())).y;
}

TEST(ImageTexture, MeansAreThoseOfTexelsByTheirArea) {
  const Image image = random_image(7, 5);
  Random random(6);
  for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
    const ImageTexture texture(image, wrap);
    for (const double size : {1e-4, 0.05, 0.3, 1.0, 4.0, 20.0}) {
      for (int k = 0; k < 100; ++k) {
        const TexturePoint place{random.uniform(-2, 3), random.uniform(-2, 3)};
        const Footprint footprint = random_footprint(random, place, size);
        Footprint texels = footprint;
        for (auto& texel : texels) texel = {texel.u * 7, texel.v * 5};
        const double expected = mean_by_cells(texels, [&](double i, double j) { return green(image, wrap, i, j); });
        ASSERT_NEAR(mean(texture, footprint).y, expected, 1e-9) << size << ' ' << k << ' ' << static_cast<int>(wrap);
      }
    }
  }
}

TEST(ImageTexture, LiesUprightFromItsLowerLeftCorner) {
  Image image(2, 2);
  image.at(0, 0) = {1, 0, 0};  // upper left
  image.at(1, 1) = {0, 1, 0};  // lower right
  const ImageTexture repeated(image, Wrap::repeat);
  EXPECT_EQ(repeated.at({0.25, 0.75}), glm::dvec3(1, 0, 0));
  EXPECT_EQ(repeated.at({0.75, 0.25}), glm::dvec3(0, 1, 0));
  EXPECT_EQ(repeated.at({-0.75, 3.75}), glm::dvec3(1, 0, 0));
  const ImageTexture clamped(image, Wrap::clamp);
  EXPECT_EQ(clamped.at({-9, 9}), glm::dvec3(1, 0, 0));
  EXPECT_EQ(clamped.at({9, -9}), glm::dvec3(0, 1, 0));
}

TEST(ImageTexture, TheSmallestAndTheFarthest) {
  Image one(1, 1);
  one.at(0, 0) = {0.25, 0.5, 0.75};
  for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
    const ImageTexture texture(one, wrap);
    EXPECT_EQ(mean(texture, {{{0.1, 0.1}, {0.2, 0.1}, {0.2, 0.2}, {0.1, 0.2}}}), glm::dvec3(0.25, 0.5, 0.75));
    const glm::dvec3 over = mean(texture, {{{-3.5, -2.5}, {4.5, -2.5}, {4.5, 9}, {-3.5, 9}}});
    EXPECT_NEAR(over.y, 0.5, 1e-12);
  }
  const ImageTexture repeated(random_image(8, 8), Wrap::repeat);
  EXPECT_EQ(mean(repeated, {{{0, 0}, {1e9, 0}, {1e9, 1e9}, {0, 1e9}}}), repeated.mean());
  // A border has no lines beyond the picture.
  Image border(2, 1);
  border.at(0, 1) = {1, 1, 1};
  const ImageTexture clamped(border, Wrap::clamp);
  EXPECT_NEAR(mean(clamped, {{{-1e9, 0}, {1e9 + 1, 0}, {1e9 + 1, 1}, {-1e9, 1}}}).x, 0.5, 1e-9);
  TextureWork work;
  clamped.mean({{{-1e9, -5}, {1e9, 5}, {1e9, 1e9}, {-1e9, 1e9}}}, work);
  EXPECT_LT(work.texels, 20U);
}

}  // namespace
}  // namespace pyrasim
