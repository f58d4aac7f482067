// SPDX-License-Identifier: Apache-2.0
#include "scene/read_transform.h"

#include <fmt/format.h>

#include <cmath>

#include "surface/reading.h"
#include "text/counted.h"

namespace pyrasim {
namespace {

constexpr NumberRange degrees{-36000, 36000};

double read_factor(const JsonReader& reader) {
  const double factor = reader.number(coordinates);
  if (std::abs(factor) < min_length) {
    reader.fail(fmt::format("{} flattens space", factor),
                fmt::format("a number of at least {} in magnitude is allowed", min_length));
  }
  return factor;
}

AffineMap read_scale(const JsonReader& reader) {
  if (!reader.is_array()) return AffineMap::scaling(glm::dvec3(read_factor(reader)));
  glm::dvec3 factors;
  const auto elements = reader.elements(3, 3);
  for (std::size_t k = 0; k < 3; ++k) factors[static_cast<int>(k)] = read_factor(elements[k]);
  return AffineMap::scaling(factors);
}

AffineMap read_rotation(const JsonReader& reader) {
  reader.allow_keys({"axis", "degrees"});
  return AffineMap::rotation(read_direction(reader.member("axis")), reader.member("degrees").number(degrees));
}

AffineMap read_matrix(const JsonReader& reader) {
  QuadrupleMatrix matrix{};
  QuadrupleVector offset{};
  const auto rows = reader.elements(3, 3);
  for (std::size_t row = 0; row < 3; ++row) {
    const auto numbers = rows[row].elements(4, 4);
    for (std::size_t k = 0; k < 3; ++k) matrix[row][k] = numbers[k].number(coordinates);
    offset[row] = numbers[3].number(coordinates);
  }
  return {matrix, offset};
}

AffineMap read_step(const JsonReader& reader) {
  reader.allow_keys({"scale", "rotate", "translate", "matrix"});
  const auto members = reader.members();
  if (members.size() != 1) {
    reader.fail("it has " + counted(members.size(), "member"), "one of scale, rotate, translate, matrix is allowed");
  }
  const auto& [name, step] = members[0];
  return mapped_at(step, [&name = name, &step = step] {
    if (name == "scale") return read_scale(step);
    if (name == "rotate") return read_rotation(step);
    if (name == "matrix") return read_matrix(step);
    return AffineMap::translation(step.vec3(coordinates));
  });
}

}  // namespace

AffineMap read_transform(const JsonReader& reader) {
  if (!reader.is_array()) return read_step(reader);
  AffineMap map;
  for (const JsonReader& step : reader.elements(1)) {
    const AffineMap next = read_step(step);
    map = mapped_at(reader, [&] { return next.after(map); });
  }
  return map;
}

}  // namespace pyrasim
