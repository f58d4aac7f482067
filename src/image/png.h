// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "image/image.h"

namespace pyrasim {

/// How samples are stored in a PNG file.
struct PngFormat {
  int bits = 8;      // per sample: 8 or 16
  bool srgb = true;  // sRGB signal, stated by an sRGB chunk; else linear intensity, stated by a gAMA chunk of 1
};

/// Keyword and text of a PNG file's text chunks: Software, Comment. Text is UTF-8; what is not shows as U+FFFD.
using TextChunks = std::vector<std::pair<std::string, std::string>>;

/// Throws UsageError where `format` is not one that PNG has.
void check_png_format(const PngFormat& format);

/// The integer that is stored for a linear sample: clamped to 0..1, not-a-number becoming 0, and rounded to nearest.
unsigned png_sample(float sample, const PngFormat& format);

/// The bytes of `image` as PNG.
/// Throws UsageError for a bad format, RunError where the PNG library refuses the picture.
std::string encode_png(const Image& image, const PngFormat& format = {}, const TextChunks& text = {});

/// Reads any PNG file as linear RGB: grey and palettes are expanded, pixels that are not opaque are composed over
/// black, in linear light, and counted. Samples are taken as sRGB unless the file has a gAMA chunk and no sRGB or iCCP
/// chunk. Throws InputError "FILE: what is wrong".
Image read_png(const std::filesystem::path& file, std::uint64_t* transparent_pixels = nullptr);
/// The same of a file's bytes; `name` is the file's.
Image decode_png(std::string_view bytes, const std::string& name, std::uint64_t* transparent_pixels = nullptr);

}  // namespace pyrasim
