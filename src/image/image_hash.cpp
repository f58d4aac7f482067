// SPDX-License-Identifier: Apache-2.0
#include "image/image_hash.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <array>

#include "error.h"
#include "image/sample_bytes.h"

namespace pyrasim {

std::string image_sha256(const Image& image) {
  std::string bytes;
  bytes.reserve(image.pixels().size() * 3 * sizeof(float));
  for (const glm::vec3& pixel : image.pixels()) {
    for (int channel = 0; channel < 3; ++channel) append_float32_le(bytes, pixel[channel]);
  }
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned length = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &length, EVP_sha256(), nullptr) != 1) {
    throw RunError("SHA-256: the cryptographic library refused");
  }
  std::string hex;
  for (unsigned i = 0; i < length; ++i) hex += fmt::format("{:02x}", digest[i]);
  return hex;
}

}  // namespace pyrasim
