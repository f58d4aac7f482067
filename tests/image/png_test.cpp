// SPDX-License-Identifier: Apache-2.0
#include "image/png.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>

#include "../temporary_folder.h"
#include "error.h"
#include "image/srgb.h"
#include "image/write_image.h"

namespace pyrasim {

/// How GoogleTest names a format; without it, by its bytes, padding included.
void PrintTo(const PngFormat& format, std::ostream* stream) {
  *stream << (format.srgb ? "sRGB, " : "linear, ") << format.bits << " bits";
}

namespace {

using PngTest = TemporaryFolder;

/// Every channel of every pixel differs.
Image ramp() {
  Image image(5, 3);
  float sample = 0;
  for (glm::vec3& pixel : image.pixels()) {
    for (int channel = 0; channel < 3; ++channel, sample += 1.0F / 44.0F) pixel[channel] = std::min(sample, 1.0F);
  }
  return image;
}

/// The data of the first chunk of the kind `type`; empty where there is none.
std::string chunk(const std::string& png, const std::string& type) {
  for (std::size_t at = 8; at + 12 <= png.size();) {
    std::size_t length = 0;
    for (std::size_t i = 0; i < 4; ++i) length = length << 8U | static_cast<unsigned char>(png[at + i]);
    if (png.compare(at + 4, 4, type) == 0) return png.substr(at + 8, length);
    at += 12 + length;
  }
  return {};
}

std::string from_hex(const std::string& digits) {
  std::string bytes;
  for (std::size_t i = 0; i + 1 < digits.size(); i += 2) {
    bytes.push_back(static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16)));
  }
  return bytes;
}

class PngRoundTrip : public PngTest, public testing::WithParamInterface<PngFormat> {};

TEST_P(PngRoundTrip, is_exact_to_half_a_step_of_the_signal) {
  const PngFormat format = GetParam();
  const Image image = ramp();
  write_image(in_folder("a.png"), image, format);
  const Image back = read_png(in_folder("a.png"));
  ASSERT_EQ(back.columns(), 5);
  ASSERT_EQ(back.rows(), 3);
  const auto signal = [&](float linear) { return format.srgb ? srgb_from_linear(linear) : linear; };
  const double half_step = 0.5 / (std::exp2(format.bits) - 1);
  for (std::size_t i = 0; i < image.pixels().size(); ++i) {
    for (int channel = 0; channel < 3; ++channel) {
      EXPECT_NEAR(signal(back.pixels()[i][channel]), signal(image.pixels()[i][channel]), half_step * 1.001);
    }
  }
}

TEST_P(PngRoundTrip, second_trip_changes_nothing) {
  write_image(in_folder("a.png"), ramp(), GetParam());
  write_image(in_folder("b.png"), read_png(in_folder("a.png")), GetParam());
  EXPECT_EQ(contents(in_folder("a.png")), contents(in_folder("b.png")));
}

INSTANTIATE_TEST_SUITE_P(formats, PngRoundTrip,
                         testing::Values(PngFormat{8, true}, PngFormat{8, false}, PngFormat{16, true},
                                         PngFormat{16, false}),
                         [](const auto& test) {
                           return std::string(test.param.srgb ? "srgb" : "linear") + std::to_string(test.param.bits);
                         });

TEST(Png, states_its_transfer_function) {
  const std::string srgb = encode_png(ramp());
  EXPECT_EQ(chunk(srgb, "sRGB").size(), 1U);
  EXPECT_EQ(chunk(srgb, "IHDR")[8], 8);
  const std::string linear = encode_png(ramp(), {16, false});
  EXPECT_EQ(chunk(linear, "sRGB"), "");
  EXPECT_EQ(chunk(linear, "gAMA"), std::string("\x00\x01\x86\xA0", 4));  // 100000: gamma 1
  EXPECT_EQ(chunk(linear, "IHDR")[8], 16);
}

TEST(Png, carries_text) {
  const std::string png = encode_png(ramp(), {}, {{"Software", "pyrasim 1"}, {"Comment", "K\xC3\xA4"}});
  EXPECT_EQ(chunk(png, "tEXt"), std::string("Software\0pyrasim 1", 18));
  EXPECT_EQ(chunk(png, "iTXt"), std::string("Comment\0\0\0\0\0K\xC3\xA4", 15));
}

TEST(Png, text_is_utf8_and_plain_text_is_printable) {
  const std::string invalid = encode_png(ramp(), {}, {{"Comment", "sph\xE8re"}});
  EXPECT_EQ(chunk(invalid, "tEXt"), "");
  EXPECT_EQ(chunk(invalid, "iTXt"), std::string("Comment\0\0\0\0\0sph\xEF\xBF\xBDre", 20));
  EXPECT_EQ(chunk(encode_png(ramp(), {}, {{"Comment", "\x1B[2J"}}), "tEXt"), "");
}

