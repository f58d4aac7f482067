// SPDX-License-Identifier: Apache-2.0
#include "hw_model/pixel_scan.h"

namespace pyrasim::hw {

PixelScan::PixelScan(const sc_core::sc_module_name& name, const FrameSetup& frame)
    : StageOf(name),
      timing_(frame.spec.pixel_scan),
      window_(frame.window),
      rows_(static_cast<std::uint32_t>(window_.rows)),
      columns_(static_cast<std::uint32_t>(window_.columns)),
      max_level_(frame.options.max_level) {}

PixelScan::Plan PixelScan::next(const Ends& ends, Cycle ready) const {
  if (row_ > rows_) return {Start(never)};
  Start start(ready);
  if (completes_pixel()) start.needs_token(ends.tree_accumulator);
  return {start.needs_room(ends.view_vector_generator)};
}

Cycle PixelScan::fire(Ends& ends, const Plan& plan) {
  const Cycle now = plan.start.at();
  ends.view_vector_generator.write_made(
      [&] {
        const GridPoint point = pixel_cell(window_, row_, column_, max_level_).corner;
        if (!completes_pixel()) return CornerRequest{point, {}};
        return CornerRequest{point, {pixel_++, ends.tree_accumulator.read(now).slot, now}};
      },
      now, timing_.latency);
  if (++column_ > columns_) {
    column_ = 0;
    ++row_;
  }
  return timing_.interval;
}

template class StageOf<PixelScan>;

}  // namespace pyrasim::hw
