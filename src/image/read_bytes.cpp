// SPDX-License-Identifier: Apache-2.0
#include "image/read_bytes.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

#include "error.h"

namespace pyrasim {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& reason) {
  throw InputError(fmt::format("{}: cannot read: {}", file.string(), reason));
}

}  // namespace

std::string read_bytes(const std::filesystem::path& file) {
  const std::unique_ptr<std::FILE, CloseFile> stream(std::fopen(file.c_str(), "rb"));
  if (!stream) fail(file, std::generic_category().message(errno));
  std::string bytes;
  std::array<char, 65536> block{};
  while (const std::size_t count = std::fread(block.data(), 1, block.size(), stream.get())) {
    bytes.append(block.data(), count);
    if (bytes.size() > max_file_bytes) fail(file, fmt::format("more than {} bytes", max_file_bytes));
  }
  if (std::ferror(stream.get()) != 0) fail(file, std::generic_category().message(errno));
  return bytes;
}

}  // namespace pyrasim
