// SPDX-License-Identifier: Apache-2.0
#include "texture/image_texture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "texture/simple_footprint.h"

namespace pyrasim {
namespace {

constexpr double most_lines = 1 << 16;  ///< of all four sides, where the picture is repeated
constexpr std::size_t block = 8;  ///< columns between two sums that are kept, so that they take no more than texels

}  // namespace

ImageTexture::ImageTexture(Image image, Wrap wrap) : image_(std::move(image)), wrap_(wrap) {
  const auto columns = static_cast<std::size_t>(image_.columns());
  const auto rows = static_cast<std::size_t>(image_.rows());
  sums_.reserve((columns / block + 1) * rows);
  for (std::size_t row = 0; row < rows; ++row) {
    glm::dvec3 sum(0);
    for (std::size_t column = 0; column < columns; ++column) {
      if (column % block == 0) sums_.push_back(sum);
      sum += texel(row, column);
    }
    if (columns % block == 0) sums_.push_back(sum);
    mean_ += sum;
  }
  mean_ /= static_cast<double>(columns) * static_cast<double>(rows);
}

glm::dvec3 ImageTexture::texel(std::size_t row, std::size_t column) const {
  return image_.at(image_.rows() - 1 - static_cast<int>(row), static_cast<int>(column));
}

glm::dvec3 ImageTexture::sum_before(std::size_t row, std::size_t column) const {
  const std::size_t blocks = static_cast<std::size_t>(image_.columns()) / block + 1;
  glm::dvec3 sum = sums_[row * blocks + column / block];
  for (std::size_t k = column - column % block; k < column; ++k) sum += texel(row, k);
  return sum;
}

double ImageTexture::within(double index, int count) const {
  if (wrap_ == Wrap::repeat) return index - count * std::floor(index / count);
  return std::clamp(index, 0.0, count - 1.0);
}

glm::dvec3 ImageTexture::color(const Texel& of) const {
  return texel(static_cast<std::size_t>(within(of.row, image_.rows())),
               static_cast<std::size_t>(within(of.column, image_.columns())));
}

glm::dvec3 ImageTexture::at(const TexturePoint& place) const {
  return color({std::floor(place.u * image_.columns()), std::floor(place.v * image_.rows())});
}

glm::dvec3 ImageTexture::along_row(double u, double row) const {
  const int columns = image_.columns();
  const auto stored = static_cast<std::size_t>(within(row, image_.rows()));
  const auto sum = [&](double column) { return sum_before(stored, static_cast<std::size_t>(column)); };
  const double column = std::floor(u);
  const glm::dvec3 here = color({column, row});
  if (wrap_ == Wrap::repeat) {
    const double periods = std::floor(column / columns);
    return sum(columns) * periods + sum(column - periods * columns) + here * (u - column);
  }
  const double inside = std::clamp(column, 0.0, columns + 0.0);
  return sum(inside) + here * (u - inside);
}

namespace {

/// The lines between texels that a side comes to, one after the other, along one axis.
class Lines {
 public:
  /// `count`: texels of a picture beyond which there are no lines; none where it is repeated.
  Lines(double from, double to, std::optional<int> count) : from_(from), length_(to - from), count_(count) {
    next(from);
  }

  /// What share of the side lies before the next line; infinite where there is none.
  double share() const { return share_; }
  void pass() { next(line_); }

 private:
  void next(double at) {
    share_ = std::numeric_limits<double>::infinity();
    if (length_ == 0) return;
    line_ = length_ > 0 ? std::floor(at) + 1 : std::ceil(at) - 1;
    if (count_) {
      line_ = length_ > 0 ? std::max(line_, 0.0) : std::min(line_, *count_ + 0.0);
      if (line_ < 0 || line_ > *count_) return;
    }
    share_ = (line_ - from_) / length_;
  }

  double from_, length_;
  std::optional<int> count_;
  double line_ = 0;
  double share_ = 0;
};

}  // namespace

/// Of what along_row() says less what it says of `reference`, times dv; places are in texels. Between two lines it runs
/// straight.
glm::dvec3 ImageTexture::along_side(const TexturePoint& from, const TexturePoint& to, double reference,
                                    TextureWork& work) const {
  const double run = to.u - from.u;
  const double rise = to.v - from.v;
  const auto count = [&](int texels) { return wrap_ == Wrap::clamp ? std::optional(texels) : std::nullopt; };
  Lines columns(from.u, to.u, count(image_.columns()));
  Lines rows(from.v, to.v, count(image_.rows()));
  glm::dvec3 sum(0);
  for (double here = 0; here < 1;) {
    const double there = std::min({1.0, columns.share(), rows.share()});
    if (there > here) {
      const double middle = 0.5 * (here + there);
      const double row = std::floor(from.v + middle * rise);
      sum += (along_row(from.u + middle * run, row) - along_row(reference, row)) * ((there - here) * rise);
      ++work.texels;
    }
    if (columns.share() <= there) columns.pass();
    if (rows.share() <= there) rows.pass();
    here = there;
  }
  return sum;
}

/// The footprint is moved to the picture that its first corner lies on, where pictures are repeated.
glm::dvec3 ImageTexture::mean(const Footprint& footprint, TextureWork& work) const {
  Footprint texels = footprint;
  for (TexturePoint& texel : texels) {
    if (wrap_ == Wrap::repeat) texel = {texel.u - std::floor(footprint[0].u), texel.v - std::floor(footprint[0].v)};
    texel = {texel.u * image_.columns(), texel.v * image_.rows()};
  }
  double lines = 0;
  for_each_side(texels, [&](const TexturePoint& a, const TexturePoint& b) {
    lines += std::abs(std::floor(a.u) - std::floor(b.u)) + std::abs(std::floor(a.v) - std::floor(b.v));
  });
  if (lines == 0) return color({std::floor(texels[0].u), std::floor(texels[0].v)});
  if (wrap_ == Wrap::repeat && !(lines <= most_lines)) return mean_;
  return mean_of_any(
      texels,
      [&](const Footprint& simple) {
        glm::dvec3 sum(0);
        for_each_side(
            simple, [&](const TexturePoint& a, const TexturePoint& b) { sum += along_side(a, b, simple[0].u, work); });
        return sum * (2 / twice_area(simple));
      },
      [&](const TexturePoint& place) {
        return color({std::floor(place.u), std::floor(place.v)});
      });
}

}  // namespace pyrasim
