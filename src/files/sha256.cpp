// SPDX-License-Identifier: Apache-2.0
#include "files/sha256.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <array>

#include "error.h"

namespace pyrasim {

std::string sha256(std::string_view bytes) {
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
