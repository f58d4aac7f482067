// SPDX-License-Identifier: Apache-2.0
#include "hw_model/record/compressed.h"

#include <zlib.h>

#include <new>

namespace pyrasim::hw {

std::string compressed(std::string_view content, int level) {
  uLongf size = compressBound(content.size());
  std::string bytes(size, '\0');
  const int result = compress2(reinterpret_cast<Bytef*>(bytes.data()), &size,
                               reinterpret_cast<const Bytef*>(content.data()), content.size(), level);
  if (result != Z_OK) throw std::bad_alloc();  // there is no other cause
  bytes.resize(size);
  return bytes;
}

}  // namespace pyrasim::hw
