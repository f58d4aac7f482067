// SPDX-License-Identifier: Apache-2.0
// The fields of an Outcome by name, and of what it is made of: packing and unpacking walk over these lists.
#pragma once

#include <concepts>
#include <type_traits>

#include "run/outcome.h"

namespace pyrasim {

template <class Self, class Plain>
concept MaybeConst = std::same_as<std::remove_const_t<Self>, Plain>;

template <MaybeConst<ArithmeticEvents> Self>
void for_each_field(Self& its, const auto& visit) {
  visit("saturations", its.saturations);
  visit("underflows", its.underflows);
  visit("inexact", its.inexact);
  visit("divisions_by_zero", its.divisions_by_zero);
  visit("invalid", its.invalid);
}

template <MaybeConst<DatapathEvents> Self>
void for_each_field(Self& its, const auto& visit) {
  visit("view_vectors", its.view_vectors);
  visit("intersection", its.intersection);
}

template <MaybeConst<Tests> Self>
void for_each_field(Self& its, const auto& visit) {
  visit("box_tests", its.box_tests);
  visit("surface_tests", its.surface_tests);
}

template <MaybeConst<ShadowWork> Self>
void for_each_field(Self& its, const auto& visit) {
  visit("rays", its.rays);
  visit("tests", its.tests);
}

template <MaybeConst<Work> Self>
void for_each_field(Self& its, const auto& visit) {
  for_each_field(static_cast<std::conditional_t<std::is_const_v<Self>, const Tests, Tests>&>(its), visit);
  visit("shadow", its.shadow);
}

template <MaybeConst<TextureWork> Self>
void for_each_field(Self& its, const auto& visit) {
  visit("places", its.places);
  visit("lines", its.lines);
  visit("texels", its.texels);
}

template <MaybeConst<FrameStatistics> Self>
void for_each_field(Self& its, const auto& visit) {
  visit("rays_by_level", its.rays_by_level);
  visit("cases_by_level", its.cases_by_level);
  visit("subdivisions", its.subdivisions);
  visit("terminal_nodes", its.terminal_nodes);
  visit("repeated_in_pixel", its.repeated_in_pixel);
  visit("repeated_between_pixels", its.repeated_between_pixels);
  visit("lights_with_shadows", its.lights_with_shadows);
  visit("work", its.work);
  visit("texture", its.texture);
  visit("arithmetic", its.arithmetic);
}

template <MaybeConst<hw::StageStatistics> Self>
void for_each_field(Self& its, const auto& visit) {
  visit("busy", its.busy);
  visit("starved", its.starved);
  visit("blocked", its.blocked);
  visit("idle", its.idle);
  visit("firings", its.firings);
}

template <MaybeConst<WaitAccount> Self>
void for_each_field(Self& its, const auto& visit) {
  visit("fifo", its.fifo);
  visit("starved", its.starved);
  visit("cycles", its.cycles);
}

template <MaybeConst<UnitAccount> Self>
void for_each_field(Self& its, const auto& visit) {
  visit("name", its.name);
  visit("box", its.box);
  visit("cycles", its.cycles);
  visit("waits", its.waits);
}

template <MaybeConst<hw::MachinePart> Self>
void for_each_field(Self& its, const auto& visit) {
  visit("box", its.box);
  visit("part", its.part);
  visit("units", its.units);
  visit("reason", its.reason);
  visit("busy", its.busy);
}

template <MaybeConst<hw::FifoStatistics> Self>
void for_each_field(Self& its, const auto& visit) {
  visit("depth", its.depth);
  visit("max", its.max);
  visit("token_cycles", its.token_cycles);
  visit("tokens", its.tokens);
  visit("starved", its.starved);
  visit("blocked", its.blocked);
}

template <MaybeConst<OccupancyAccount> Self>
void for_each_field(Self& its, const auto& visit) {
  visit("stride", its.stride);
  visit("tokens", its.tokens);
}

template <MaybeConst<FifoAccount> Self>
void for_each_field(Self& its, const auto& visit) {
  visit("name", its.name);
  visit("use", its.use);
  visit("occupancy", its.occupancy);
}

template <MaybeConst<hw::BottleneckLink> Self>
void for_each_field(Self& its, const auto& visit) {
  visit("unit", its.unit);
  visit("busy", its.busy);
  visit("waited", its.waited);
  visit("starved", its.starved);
}

template <MaybeConst<hw::LowerBound> Self>
void for_each_field(Self& its, const auto& visit) {
  visit("unit", its.unit);
  visit("cycles", its.cycles);
}

template <MaybeConst<PathAccount> Self>
void for_each_field(Self& its, const auto& visit) {
  visit("owed", its.owed);
  visit("place", its.place);
  visit("cycles", its.cycles);
}

template <MaybeConst<LatencyAccount::Class> Self>
void for_each_field(Self& its, const auto& visit) {
  visit("up_to", its.up_to);
  visit("pixels", its.pixels);
}

template <MaybeConst<LatencyAccount> Self>
void for_each_field(Self& its, const auto& visit) {
  visit("pixels", its.pixels);
  visit("mean", its.mean);
  visit("p50", its.p50);
  visit("p90", its.p90);
  visit("p99", its.p99);
  visit("max", its.max);
  visit("classes", its.classes);
}

template <MaybeConst<SlowPixel> Self>
void for_each_field(Self& its, const auto& visit) {
  visit("row", its.row);
  visit("column", its.column);
  visit("cycles", its.cycles);
  visit("level", its.level);
}

template <MaybeConst<ReferenceError> Self>
void for_each_field(Self& its, const auto& visit) {
  visit("rmse", its.rmse);
  visit("maximum", its.maximum);
  visit("rays", its.rays);
}

template <MaybeConst<DecisionFlips> Self>
void for_each_field(Self& its, const auto& visit) {
  visit("decisions", its.decisions);
  visit("flipped", its.flipped);
  visit("extra_subdivisions", its.extra_subdivisions);
  visit("lost_subdivisions", its.lost_subdivisions);
}

template <MaybeConst<FormatError> Self>
void for_each_field(Self& its, const auto& visit) {
  visit("changed_pixels", its.changed_pixels);
  visit("psnr", its.psnr);
  visit("flips", its.flips);
}

template <MaybeConst<Outcome> Self>
void for_each_field(Self& its, const auto& visit) {
  visit("unfinished", its.unfinished);
  visit("counts", its.counts);
  visit("cycles", its.cycles);
  visit("image_sha256", its.image_sha256);
  visit("units", its.units);
  visit("parts", its.parts);
  visit("fifos", its.fifos);
  visit("bottleneck", its.bottleneck);
  visit("lower_bound", its.lower_bound);
  visit("critical_path", its.critical_path);
  visit("latency", its.latency);
  visit("latency_by_level", its.latency_by_level);
  visit("slowest", its.slowest);
  visit("error", its.error);
  visit("format_error", its.format_error);
  visit("host_seconds", its.host_seconds);
}

}  // namespace pyrasim
