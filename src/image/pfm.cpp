// SPDX-License-Identifier: Apache-2.0
#include "image/pfm.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <string_view>

#include "error.h"
#include "image/read_bytes.h"
#include "image/sample_bytes.h"
#include "text/counted.h"
#include "text/printable.h"

namespace pyrasim {
namespace {

constexpr std::size_t sample_bytes = 4;

struct PfmHeader {
  int channels = 0;
  int columns = 0;
  int rows = 0;
  float scale = 0;  // negative: little endian
  std::size_t samples_begin = 0;
};

bool is_space(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

/// The word at or after `position`, which moves past it; white space and comments, from # to the line's end, are
/// passed.
std::string_view next_word(std::string_view bytes, std::size_t& position) {
  while (position < bytes.size() && (is_space(bytes[position]) || bytes[position] == '#')) {
    position = bytes[position] == '#' ? std::min(bytes.find('\n', position), bytes.size()) : position + 1;
  }
  const std::size_t begin = position;
  while (position < bytes.size() && !is_space(bytes[position])) ++position;
  return bytes.substr(begin, position - begin);
}

/// A number may begin with a plus sign, as some tools write scales.
template <typename Number>
bool parse(std::string_view word, Number& number) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  return error == std::errc() && end == word.data() + word.size();
}

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& message) {
  throw InputError(fmt::format("{}: {}", file.string(), message));
}

std::string shown(std::string_view word) { return word.empty() ? "nothing" : excerpt(word); }

int parse_size(std::string_view word, const std::string& what, const std::filesystem::path& file) {
  int size = 0;
  if (parse(word, size) && size >= 1) return size;
  fail(file, fmt::format("bad header: {} for {}; a whole number from 1 is allowed", shown(word), what));
}

PfmHeader parse_header(std::string_view bytes, const std::filesystem::path& file) {
  PfmHeader header;
  std::size_t position = 0;
  const std::string_view magic = bytes.substr(0, 1) == "P" ? next_word(bytes, position) : "";
  if (magic == "PF") header.channels = 3;
  if (magic == "Pf") header.channels = 1;
  if (magic == "PF4") fail(file, "a PFM file of four channels, PF4; three (PF) or one (Pf) are allowed");
  if (header.channels == 0) fail(file, "not a PFM file; it must begin with PF or Pf");
  header.columns = parse_size(next_word(bytes, position), "columns", file);
  header.rows = parse_size(next_word(bytes, position), "rows", file);
  if (static_cast<std::size_t>(header.columns) > max_pixels / static_cast<std::size_t>(header.rows)) {
    fail(file, fmt::format("{}x{}; up to {} pixels in all are allowed", header.columns, header.rows, max_pixels));
  }
  const std::string_view scale = next_word(bytes, position);
  if (!parse(scale, header.scale) || !std::isfinite(header.scale) || header.scale == 0) {
    fail(file, fmt::format("bad header: {} for the scale; a finite number other than 0 is allowed", shown(scale)));
  }
  header.samples_begin = position + 1;  // exactly one white-space character ends the header
  return header;
}

}  // namespace

std::string encode_pfm(const Image& image) {
  std::string bytes = fmt::format("PF\n{} {}\n-1.0\n", image.columns(), image.rows());
  bytes.reserve(bytes.size() + image.pixels().size() * 3 * sample_bytes);
  for (int row = image.rows() - 1; row >= 0; --row) {
    for (int column = 0; column < image.columns(); ++column) {
      for (int channel = 0; channel < 3; ++channel) append_float32_le(bytes, image.at(row, column)[channel]);
    }
  }
  return bytes;
}

Image read_pfm(const std::filesystem::path& file) {
  const std::string bytes = read_bytes(file);
  const PfmHeader header = parse_header(bytes, file);
  Image image(header.columns, header.rows);
  const std::size_t expected =
      header.samples_begin + image.pixels().size() * static_cast<std::size_t>(header.channels) * sample_bytes;
  if (bytes.size() != expected) {
    fail(file, fmt::format("{}; its header asks for {}", counted(bytes.size(), "byte"), expected));
  }
  const char* next = bytes.data() + header.samples_begin;
  for (int row = image.rows() - 1; row >= 0; --row) {
    for (int column = 0; column < image.columns(); ++column) {
      for (int channel = 0; channel < 3; ++channel) {
        const char* sample = next + (header.channels == 3 ? channel * static_cast<int>(sample_bytes) : 0);
        image.at(row, column)[channel] = float32_at(sample, header.scale < 0) * std::fabs(header.scale);
      }
      next += static_cast<std::size_t>(header.channels) * sample_bytes;
    }
  }
  return image;
}

}  // namespace pyrasim
