// SPDX-License-Identifier: Apache-2.0
// What the tests of extremes share: every number format in turn, figures for the documentation, pictures.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

#include "../../test_scenes.h"
#include "numeric/number_types.h"
#include "render/pyramid_renderer.h"

namespace pyrasim {

/// visit.operator()<Scalar>() in each format of number_formats(), for the type that computes in it.
template <class Visit>
void for_every_format(const Visit& visit) {
  for (const NumberFormat& format : number_formats()) {
    SCOPED_TRACE(format.name());
    with_number_type(format, [&]<class Scalar>(std::type_identity<Scalar>) { visit.template operator()<Scalar>(); });
  }
}

template <class Scalar>
constexpr bool is_floating = !std::is_same_v<Scalar, Fix>;
template <class Scalar>
int significand_bits() {
  return format_of<Scalar>().significand_bits;
}

/// `x` rounded to the format, held in double: scenes made of such numbers reach the datapath unchanged.
template <class Scalar>
double as_held(double x) {
  return static_cast<double>(static_cast<Scalar>(x));
}

/// A line for the table of docs/numerics.md.
inline void print_figure(const std::string& what, const NumberFormat& format, const std::string& figure) {
  fmt::print("[  figure  ] {}, {}: {}\n", what, format.name(), figure);
  std::fflush(stdout);
}

/// Errors in units of the last place, and what is said of them.
class Errors {
 public:
  void add(double error) { errors_.push_back(error); }
  std::size_t count() const { return errors_.size(); }
  double largest() const { return quantile(1); }
  double p99() const { return quantile(0.99); }
  std::string text() const { return fmt::format("p99 {:.2f} ulp, max {:.2f} ulp of {}", p99(), largest(), count()); }

 private:
  double quantile(double share) const {
    if (errors_.empty()) return 0;
    auto sorted = errors_;
    std::sort(sorted.begin(), sorted.end());
    return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
  }
  std::vector<double> errors_;
};

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  std::uint64_t below(std::uint64_t end) { return engine_() % end; }
  glm::dvec3 vector(double low, double high) { return random_vector(engine_, glm::dvec3(low), glm::dvec3(high)); }
  glm::dvec3 unit_vector() {
    for (;;) {
      const glm::dvec3 v = vector(-1, 1);
      const double squared = dot(v, v);
      if (squared > 1e-4 && squared < 1) return v / std::sqrt(squared);
    }
  }

 private:
  std::mt19937_64 engine_;
};

/// The scene's picture with view vectors and intersections in one format.
inline Image picture(const Scene& scene, const NumberFormat& format, int max_level = 2, int threads = 1) {
  return render_pyramids(scene, *make_intersector(scene, format),
                         {.max_level = max_level, .threads = threads, .view_vectors = format})
      .image;
}

}  // namespace pyrasim
