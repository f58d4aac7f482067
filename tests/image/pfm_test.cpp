// SPDX-License-Identifier: Apache-2.0
#include "image/pfm.h"

#include "../temporary_folder.h"
#include "error.h"
#include "image/write_image.h"

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

/// A plus sign, comments and any white space, as other tools write and read.
TEST_F(PfmTest, reads_headers_of_other_tools) {
  const std::string one("\0\0\x80\x3F", 4);
  const std::string pixel = one + one + one;
  const std::string big_endian = std::string("\x3F\x80\0\0", 4);
  for (const std::string& bytes :
       {"PF\n1 1\n-1.0\n" + pixel, "PF\n# made by hand\n1 1 # columns, rows\n# scale\n-1\n" + pixel,
        "PF\r\n1\t1\r-1.000000\n" + pixel, "Pf\n1 1\n+1.0\n" + big_endian, "Pf +1 +1 +1e0\n" + big_endian}) {
    put(in_folder("a.pfm"), bytes);
    EXPECT_EQ(read_pfm(in_folder("a.pfm")).pixels(), std::vector<glm::vec3>{glm::vec3(1)}) << bytes;
  }
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
  for (const char* other : {"P6\n1 1\n255\n", "PFX\n1 1\n-1\n", "PF41 1\n", " PF\n1 1\n-1\n"}) {
    EXPECT_EQ(message(other), "not a PFM file; it must begin with PF or Pf") << other;
  }
  EXPECT_EQ(message("PF4\n1 1\n-1.0\n0123456789012345"),
            "a PFM file of four channels, PF4; three (PF) or one (Pf) are allowed");
  for (const auto& [size, shown] :
       std::vector<std::pair<std::string, std::string>>{{"", "nothing for columns"},
                                                        {"0 1", "0 for columns"},
                                                        {"-1 1", "-1 for columns"},
                                                        {"+-1 1", "+-1 for columns"},
                                                        {"1", "nothing for rows"},
                                                        {"1 2.5", "2.5 for rows"},
                                                        {"x\x1B 1", "x\\u001b for columns"},
                                                        {"99999999999 1", "99999999999 for columns"}}) {
    EXPECT_EQ(message("PF\n" + size + "\n"), "bad header: " + shown + "; a whole number from 1 is allowed");
  }
  EXPECT_EQ(message("PF\n100000 100000\n"), "100000x100000; up to 268435456 pixels in all are allowed");
  for (const char* scale : {"0", "nan", "inf", "1x", "++1", "+-1"}) {
    EXPECT_EQ(message("PF\n1 1\n" + std::string(scale) + "\n"),
              "bad header: " + std::string(scale) + " for the scale; a finite number other than 0 is allowed");
  }
  EXPECT_EQ(message("PF\n1 1\n"), "bad header: nothing for the scale; a finite number other than 0 is allowed");
  EXPECT_EQ(message("PF\n1 1\n-1.0\n12345"), "17 bytes; its header asks for 24");
  EXPECT_EQ(message("PF\n1 1\n-1.0"), "11 bytes; its header asks for 24");
  EXPECT_EQ(message("PF\n1 1\n-1.0\n0123456789012"), "25 bytes; its header asks for 24");
}

}  // namespace
}  // namespace pyrasim
