// SPDX-License-Identifier: Apache-2.0
// Each thread's numbers are of the format that it set last, and each scene is traced in its own.
#include "numeric/format_scope.h"

#include <gtest/gtest.h>

#include <barrier>
#include <thread>

#include "../error_of.h"
#include "../test_scenes.h"
#include "camera/view_vector.h"
#include "intersect/intersector.h"

namespace pyrasim {
namespace {

const double third = 1.0 / 3;

double third_in_floating_point() { return static_cast<double>(Flt(1) / Flt(3)); }
double third_in_fixed_point() { return static_cast<double>(Fix(1) / Fix(3)); }

/// 1 / 3, which lies between 2^-2 and 2^-1, to so many bits.
double third_of(int significand_bits) {
  return std::ldexp(std::nearbyint(std::ldexp(third, significand_bits + 1)), -significand_bits - 1);
}

TEST(FormatScope, ScopesNestAndTheTypesDoNotDisturbEachOther) {
  const FormatScope<Flt> outer(bf16);
  const FormatScope<Fix> fixed(NumberFormat::fixed(16, 4));
  EXPECT_EQ(third_in_floating_point(), third_of(8));
  {
    const FormatScope<Flt> inner(NumberFormat::floating(5, 20));
    EXPECT_EQ(third_in_floating_point(), third_of(20));
    EXPECT_EQ(format_of<Flt>(), NumberFormat::floating(5, 20));
    EXPECT_EQ(third_in_fixed_point(), 5.0 / 16);
    const FormatScope<Fix> wider(NumberFormat::fixed(16, 8));
    EXPECT_EQ(third_in_fixed_point(), 85.0 / 256);
  }
  EXPECT_EQ(format_of<Flt>(), bf16);
  EXPECT_EQ(third_in_floating_point(), third_of(8));
  EXPECT_EQ(third_in_fixed_point(), 5.0 / 16);
}

TEST(FormatScope, EndsWithAnException) {
  const FormatScope<Flt> outer(fp16);
  EXPECT_THROW(
      {
        const FormatScope<Flt> inner(fp24);
        throw std::runtime_error("");
      },
      std::runtime_error);
  EXPECT_EQ(format_of<Flt>(), fp16);
}

TEST(FormatScope, WithoutOneNothingIsComputed) {
  std::thread([] {
    const std::string floating = "Flt computes without a format: no FormatScope<Flt>";
    EXPECT_EQ(error_of<std::logic_error>([] { Flt(0.5); }), floating);
    EXPECT_EQ(error_of<std::logic_error>([] { Flt(1) + Flt(1); }), floating);
    EXPECT_EQ(error_of<std::logic_error>([] { Flt(1) * Flt(1); }), floating);
    EXPECT_EQ(error_of<std::logic_error>([] { Flt(1) / Flt(1); }), floating);
    EXPECT_EQ(error_of<std::logic_error>([] { sqrt(Flt(1)); }), floating);
    const std::string fixed = "Fix computes without a format: no FormatScope<Fix>";
    EXPECT_EQ(error_of<std::logic_error>([] { Fix(0.5); }), fixed);
    EXPECT_EQ(error_of<std::logic_error>([] { Fix(1); }), fixed);
    EXPECT_EQ(error_of<std::logic_error>([] { Fix::from_raw(1) + Fix::from_raw(1); }), fixed);
    EXPECT_EQ(error_of<std::logic_error>([] { Fix::from_raw(1) * Fix::from_raw(1); }), fixed);
    EXPECT_EQ(error_of<std::logic_error>([] { sqrt(Fix::from_raw(1)); }), fixed);
  }).join();
}

/// Two threads that set a format each before either computes, time and again.
TEST(FormatScope, EachThreadHasItsOwn) {
  std::barrier together(2);
  const auto run = [&](int significand_bits, int fraction_bits) {
    for (int k = 0; k < 1000; ++k) {
      const FormatScope<Flt> floating(NumberFormat::floating(8, significand_bits));
      const FormatScope<Fix> fixed(NumberFormat::fixed(32, fraction_bits));
      together.arrive_and_wait();
      ASSERT_EQ(third_in_floating_point(), third_of(significand_bits));
      ASSERT_EQ(third_in_fixed_point(), std::ldexp(std::nearbyint(std::ldexp(third, fraction_bits)), -fraction_bits));
      together.arrive_and_wait();
    }
  };
  std::thread other(run, 9, 20);
  run(22, 7);
  other.join();
}

std::vector<Sample> traced(const Intersector& intersector, const ViewVectors& view_vectors, const Screen& screen) {
  std::vector<Sample> samples;
  Work work;
  for (std::uint32_t row = 0; row <= static_cast<std::uint32_t>(screen.rows); ++row) {
    for (std::uint32_t column = 0; column <= static_cast<std::uint32_t>(screen.columns); ++column) {
      samples.push_back(intersector.intersect(view_vectors({row, column}), work));
    }
  }
  return samples;
}

/// Scenes in several formats, traced in turns on this thread, then at the same time on one thread each.
TEST(FormatScope, EachIntersectorComputesInItsOwn) {
  const Scene scene = random_scene(3, {12, 12, 1, 6, 6}, 40, 30);
  const Screen& screen = scene.camera.screen;
  struct Datapath {
    std::unique_ptr<Intersector> intersector;
    ViewVectors view_vectors;
    std::vector<Sample> alone{};
  };
  std::vector<Datapath> datapaths;
  for (const char* format : {"e6p13", "e9p22", "fix40.18", "fix60.27", "float", "e6p9"}) {
    const NumberFormat parsed = parse_number_format(format);
    datapaths.push_back({make_intersector(scene, parsed), ViewVectors(screen, 1, parsed)});
    Datapath& datapath = datapaths.back();
    datapath.alone = traced(*datapath.intersector, datapath.view_vectors, screen);
  }
  std::vector<std::thread> threads;
  for (const Datapath& datapath : datapaths) {
    EXPECT_TRUE(traced(*datapath.intersector, datapath.view_vectors, screen) == datapath.alone);
    EXPECT_FALSE(&datapath != datapaths.data() && datapath.alone == datapaths.front().alone);
  }
  for (const Datapath& datapath : datapaths) {
    threads.emplace_back([&] {
      for (int k = 0; k < 5; ++k) {
        EXPECT_TRUE(traced(*datapath.intersector, datapath.view_vectors, screen) == datapath.alone);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
}

}  // namespace
}  // namespace pyrasim
