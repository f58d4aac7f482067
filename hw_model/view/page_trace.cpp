// SPDX-License-Identifier: Apache-2.0
#include "hw_model/view/page_trace.h"

#include "hw_model/view/page.h"
#include "image/png.h"

namespace pyrasim::hw {

void PageTrace::finish(Cycle cycles) {
  const std::string run = page_run(processor_, tables_, cycles, run_, "", encode_png(processor_.image()));
  write_page(output_, {&run, 1});
}

}  // namespace pyrasim::hw
