// SPDX-License-Identifier: Apache-2.0
#include "hw_model/trace/trace_window.h"

#include <fnmatch.h>

#include <algorithm>

namespace pyrasim::hw {

bool TraceWindow::shows(std::string_view name) const {
  const std::string text(name);
  return units.empty() || std::any_of(units.begin(), units.end(), [&](const std::string& pattern) {
           return fnmatch(pattern.c_str(), text.c_str(), 0) == 0;
         });
}

}  // namespace pyrasim::hw
