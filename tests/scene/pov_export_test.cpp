// SPDX-License-Identifier: Apache-2.0
#include "scene/pov_export.h"

#include <gtest/gtest.h>

#include <clocale>
#include <random>
#include <set>

#include "../test_scenes.h"
#include "surface/pov_writer.h"

namespace pyrasim {
namespace {

std::string sphere(const glm::dvec3& center, double radius) {
  PovWriter pov;
  Sphere{center, radius}.write_pov(pov);
  return pov.text();
}

TEST(PovExport, NumbersReadBackAsTheyAre) {
  std::setlocale(LC_ALL, "");
  EXPECT_EQ(sphere({0.1, -2, 1e-30}, 1e30), "sphere { <0.1, -2, 1e-30>, 1e+30 }");
  std::mt19937_64 random(5);
  for (int k = 0; k < 1000; ++k) {
    const double number =
        std::ldexp(std::uniform_real_distribution<double>(1, 2)(random), static_cast<int>(k % 190) - 95);
    const std::string text = sphere(glm::dvec3(0), number);
    EXPECT_EQ(std::strtod(text.c_str() + text.find(">,") + 2, nullptr), number) << text;
  }
}

/// In 8 bits a component, and none is the background.
TEST(PovExport, NumbersOfObjectsHaveColorsOfTheirOwn) {
  std::set<int> seen{0};
  for (std::size_t object = 0; object < 100'000; ++object) {
    int color = 0;
    for (int k = 0; k < 3; ++k) {
      const double level = id_color(object)[k] * 255;
      EXPECT_EQ(level, std::round(level));
      color = 256 * color + static_cast<int>(level);
    }
    EXPECT_TRUE(seen.insert(color).second) << object;
  }
}

/// A name is a comment, whatever it holds.
TEST(PovExport, NamesStayInTheirLine) {
  Scene scene = empty_scene(4, 3, 0.25);
  scene.objects.push_back(object(Sphere{{5, 0, 0}, 1}));
  const std::string plain = pov_scene(scene, false, "remark");
  scene.objects[0].name = "a\n#error */ \r \x80\u2028";
  const std::string named = pov_scene(scene, false, "remark");
  EXPECT_EQ(std::count(named.begin(), named.end(), '\n'), std::count(plain.begin(), plain.end(), '\n'));
  EXPECT_NE(named.find("\n// object 0: a"), std::string::npos);
}

}  // namespace
}  // namespace pyrasim
