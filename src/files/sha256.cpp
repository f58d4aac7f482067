// SPDX-License-Identifier: Apache-2.0
#include "files/sha256.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <array>

#include "error.h"

namespace pyrasim {
namespace {

void require(bool done) {
  if (!done) throw RunError("SHA-256: the cryptographic library refused");
}

}  // namespace

struct Sha256::Context {
  EVP_MD_CTX* library = EVP_MD_CTX_new();
  Context() = default;
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
  ~Context() { EVP_MD_CTX_free(library); }
};

Sha256::Sha256() : context_(std::make_unique<Context>()) {
  require(context_->library != nullptr && EVP_DigestInit_ex(context_->library, EVP_sha256(), nullptr) == 1);
}
Sha256::~Sha256() = default;

void Sha256::add(std::string_view bytes) {
  require(EVP_DigestUpdate(context_->library, bytes.data(), bytes.size()) == 1);
}

std::string Sha256::hex() {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned length = 0;
  require(EVP_DigestFinal_ex(context_->library, digest.data(), &length) == 1);
  std::string hex;
  for (unsigned i = 0; i < length; ++i) hex += fmt::format("{:02x}", digest[i]);
  return hex;
}

std::string sha256(std::string_view bytes) {
  Sha256 hash;
  hash.add(bytes);
  return hash.hex();
}

}  // namespace pyrasim
