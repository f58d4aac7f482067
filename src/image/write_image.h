// SPDX-License-Identifier: Apache-2.0
// Pictures in files: the name's ending, .png or .pfm, says which kind.
#pragma once

#include <filesystem>

#include "files/output_file.h"
#include "image/image.h"
#include "image/png.h"

namespace pyrasim {

enum class ImageFile { png, pfm };

/// The kind of picture that the ending of `file` stands for. Throws UsageError for any other than .png and .pfm.
ImageFile image_file_kind(const std::filesystem::path& file);

/// Writes and commits `image` to `file`, which was opened before the picture was computed. `format` and `text` are for
/// PNG alone; a PFM file is float32. Throws UsageError for a bad ending or format, RunError where it cannot be written.
void write_image(OutputFile& file, const Image& image, const PngFormat& format = {}, const TextChunks& text = {});

/// Opens, writes and commits in one go.
void write_image(const std::filesystem::path& file, const Image& image, const PngFormat& format = {},
                 const TextChunks& text = {});

/// Reads a PNG or PFM file as linear RGB; `transparent_pixels` as for read_png(). Throws UsageError for a bad ending,
/// InputError for a bad file.
Image read_image(const std::filesystem::path& file, std::uint64_t* transparent_pixels = nullptr);

}  // namespace pyrasim
