// SPDX-License-Identifier: Apache-2.0
#include "image/pfm.h"

#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <cmath>
#include <string_view>

#include "error.h"
#include "image/read_bytes.h"
#include "image/sample_bytes.h"

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

/// The word at or after `position`, which moves past it.
std::string_view next_word(std::string_view bytes, std::size_t& position) {
  while (position < bytes.size() && is_space(bytes[position])) ++position;
  const std::size_t begin = position;
  while (position < bytes.size() && !is_space(bytes[position])) ++position;
  return bytes.substr(begin, position - begin);
}

template <typename Number>
bool parse(std::string_view word, Number& number) {
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  return error == std::errc() && end == word.data() + word.size();
}

PfmHeader parse_header(std::string_view bytes, const std::filesystem::path& file) {
  PfmHeader header;
  std::size_t position = 0;
  const std::string_view magic = bytes.substr(0, 2);
  if (magic == "PF") header.channels = 3;
  if (magic == "Pf") header.channels = 1;
  if (header.channels == 0)
    throw InputError(fmt::format("{}: not a PFM file; it must begin with PF or Pf", file.string()));
  position = magic.size();
  if (!parse(next_word(bytes, position), header.columns) || !parse(next_word(bytes, position), header.rows) ||
      header.columns < 1 || header.rows < 1 ||
      static_cast<std::size_t>(header.columns) > max_pixels / static_cast<std::size_t>(header.rows)) {
    throw InputError(
        fmt::format("{}: bad size; columns and rows must be from 1 to {} pixels in all", file.string(), max_pixels));
  }
  if (!parse(next_word(bytes, position), header.scale) || !std::isfinite(header.scale) || header.scale == 0) {
    throw InputError(fmt::format("{}: bad scale; it must be a finite number other than 0", file.string()));
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
    throw InputError(fmt::format("{}: {} bytes; its header asks for {}", file.string(), bytes.size(), expected));
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
