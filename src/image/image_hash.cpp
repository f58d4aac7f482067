// SPDX-License-Identifier: Apache-2.0
#include "image/image_hash.h"

#include "files/sha256.h"
#include "image/sample_bytes.h"

namespace pyrasim {

std::string image_sha256(const Image& image) {
  // Row by row: a copy of the whole picture would take as much memory as the picture.
  Sha256 hash;
  std::string bytes;
  for (int row = 0; row < image.rows(); ++row) {
    bytes.clear();
    for (int column = 0; column < image.columns(); ++column) {
      const glm::vec3& pixel = image.at(row, column);
      for (int channel = 0; channel < 3; ++channel) append_float32_le(bytes, pixel[channel]);
    }
    hash.add(bytes);
  }
  return hash.hex();
}

}  // namespace pyrasim
