// SPDX-License-Identifier: Apache-2.0
// The entry point of libFuzzer, for one reader: PYRASIM_FUZZ_READER.
#include <cstddef>
#include <cstdint>

#include "readers.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  pyrasim::fuzz::PYRASIM_FUZZ_READER({reinterpret_cast<const char*>(data), size});
  return 0;
}
