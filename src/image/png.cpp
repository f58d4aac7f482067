// SPDX-License-Identifier: Apache-2.0
#include "image/png.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <cmath>
#include <csetjmp>
#include <cstdint>

#include "error.h"
#include "image/read_bytes.h"
#include "image/srgb.h"
#include "text/utf8.h"

namespace pyrasim {
namespace {

constexpr std::size_t rgba = 4;       // samples a pixel, as they are read
constexpr unsigned opaque = 0xFFFFU;  // alpha of 16 bits

// The PNG library reports an error by a jump to setjmp. The functions that call setjmp keep everything that has a
// destructor in the struct that is passed to them, which the jump does not leave.

struct PngState {
  png_structp png = nullptr;
  png_infop info = nullptr;
  std::string error;
};

void on_error(png_structp png, png_const_charp message) {
  static_cast<PngState*>(png_get_error_ptr(png))->error = message;
  png_longjmp(png, 1);
}

void on_warning(png_structp /*png*/, png_const_charp /*message*/) {}

struct PngWriter : PngState {
  PngWriter() {
    png = png_create_write_struct(PNG_LIBPNG_VER_STRING, static_cast<PngState*>(this), on_error, on_warning);
    if (png != nullptr) info = png_create_info_struct(png);
    if (info == nullptr) throw RunError("PNG: cannot start the library");
  }
  ~PngWriter() { png_destroy_write_struct(&png, &info); }
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;

  std::string bytes;
  TextChunks chunks;
  std::vector<png_text> text;
  std::vector<png_byte> row;
};

void on_write(png_structp png, png_bytep data, std::size_t count) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(data), count);
}

void on_flush(png_structp /*png*/) {}

/// PNG's plain text is Latin-1; anything but ASCII that shows goes to an international chunk, which is UTF-8.
bool is_plain(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); });
}

/// Points into `chunks`.
std::vector<png_text> to_png_text(const TextChunks& chunks) {
  std::vector<png_text> text;
  for (const auto& [keyword, value] : chunks) {
    const bool plain = is_plain(value);
    png_text entry{};
    entry.compression = plain ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
    entry.key = const_cast<char*>(keyword.c_str());  // the library copies both
    entry.text = const_cast<char*>(value.c_str());
    (plain ? entry.text_length : entry.itxt_length) = value.size();
    text.push_back(entry);
  }
  return text;
}

void fill_row(std::vector<png_byte>& bytes, const Image& image, int row, const PngFormat& format) {
  bytes.clear();
  for (int column = 0; column < image.columns(); ++column) {
    for (int channel = 0; channel < 3; ++channel) {
      const unsigned value = png_sample(image.at(row, column)[channel], format);
      if (format.bits == 16) bytes.push_back(static_cast<png_byte>(value >> 8U));
      bytes.push_back(static_cast<png_byte>(value & 0xFFU));
    }
  }
}

