// SPDX-License-Identifier: Apache-2.0
#include "run/collect_outcome.h"

#include "hw_model/report/deadlock.h"
#include "image/image_hash.h"

namespace pyrasim {
namespace {

UnitAccount unit_account(const hw::Processor& processor, const hw::Stage& stage) {
  UnitAccount unit{stage.basename(), stage.box(), stage.statistics(processor.cycles()), {}};
  for (const hw::Wait& wait : hw::waits(processor, stage)) {
    unit.waits.push_back({wait.fifo->basename(), wait.starved, wait.cycles});
  }
  return unit;
}

LatencyAccount latency_account(const hw::LatencyHistogram& histogram) {
  LatencyAccount account{histogram.count(),
                         histogram.mean(),
                         histogram.percentile(0.5),
                         histogram.percentile(0.9),
                         histogram.percentile(0.99),
                         histogram.max(),
                         {}};
  histogram.for_each_class([&](hw::Cycle last, std::uint64_t pixels) { account.classes.push_back({last, pixels}); });
  return account;
}

void collect_fifos(Outcome& outcome, const hw::Processor& processor, hw::Occupancies* occupancies) {
  for (const hw::FifoBase* fifo : processor.fifos()) {
    outcome.fifos.push_back({fifo->basename(), fifo->statistics(outcome.cycles), {}});
  }
  if (occupancies == nullptr) return;
  occupancies->end_frame(outcome.cycles);
  for (std::size_t k = 0; k < outcome.fifos.size(); ++k) {
    const hw::Occupancy& occupancy = occupancies->fifos()[k];
    outcome.fifos[k].occupancy = {occupancy.stride(), occupancy.points(outcome.cycles)};
  }
}

void collect_critical_path(Outcome& outcome, const hw::Processor& processor, hw::CriticalPath& path) {
  path.finish();
  for (const auto& [owed, place, cycles] : path.shares()) {
    outcome.critical_path.push_back(
        {std::string(hw::owed_names[static_cast<std::size_t>(owed)]), hw::place_name(processor, owed, place), cycles});
  }
}

void collect_latencies(Outcome& outcome, const hw::Processor& processor) {
  hw::LatencyHistogram all;
  for (const hw::LatencyHistogram& level : processor.tree_accumulator().latencies()) {
    outcome.latency_by_level.push_back(latency_account(level));
    all += level;
  }
  outcome.latency = latency_account(all);
  for (const hw::FinishedPixel& pixel : processor.tree_accumulator().slowest().list()) {
    const auto [row, column] = processor.place_of(pixel.pixel);
    outcome.slowest.push_back({row, column, pixel.latency, pixel.deepest});
  }
}

}  // namespace

Outcome collect_outcome(hw::Processor& processor, hw::Occupancies* occupancies, hw::CriticalPath* critical_path) {
  Outcome outcome;
  outcome.unfinished = hw::why_unfinished(processor);
  if (!outcome.unfinished.empty()) return outcome;
  outcome.counts = processor.statistics();
  outcome.cycles = processor.cycles();
  outcome.image_sha256 = image_sha256(processor.image());
  for (const hw::Stage* stage : processor.stages()) outcome.units.push_back(unit_account(processor, *stage));
  outcome.parts = processor.parts();
  collect_fifos(outcome, processor, occupancies);
  outcome.bottleneck = hw::bottleneck_chain(processor);
  outcome.lower_bound = hw::lower_bound(processor);
  if (critical_path != nullptr) collect_critical_path(outcome, processor, *critical_path);
  collect_latencies(outcome, processor);
  return outcome;
}

}  // namespace pyrasim
