// SPDX-License-Identifier: Apache-2.0
#include "image/pfm.h"

#include "error.h"
#include "image/write_image.h"
#include "temporary_folder.h"

namespace pyrasim {
namespace {

using PfmTest = TemporaryFolder;

Image two_by_two() {
  Image image(2, 2);
  image.at(0, 0) = {1, 0, 0};
  image.at(0, 1) = {0, 0.5F, 0};
  image.at(1, 0) = {0, 0, 2};
  image.at(1, 1) = {-1, 0, 0};
  return image;
}

TEST(Pfm, bytes_of_a_small_picture) {
  const std::string zero(4, '\0');
  const std::string one("\0\0\x80\x3F", 4);
  const std::string half("\0\0\0\x3F", 4);
  const std::string two("\0\0\0\x40", 4);
  const std::string minus_one("\0\0\x80\xBF", 4);
  const std::string bottom = zero + zero + two + minus_one + zero + zero;
  const std::string top = one + zero + zero + zero + half + zero;
  EXPECT_EQ(encode_pfm(two_by_two()), "PF\n2 2\n-1.0\n" + bottom + top);
}

TEST_F(PfmTest, round_trip_is_exact) {
  write_image(in_folder("a.pfm"), two_by_two());
  const Image back = read_pfm(in_folder("a.pfm"));
  EXPECT_EQ(back.columns(), 2);
  EXPECT_EQ(back.rows(), 2);
  EXPECT_EQ(back.pixels(), two_by_two().pixels());
}

TEST_F(PfmTest, reads_grey_big_endian_with_a_scale) {
  put(in_folder("a.pfm"), "Pf 1 2 2.0\n" + std::string("\x3F\x80\0\0\x40\0\0\0", 8));
  const Image image = read_pfm(in_folder("a.pfm"));
  EXPECT_EQ(image.pixels(), (std::vector<glm::vec3>{glm::vec3(4), glm::vec3(2)}));
}

TEST_F(PfmTest, bad_files_are_named) {
  const auto message = [&](const std::string& bytes) {
    put(in_folder("a.pfm"), bytes);
    const std::string text = message_of<InputError>([&] { read_pfm(in_folder("a.pfm")); });
    const std::string prefix = in_folder("a.pfm").string() + ": ";
    EXPECT_EQ(text.substr(0, prefix.size()), prefix);
    return text.substr(std::min(prefix.size(), text.size()));
  };
  EXPECT_EQ(message(""), "not a PFM file; it must begin with PF or Pf");
  EXPECT_EQ(message("P6\n1 1\n255\n"), "not a PFM file; it must begin with PF or Pf");
  const std::string bad_size = "bad size; columns and rows must be from 1 to 134217728 pixels in all";
  for (const char* size : {"", "0 1", "-1 1", "1", "x 1", "99999999999 1", "100000 100000"}) {
    EXPECT_EQ(message("PF\n" + std::string(size) + "\n"), bad_size) << size;
  }
  for (const char* scale : {"", "0", "nan", "inf", "1x"}) {
    EXPECT_EQ(message("PF\n1 1\n" + std::string(scale) + "\n"), "bad scale; it must be a finite number other than 0");
  }
  EXPECT_EQ(message("PF\n1 1\n-1.0\n12345"), "17 bytes; its header asks for 24");
  EXPECT_EQ(message("PF\n1 1\n-1.0"), "11 bytes; its header asks for 24");
  EXPECT_EQ(message("PF\n1 1\n-1.0\n0123456789012"), "25 bytes; its header asks for 24");
}

}  // namespace
}  // namespace pyrasim