TEST_F(PngTest, rounds_to_nearest_and_clamps) {
  const float infinity = std::numeric_limits<float>::infinity();
  const Image image =
      grey_row({-1.0F, 0.49F / 255, 0.51F / 255, 254.51F / 255, 7.0F, infinity, -infinity, std::nanf("")});
  write_image(in_folder("a.png"), image, {8, false});
  const Image back = read_png(in_folder("a.png"));
  const std::vector<float> expected = {0, 0, 1.0F / 255, 1, 1, 1, 0, 0};
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_FLOAT_EQ(back.pixels()[i].x, expected[i]) << i;
}

TEST_F(PngTest, srgb_signal_of_known_values) {
  // Signal 188 of 255 stands for 0.5029 of the intensity, 55 for 0.0382.
  write_image(in_folder("a.png"), grey_row({0.5F, 0.0382F}), {8, true});
  const Image back = read_png(in_folder("a.png"));
  EXPECT_NEAR(back.pixels()[0].x, linear_from_srgb(188.0 / 255), 1e-7);
  EXPECT_NEAR(back.pixels()[1].x, linear_from_srgb(55.0 / 255), 1e-7);
}

/// Red of alpha 128 of 255, and green.
TEST_F(PngTest, reads_a_palette_of_one_bit_with_alpha) {
  put(in_folder("a.png"),
      from_hex("89504e470d0a1a0a0000000d4948445200000002000000010103000000ceecedc900000006504c5445ff000000ff00d287ef71"
               "0000000174524e5380ad5e5b460000000a4944415478da637000000042004184bf8e620000000049454e44ae426082"));
  std::uint64_t transparent = 0;
  const Image image = read_png(in_folder("a.png"), &transparent);
  EXPECT_FLOAT_EQ(image.at(0, 0).x, 128.0F / 255);
  EXPECT_EQ(image.at(0, 0).y, 0);
  EXPECT_EQ(image.at(0, 1), glm::vec3(0, 1, 0));
  EXPECT_EQ(transparent, 1U);
}

TEST_F(PngTest, reads_grey_and_alpha_of_a_stated_gamma) {
  put(in_folder("a.png"),
      from_hex("89504e470d0a1a0a0000000d49484452000000020000000108040000005e2bb7010000000467414d410000c3500099b534"
               "0000000d4944415478da6330e6fccf000002ea013c56fb88a20000000049454e44ae426082"));
  const Image image = read_png(in_folder("a.png"));  // gamma 1/2, signals 0.2 and 1 of alpha 9 of 255 and 0
  EXPECT_FLOAT_EQ(image.at(0, 0).x, 0.04F * 9 / 255);
  EXPECT_FLOAT_EQ(image.at(0, 0).z, 0.04F * 9 / 255);
  EXPECT_EQ(image.at(0, 1).y, 0);
}

/// Linear samples (gamma 1), each picture made with Python's zlib from the samples beside it.
TEST_F(PngTest, composes_every_kind_of_transparency_over_black) {
  struct Case {
    const char* what;
    const char* hex;
    std::vector<glm::vec3> pixels;
    std::uint64_t transparent;
  };
  const std::vector<Case> cases = {
      {"8 bits: (255, 102, 0) of alpha 255, the same of 51, white of 0",
       "89504e470d0a1a0a0000000d49484452000000030000000108060000001be014b40000000467414d41000186a031e8965f0000001449444"
       "1"
       "5478da63f89fc6f01f888dffffffcf00002e1206fa2f038f530000000049454e44ae426082",
       {{1, 0.4F, 0}, {0.2F, 0.08F, 0}, {0, 0, 0}},
       2},
      {"16 bits: (65535, 13107, 0) of alpha 13107, white of 65535",
       "89504e470d0a1a0a0000000d4948445200000002000000011006000000a4b2a3c90000000467414d41000186a031e8965f0000001449444"
       "1"
       "5478da63f8ffdfd89881c1d8f83f1400004bf80ac307328e470000000049454e44ae426082",
       {{0.2F, 0.04F, 0}, {1, 1, 1}},
       1},
      {"grey, 16 bits: 65535 of alpha 13107, 13107 of 65535",
       "89504e470d0a1a0a0000000d49484452000000020000000110040000000ebb6b420000000467414d41000186a031e8965f0000001049444"
       "1"
       "5478da63f8ffdf1808feff0700158d04c9f947ad250000000049454e44ae426082",
       {glm::vec3(0.2F), glm::vec3(0.2F)},
       1},
      {"RGB whose colour (10, 20, 30) is transparent, and red",
       "89504e470d0a1a0a0000000d49484452000000020000000108020000007b40e8dd0000000467414d41000186a031e8965f0000000674524"
       "e"
       "53000a0014001ec53629ff0000000f4944415478da63e01291fbcfc00000041c013c7539e1100000000049454e44ae426082",
       {{0, 0, 0}, {1, 0, 0}},
       1}};
  for (const Case& given : cases) {
    put(in_folder("a.png"), from_hex(given.hex));
    std::uint64_t transparent = 0;
    const Image image = read_png(in_folder("a.png"), &transparent);
    EXPECT_EQ(transparent, given.transparent) << given.what;
    ASSERT_EQ(image.pixels().size(), given.pixels.size()) << given.what;
    for (std::size_t i = 0; i < given.pixels.size(); ++i) {
      for (int channel = 0; channel < 3; ++channel) {
        EXPECT_NEAR(image.pixels()[i][channel], given.pixels[i][channel], 1e-6) << given.what;
      }
    }
  }
}

