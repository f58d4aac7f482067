// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace pyrasim::hw {

/// Whether a frame has a use for a box of the block diagram, or for a part of one: only then is it built.
struct Need {
  bool built = true;
  std::string reason;  ///< why, or why not
};

}  // namespace pyrasim::hw