/// Returns false, the reason in `writer.error`, where the library reports an error.
bool write_png(PngWriter& writer, const Image& image, const PngFormat& format) {
  if (setjmp(png_jmpbuf(writer.png)) != 0) return false;
  png_set_write_fn(writer.png, &writer.bytes, on_write, on_flush);
  png_set_IHDR(writer.png, writer.info, static_cast<png_uint_32>(image.columns()),
               static_cast<png_uint_32>(image.rows()), format.bits, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (format.srgb) {
    png_set_sRGB_gAMA_and_cHRM(writer.png, writer.info, PNG_sRGB_INTENT_PERCEPTUAL);
  } else {
    png_set_gAMA(writer.png, writer.info, 1.0);
  }
  png_set_text(writer.png, writer.info, writer.text.data(), static_cast<int>(writer.text.size()));
  png_write_info(writer.png, writer.info);
  for (int row = 0; row < image.rows(); ++row) {
    fill_row(writer.row, image, row, format);
    png_write_row(writer.png, writer.row.data());
  }
  png_write_end(writer.png, nullptr);
  return true;
}

struct PngReader : PngState {
  explicit PngReader(std::string_view of) : bytes(of) {
    png = png_create_read_struct(PNG_LIBPNG_VER_STRING, static_cast<PngState*>(this), on_error, on_warning);
    if (png != nullptr) info = png_create_info_struct(png);
    if (info == nullptr) throw RunError("PNG: cannot start the library");
  }
  ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  std::string_view bytes;
  std::size_t position = 0;
  std::vector<png_byte> samples;  // 16 bits each, most significant byte first
  std::vector<png_bytep> rows;
  double gamma = 0;  // 0: sRGB; else the signal is the intensity to this power
};

void on_read(png_structp png, png_bytep data, std::size_t count) {
  auto& reader = *static_cast<PngReader*>(png_get_io_ptr(png));
  if (count > reader.bytes.size() - reader.position) png_error(png, "the file ends too early");
  std::copy_n(reader.bytes.data() + reader.position, count, data);
  reader.position += count;
}

/// Asks the library for 16 bit RGB and alpha, whatever the file holds.
void expand_to_rgba16(PngReader& reader) {
  png_set_expand_16(reader.png);  // palettes and few bits as well, a transparent color to alpha
  png_set_gray_to_rgb(reader.png);
  png_set_add_alpha(reader.png, opaque, PNG_FILLER_AFTER);  // where there is none
  png_set_interlace_handling(reader.png);
  png_read_update_info(reader.png, reader.info);
}

void note_gamma(PngReader& reader) {
  const bool stated = (png_get_valid(reader.png, reader.info, PNG_INFO_sRGB) |
                       png_get_valid(reader.png, reader.info, PNG_INFO_iCCP)) != 0;
  if (stated || png_get_gAMA(reader.png, reader.info, &reader.gamma) == 0) reader.gamma = 0;
}

/// Returns false, the reason in `reader.error`, where the library reports an error.
bool read_samples(PngReader& reader) {
  if (setjmp(png_jmpbuf(reader.png)) != 0) return false;
  png_set_read_fn(reader.png, &reader, on_read);
  png_read_info(reader.png, reader.info);
  const std::size_t columns = png_get_image_width(reader.png, reader.info);
  const std::size_t rows = png_get_image_height(reader.png, reader.info);
  if (columns > max_pixels / rows) png_error(reader.png, "it has more than 2^28 pixels");
  // Deflate makes no more than 1,032 bytes of one: what says to hold more than that takes no memory.
  if (rows * png_get_rowbytes(reader.png, reader.info) / 1032 > reader.bytes.size()) {
    png_error(reader.png, "the file ends too early");
  }
  note_gamma(reader);
  expand_to_rgba16(reader);
  const std::size_t row_bytes = png_get_rowbytes(reader.png, reader.info);
  if (row_bytes != columns * 2 * rgba) png_error(reader.png, "its samples cannot be read as RGB");
  reader.samples.resize(rows * row_bytes);
  for (std::size_t row = 0; row < rows; ++row) reader.rows.push_back(reader.samples.data() + row * row_bytes);
  png_read_image(reader.png, reader.rows.data());
  png_read_end(reader.png, nullptr);
  return true;
}

/// The linear intensity of every 16 bit sample.
std::vector<float> linear_table(double gamma) {
  std::vector<float> table(65536);
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double signal = static_cast<double>(i) / 65535.0;
    table[i] = static_cast<float>(gamma == 0 ? linear_from_srgb(signal) : std::pow(signal, 1.0 / gamma));
  }
  return table;
}

}  // namespace

void check_png_format(const PngFormat& format) {
  if (format.bits != 8 && format.bits != 16) {
    throw UsageError(fmt::format("{} bits per PNG sample; 8 or 16 are allowed", format.bits));
  }
}

unsigned png_sample(float sample, const PngFormat& format) {
  const double clamped = sample > 0 ? std::min(static_cast<double>(sample), 1.0) : 0.0;
  const double signal = format.srgb ? srgb_from_linear(clamped) : clamped;
  return static_cast<unsigned>(std::lround(signal * ((1U << static_cast<unsigned>(format.bits)) - 1U)));
}

std::string encode_png(const Image& image, const PngFormat& format, const TextChunks& text) {
  check_png_format(format);
  PngWriter writer;
  for (const auto& [keyword, value] : text) writer.chunks.emplace_back(keyword, valid_utf8(value));
  writer.text = to_png_text(writer.chunks);
  if (!write_png(writer, image, format)) throw RunError(fmt::format("PNG: {}", writer.error));
  return std::move(writer.bytes);
}

Image read_png(const std::filesystem::path& file, std::uint64_t* transparent_pixels) {
  return decode_png(read_bytes(file), file.string(), transparent_pixels);
}

Image decode_png(std::string_view bytes, const std::string& name, std::uint64_t* transparent_pixels) {
  PngReader reader(bytes);
  if (!read_samples(reader)) throw InputError(fmt::format("{}: not a usable PNG file: {}", name, reader.error));
  Image image(static_cast<int>(png_get_image_width(reader.png, reader.info)),
              static_cast<int>(png_get_image_height(reader.png, reader.info)));
  const std::vector<float> linear = linear_table(reader.gamma);
  std::uint64_t transparent = 0;
  const png_byte* sample = reader.samples.data();
  const auto next = [&sample] {
    const unsigned value = static_cast<unsigned>(sample[0]) << 8U | sample[1];
    sample += 2;
    return value;
  };
  for (glm::vec3& pixel : image.pixels()) {
    for (int channel = 0; channel < 3; ++channel) pixel[channel] = linear[next()];
    const unsigned alpha = next();
    if (alpha == opaque) continue;
    pixel *= static_cast<float>(alpha) / static_cast<float>(opaque);
    ++transparent;
  }
  if (transparent_pixels != nullptr) *transparent_pixels = transparent;
  return image;
}

}  // namespace pyrasim
