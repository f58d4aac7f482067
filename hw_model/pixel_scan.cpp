// SPDX-License-Identifier: Apache-2.0
#include "hw_model/pixel_scan.h"

namespace pyrasim::hw {

PixelScan::PixelScan(const sc_core::sc_module_name& name, StageTiming timing, const PixelWindow& window, int max_level)
    : StageOf(name),
      timing_(timing),
      window_(window),
      rows_(static_cast<std::uint32_t>(window.rows)),
      columns_(static_cast<std::uint32_t>(window.columns)),
      max_level_(max_level) {}

Start PixelScan::next() {
  if (row_ > rows_) return Start(never);
  Start start(ready());
  if (completes_pixel()) start.needs_token(tree_accumulator);
  return start.needs_room(view_vector_generator);
}

void PixelScan::fire(Cycle now) {
  PixelTag tag;
  if (completes_pixel()) tag = {(row_ - 1) * columns_ + column_ - 1, tree_accumulator->read(now).slot, now};
  view_vector_generator->write({pixel_corner(window_, row_, column_, max_level_), tag}, now, timing_.latency);
  if (++column_ > columns_) {
    column_ = 0;
    ++row_;
  }
  occupy(now, timing_.interval);
}

template class StageOf<PixelScan>;

}  // namespace pyrasim::hw
