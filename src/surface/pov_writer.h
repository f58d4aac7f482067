// SPDX-License-Identifier: Apache-2.0
// What writing a surface as POV-Ray's takes.
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <map>
#include <string>
#include <string_view>

namespace pyrasim {

/// Text in the scene description language of POV-Ray 3.7. Numbers are the shortest decimals that read back as they are.
class PovWriter {
 public:
  /// `name { item, item ... }`: numbers and vectors one after the other are separated by commas, as the language has it
  /// for the arguments of a statement; words are not.
  template <class... Item>
  void object(std::string_view name, const Item&... items) {
    begin(name);
    add(items...);
    end();
  }
  /// The points p with normal . p = offset; inside of it is what is less.
  void plane(const glm::dvec3& normal, double offset);

  /// Where the points 1 along the axes go, less where the origin goes, and that.
  void matrix(const std::array<glm::dvec3, 3>& axes, const glm::dvec3& origin);

  /// The name that declare() gave to it.
  void declared(const void* thing);
  /// `#declare name =`, if that has not been said of `thing`: whether what it is has to follow.
  bool declare(const void* thing);

  /// `name {`, whose items follow.
  void begin(std::string_view name);
  void end();
  template <class... Item>
  void add(const Item&... items) {
    (item(items), ...);
  }
  /// The arguments of long lists are a line each.
  void add_line(const glm::dvec3& vector);
  void new_line();
  /// To the line's end.
  void comment(std::string_view line);

  const std::string& text() const { return text_; }

 private:
  void item(double number);
  void item(const glm::dvec3& vector);
  void item(std::string_view word);
  /// Before an argument that may stand behind another.
  void separate();

  std::string text_;
  std::map<const void*, std::size_t> declared_;
  bool after_argument_ = false;
};

}  // namespace pyrasim
