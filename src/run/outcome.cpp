// SPDX-License-Identifier: Apache-2.0
#include "run/outcome.h"

#include "error.h"

namespace pyrasim {

void require_finished(const Outcome& outcome) {
  if (!outcome.unfinished.empty()) throw LimitError(outcome.unfinished);
}

}  // namespace pyrasim
