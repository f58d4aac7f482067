// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace pyrasim {

/// Opens /dev/null on each of stdin, stdout and stderr that the program was started without: else the next file that is
/// opened would be it, and what is printed would land in that file. To be called before anything is opened. False where
/// that cannot be had.
bool open_standard_descriptors();

}  // namespace pyrasim
