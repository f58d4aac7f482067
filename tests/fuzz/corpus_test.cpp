// SPDX-License-Identifier: Apache-2.0
// All that the fuzzers' corpora hold, whole and cut short: what was found once does not come back.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "readers.h"

namespace pyrasim {
namespace {

const std::filesystem::path corpora = std::filesystem::path(PYRASIM_SOURCE_DIR) / "tests/fuzz/corpus";

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class Corpus : public testing::TestWithParam<fuzz::Reader> {};

TEST_P(Corpus, IsReadWithoutACrash) {
  std::filesystem::current_path(corpora / "scene");  // where its meshes and pictures are
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(corpora / GetParam().name)) {
    SCOPED_TRACE(entry.path());
    const std::string bytes = bytes_of(entry.path());
    for (std::size_t cut = 0; cut < 8; ++cut)
      GetParam().read(std::string_view(bytes).substr(0, bytes.size() * (8 - cut) / 8));
    ++files;
  }
  EXPECT_GT(files, 3U);
}

INSTANTIATE_TEST_SUITE_P(Readers, Corpus, testing::ValuesIn(fuzz::readers),
                         [](const auto& reader) { return std::string(reader.param.name); });

}  // namespace
}  // namespace pyrasim
