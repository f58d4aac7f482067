// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "image/image.h"

namespace pyrasim {

/// A test with a folder of its own, which is removed afterwards.
class TemporaryFolder : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = testing::TempDir() + "pyrasim-test-XXXXXX";
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path in_folder(const std::string& name) const { return folder_ / name; }

  /// How many entries, hidden ones as well, stand in the folder.
  std::ptrdiff_t entries() const { return std::distance(std::filesystem::directory_iterator(folder_), {}); }

  static std::string contents(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  static void put(const std::filesystem::path& file, const std::string& bytes) {
    std::ofstream(file, std::ios::binary) << bytes;
  }

  std::filesystem::path folder_;
};

/// The message of the `Error` that `action` throws; fails the test where it throws none.
template <typename Error, typename Action>
std::string message_of(Action action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return {};
}

/// A picture of one row whose pixels are grey.
inline Image grey_row(const std::vector<float>& samples) {
  Image image(static_cast<int>(samples.size()), 1);
  for (std::size_t i = 0; i < samples.size(); ++i) image.pixels()[i] = glm::vec3(samples[i]);
  return image;
}

}  // namespace pyrasim
