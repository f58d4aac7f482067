// SPDX-License-Identifier: Apache-2.0
#include "hw_model/subdivision_controller.h"

#include <algorithm>
#include <cassert>

namespace pyrasim::hw {

SubdivisionController::SubdivisionController(const sc_core::sc_module_name& name, const FrameSetup& frame)
    : StageOf(name),
      timing_(frame.spec.subdivision_controller),
      pool_(frame.spec.subdivision_pool),
      max_level_(frame.options.max_level) {}

SubdivisionController::Plan SubdivisionController::next(const Ends& ends, Cycle ready) const {
  const Start accept = Start(ready).needs_token(ends.pyramid_classifier);
  const Start issue =
      can_issue() ? Start(ready).needs_room(ends.view_vector_generator).needs_room(ends.parents) : Start(never);
  if (accept.at() <= issue.at()) return {accept, true};
  return {issue, false};
}

/// The banker's rule.
bool SubdivisionController::can_issue() const {
  if (subpixels_.empty() && pixels_.empty()) return false;
  return pool_kept() + pool_needed() <= pool_;
}

/// Worked off depth first, a node replaces its entry by four and needs three more for each further time that its cell
/// can be halved; a pixel has no entry to give back, and needs one more.
std::size_t SubdivisionController::pool_needed() const {
  const bool from_pool = !subpixels_.empty();
  if (!from_pool && pixels_.empty()) return 0;
  const Cell& cell = from_pool ? subpixels_.back().cell : pixels_.front().cell;
  if (!family_returns(cell)) return 0;
  return 3 * (static_cast<std::size_t>(cell.log2_side) - 1) + (from_pool ? 0 : 1);
}

Cycle SubdivisionController::fire(Ends& ends, const Plan& plan) {
  const Cycle now = plan.start.at();
  if (plan.accepts) {
    accept(ends.pyramid_classifier.front());
    ends.pyramid_classifier.pop(now);
  } else {
    issue(ends, now);
  }
  return timing_.interval;
}

void SubdivisionController::accept(const NodeMessage& node) {
  if (node.cell.log2_side == static_cast<std::uint32_t>(max_level_)) {
    pixels_.push_back(node);
    return;
  }
  if (node.subdivide) {
    subpixels_.push_back(node);
    --reserved_;
    --unsettled_;
  }
  if (node.closes_family) {
    reserved_ -= unsettled_;
    unsettled_ = 4;
  }
}

void SubdivisionController::issue(Ends& ends, Cycle now) {
  const bool from_pool = !subpixels_.empty();
  const NodeMessage& node = from_pool ? subpixels_.back() : pixels_.front();
  ends.view_vector_generator.write({node.cell}, now, timing_.latency);
  ends.parents.write(node, now, timing_.latency);
  if (family_returns(node.cell)) reserved_ += 4;
  if (from_pool) {
    subpixels_.pop_back();
  } else {
    pixels_.pop_front();
  }
  most_used_ = std::max(most_used_, subpixels_.size() + reserved_);
  assert(most_used_ <= pool_);
}

[[gnu::flatten]] void SubdivisionController::fire_before(Cycle horizon) {
  if (books_singly()) {
    fire_one(horizon);
  } else {
    fire_in_a_row(horizon, [](const Ends&) { return true; });
  }
}

}  // namespace pyrasim::hw
