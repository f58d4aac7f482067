// SPDX-License-Identifier: Apache-2.0
// What is fed with bytes of any origin. Each reads them as the program does, and passes over what it says of mistakes:
// it must neither crash nor hang, nor take memory that the bytes do not account for.
#pragma once

#include <array>
#include <string_view>

namespace pyrasim::fuzz {

void read_scene(std::string_view bytes);
void read_obj(std::string_view bytes);
void read_mtl(std::string_view bytes);
void read_nff(std::string_view bytes);
void read_png(std::string_view bytes);

struct Reader {
  std::string_view name;  ///< and that of its corpus
  void (*read)(std::string_view);
};
inline constexpr std::array<Reader, 5> readers{
    {{"scene", read_scene}, {"obj", read_obj}, {"mtl", read_mtl}, {"nff", read_nff}, {"png", read_png}}};

}  // namespace pyrasim::fuzz