TEST_F(PngTest, opaque_pictures_have_no_transparent_pixels) {
  for (const PngFormat format : {PngFormat{8, true}, PngFormat{16, false}}) {
    write_image(in_folder("a.png"), ramp(), format);
    std::uint64_t transparent = 7;
    read_image(in_folder("a.png"), &transparent);
    EXPECT_EQ(transparent, 0U);
  }
}

TEST_F(PngTest, bad_files_are_named) {
  put(in_folder("text.png"), "this is no picture");
  EXPECT_EQ(message_of<InputError>([&] { read_png(in_folder("text.png")); }),
            in_folder("text.png").string() + ": not a usable PNG file: Not a PNG file");
  put(in_folder("empty.png"), "");
  EXPECT_THROW(read_png(in_folder("empty.png")), InputError);
  const std::string whole = encode_png(ramp());
  put(in_folder("short.png"), whole.substr(0, whole.size() - 30));
  EXPECT_EQ(message_of<InputError>([&] { read_png(in_folder("short.png")); }),
            in_folder("short.png").string() + ": not a usable PNG file: the file ends too early");
  EXPECT_EQ(message_of<InputError>([&] { read_png(in_folder("none.png")); }),
            in_folder("none.png").string() + ": cannot read: No such file or directory");
  EXPECT_EQ(message_of<InputError>([&] { read_png(folder_); }), folder_.string() + ": cannot read: Is a directory");
}

TEST_F(PngTest, every_cut_or_changed_byte_is_survived) {
  const std::string whole = encode_png(ramp());
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::string changed = whole;
    changed[i] = static_cast<char>(changed[i] ^ 0x55);
    for (const std::string& bytes : {changed, whole.substr(0, i)}) {
      put(in_folder("a.png"), bytes);
      try {
        read_png(in_folder("a.png"));
      } catch (const InputError&) {  // most are found out, some by luck are pictures
      }
    }
  }
}

TEST(Png, unusable_requests) {
  EXPECT_EQ(message_of<UsageError>([] {
              encode_png(ramp(), {12, true});
            }),
            "12 bits per PNG sample; 8 or 16 are allowed");
  EXPECT_THROW(encode_png(Image()), RunError);
}

TEST_F(PngTest, ending_of_the_name_chooses_the_kind) {
  write_image(in_folder("a.pfm"), ramp());
  EXPECT_EQ(contents(in_folder("a.pfm")).substr(0, 3), "PF\n");
  EXPECT_EQ(read_image(in_folder("a.pfm")).pixels(), ramp().pixels());
  for (const char* name : {"a.jpg", "a", "a.PNG", "png", ".png"}) {
    EXPECT_EQ(message_of<UsageError>([&] { write_image(in_folder(name), ramp()); }),
              in_folder(name).string() + ": unknown kind of picture; its name must end in .png or .pfm");
  }
  EXPECT_EQ(entries(), 1);
}

TEST(Srgb, functions_are_inverse_and_meet_the_standard) {
  EXPECT_EQ(srgb_from_linear(0), 0);
  EXPECT_DOUBLE_EQ(srgb_from_linear(1), 1);
  EXPECT_DOUBLE_EQ(srgb_from_linear(0.001), 0.01292);
  EXPECT_NEAR(srgb_from_linear(0.214041140), 0.5, 1e-9);
  for (int i = 0; i <= 65535; ++i) EXPECT_NEAR(srgb_from_linear(linear_from_srgb(i / 65535.0)), i / 65535.0, 1e-7);
}

}  // namespace
}  // namespace pyrasim
