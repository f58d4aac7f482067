// SPDX-License-Identifier: Apache-2.0
#include "image/image_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "error.h"
#include "image/png.h"

namespace pyrasim {
namespace {

double difference(double a, double b) {
  if (a == b) return 0;  // equal infinities too
  const double distance = std::fabs(a - b);
  return std::isnan(distance) ? std::numeric_limits<double>::infinity() : distance;
}

}  // namespace

void check_same_size(const Image& a, const Image& b) {
  if (a.columns() == b.columns() && a.rows() == b.rows()) return;
  throw UsageError(fmt::format("{}x{} and {}x{}: pictures can be compared only where their sizes are the same",
                               a.columns(), a.rows(), b.columns(), b.rows()));
}

ImageError image_error(const Image& image, const Image& reference) {
  check_same_size(image, reference);
  ImageError error;
  double sum = 0;
  for (std::size_t i = 0; i < image.pixels().size(); ++i) {
    for (int channel = 0; channel < 3; ++channel) {
      const double distance = difference(image.pixels()[i][channel], reference.pixels()[i][channel]);
      sum += distance * distance;
      error.maximum = std::max(error.maximum, distance);
    }
  }
  if (!image.pixels().empty()) error.rmse = std::sqrt(sum / (3.0 * static_cast<double>(image.pixels().size())));
  return error;
}

std::uint64_t changed_pixels(const Image& image, const Image& reference) {
  check_same_size(image, reference);
  std::uint64_t changed = 0;
  for (std::size_t i = 0; i < image.pixels().size(); ++i) {
    const glm::vec3& a = image.pixels()[i];
    const glm::vec3& b = reference.pixels()[i];
    if (a == b) continue;
    const auto differs = [](float x, float y) { return png_sample(x, {}) != png_sample(y, {}); };
    if (differs(a.r, b.r) || differs(a.g, b.g) || differs(a.b, b.b)) ++changed;
  }
  return changed;
}

double psnr(const Image& image, const Image& reference) {
  return -20.0 * std::log10(image_error(image, reference).rmse);
}

}  // namespace pyrasim
