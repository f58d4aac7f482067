// SPDX-License-Identifier: Apache-2.0
#include "version.h"

namespace pyrasim {

std::string_view version() { return PYRASIM_VERSION; }

}  // namespace pyrasim
