// SPDX-License-Identifier: Apache-2.0
#include "image/write_image.h"

#include <fmt/format.h>

#include "error.h"
#include "image/pfm.h"

namespace pyrasim {

ImageFile image_file_kind(const std::filesystem::path& file) {
  const std::filesystem::path ending = file.extension();
  if (ending == ".png") return ImageFile::png;
  if (ending == ".pfm") return ImageFile::pfm;
  throw UsageError(fmt::format("{}: unknown kind of picture; its name must end in .png or .pfm", file.string()));
}

void write_image(OutputFile& file, const Image& image, const PngFormat& format, const TextChunks& text) {
  const bool png = image_file_kind(file.path()) == ImageFile::png;
  file.write(png ? encode_png(image, format, text) : encode_pfm(image));
  file.commit();
}

void write_image(const std::filesystem::path& file, const Image& image, const PngFormat& format,
                 const TextChunks& text) {
  image_file_kind(file);
  OutputFile output(file);
  write_image(output, image, format, text);
}

Image read_image(const std::filesystem::path& file, std::uint64_t* transparent_pixels) {
  if (image_file_kind(file) == ImageFile::png) return read_png(file, transparent_pixels);
  if (transparent_pixels != nullptr) *transparent_pixels = 0;
  return read_pfm(file);
}

}  // namespace pyrasim
