// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

namespace pyrasim {

/// A picture of linear RGB samples, top row first.
class Image {
 public:
  Image() = default;
  Image(int columns, int rows)
      : columns_(columns), rows_(rows), pixels_(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {}

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  glm::vec3& at(int row, int column) { return pixels_[index(row, column)]; }
  const glm::vec3& at(int row, int column) const { return pixels_[index(row, column)]; }
  std::vector<glm::vec3>& pixels() { return pixels_; }
  const std::vector<glm::vec3>& pixels() const { return pixels_; }

 private:
  std::size_t index(int row, int column) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }

  int columns_ = 0;
  int rows_ = 0;
  std::vector<glm::vec3> pixels_;
};

}  // namespace pyrasim
