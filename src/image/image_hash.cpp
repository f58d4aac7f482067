// SPDX-License-Identifier: Apache-2.0
#include "image/image_hash.h"

#include "files/sha256.h"
#include "image/sample_bytes.h"

namespace pyrasim {

std::string image_sha256(const Image& image) {
  std::string bytes;
  bytes.reserve(image.pixels().size() * 3 * sizeof(float));
  for (const glm::vec3& pixel : image.pixels()) {
    for (int channel = 0; channel < 3; ++channel) append_float32_le(bytes, pixel[channel]);
  }
  return sha256(bytes);
}

}  // namespace pyrasim
