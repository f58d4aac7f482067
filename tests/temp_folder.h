// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace pyrasim {

/// A test with a folder of its own, which is gone afterwards.
class TempFolderTest : public testing::Test {
 protected:
  TempFolderTest() {
    std::string pattern = (std::filesystem::path(testing::TempDir()) / "pyrasim_XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
  }
  ~TempFolderTest() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  /// Writes a file of the folder and returns its path.
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }

  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

}  // namespace pyrasim
