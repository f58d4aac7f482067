// SPDX-License-Identifier: Apache-2.0
#include "surface/pov_writer.h"

#include <fmt/format.h>

#include <iterator>

#include "camera/observer_frame.h"
#include "numeric/quadruple.h"

namespace pyrasim {

/// POV-Ray's offset is a distance, along a normal of length 1.
void PovWriter::plane(const glm::dvec3& normal, double offset) {
  object("plane", normalized(normal), static_cast<double>(offset / length(exactly(normal))));
}

void PovWriter::matrix(const std::array<glm::dvec3, 3>& axes, const glm::dvec3& origin) {
  item("matrix");
  text_ += " <";
  for (const glm::dvec3& axis : axes) fmt::format_to(std::back_inserter(text_), "{}, {}, {}, ", axis.x, axis.y, axis.z);
  fmt::format_to(std::back_inserter(text_), "{}, {}, {}>", origin.x, origin.y, origin.z);
}

void PovWriter::declared(const void* thing) { item(fmt::format("Shared_{}", declared_.at(thing))); }

bool PovWriter::declare(const void* thing) {
  if (!declared_.emplace(thing, declared_.size()).second) return false;
  item(std::string_view("#declare"));
  declared(thing);
  item(std::string_view("="));
  return true;
}

void PovWriter::begin(std::string_view name) {
  item(name);
  text_ += " {";
}

void PovWriter::end() { item(std::string_view("}")); }

void PovWriter::add_line(const glm::dvec3& vector) {
  separate();
  text_.back() = '\n';
  after_argument_ = false;
  add(vector);
}

void PovWriter::new_line() {
  text_ += '\n';
  after_argument_ = false;
}

void PovWriter::comment(std::string_view line) {
  fmt::format_to(std::back_inserter(text_), "// {}\n", line);
  after_argument_ = false;
}

void PovWriter::item(double number) {
  separate();
  fmt::format_to(std::back_inserter(text_), "{}", number);
}

void PovWriter::item(const glm::dvec3& vector) {
  separate();
  fmt::format_to(std::back_inserter(text_), "<{}, {}, {}>", vector.x, vector.y, vector.z);
}

void PovWriter::item(std::string_view word) {
  if (!text_.empty() && text_.back() != '\n') text_ += ' ';
  text_ += word;
  after_argument_ = false;
}

void PovWriter::separate() {
  if (after_argument_) text_ += ',';
  if (!text_.empty() && text_.back() != '\n') text_ += ' ';
  after_argument_ = true;
}

}  // namespace pyrasim
