// SPDX-License-Identifier: Apache-2.0
#include "cli/statistics_document.h"

#include <nlohmann/json.hpp>

#include "hw_model/machine_settings.h"
#include "hw_model/report/bottleneck.h"
#include "image/image_hash.h"
#include "version.h"

namespace pyrasim::cli {
namespace {

using nlohmann::ordered_json;

ordered_json head(const std::string& scene, const Camera& camera, const std::string& method, int max_level,
                  const DatapathFormats& formats, EdgePolicy edge) {
  ordered_json document{{"pyrasim", version()},
                        {"command", command_line()},
                        {"scene", scene},
                        {"method", method},
                        {"max_level", max_level},
                        {"edge", edge == EdgePolicy::mean ? "mean" : "drop"},
                        {"scalar", formats.name()},
                        {"columns", camera.screen.columns},
                        {"rows", camera.screen.rows}};
  if (camera.window) {
    document["window"] = {{"x", camera.window->column},
                          {"y", camera.window->row},
                          {"columns", camera.window->columns},
                          {"rows", camera.window->rows}};
  }
  return document;
}

void add_counts(ordered_json& document, const FrameStatistics& statistics, int max_level) {
  ordered_json rays_by_level = ordered_json::array();
  ordered_json cases_by_level = ordered_json::array();
  for (std::size_t level = 0; level <= static_cast<std::size_t>(max_level); ++level) {
    rays_by_level.push_back(statistics.rays_by_level[level]);
    const auto& cases = statistics.cases_by_level[level];
    cases_by_level.push_back({{"empty", cases[static_cast<std::size_t>(PyramidCase::empty)]},
                              {"covered", cases[static_cast<std::size_t>(PyramidCase::covered)]},
                              {"edge", cases[static_cast<std::size_t>(PyramidCase::edge)]}});
  }
  document["rays"] = {{"primary", statistics.primary_rays()},
                      {"subdivision", statistics.subdivision_rays_traced()},
                      {"total", statistics.total_rays()},
                      {"by_level", rays_by_level}};
  document["cases"] = {{"by_level", cases_by_level}};
  document["subdivisions"] = statistics.subdivisions;
  document["terminal_nodes"] = statistics.terminal_nodes;
  ordered_json surface_tests = ordered_json::object();
  for (std::size_t kind = 0; kind < surface_kinds; ++kind) {
    surface_tests[std::string(surface_traits[kind].name)] = statistics.work.surface_tests[kind];
  }
  document["work"] = {{"box_tests", statistics.work.box_tests}, {"surface_tests", surface_tests}};
}

ordered_json events_document(const ArithmeticEvents& events) {
  return {{"saturations", events.saturations},
          {"underflows", events.underflows},
          {"inexact", events.inexact},
          {"divisions_by_zero", events.divisions_by_zero},
          {"invalid", events.invalid}};
}

/// The processor's own formats are not watched.
void add_events(ordered_json& document, const DatapathEvents& events, const DatapathFormats& formats) {
  if (!formats.counts_events()) return;
  const auto add = [&](const char* stage, const NumberFormat& format, const ArithmeticEvents& counted) {
    if (format.kind != NumberKind::processor) document["arithmetic"][stage] = events_document(counted);
  };
  add("view_vectors", formats.view_vectors, events.view_vectors);
  add("intersection", formats.intersection, events.intersection);
}

ordered_json machine_document(const hw::Processor& processor) {
  const hw::MachineSpec& spec = processor.spec();
  ordered_json omitted = ordered_json::array();
  for (const hw::OmittedUnit& unit : processor.omitted()) {
    omitted.push_back({{"name", unit.name}, {"reason", unit.reason}});
  }
  ordered_json elaborated = ordered_json::array();
  for (const hw::Stage* stage : processor.stages()) elaborated.push_back(stage->basename());
  return {{"name", spec.name},
          {"settings", hw::settings_document(spec)},
          {"settings_sha256", hw::settings_sha256(spec)},
          {"clock_mhz", spec.clock_mhz},
          {"cycles", processor.cycles()},
          {"frames_per_second", frames_per_second(processor)},
          {"budget",
           {{"goal_fps", spec.goal_fps}, {"cycles", spec.budget()}, {"met", processor.cycles() <= spec.budget()}}},
          {"elaborated", elaborated},
          {"omitted", omitted}};
}

ordered_json waits_document(const hw::Processor& processor, const hw::Stage& stage) {
  ordered_json waits = ordered_json::array();
  for (const hw::Wait& wait : hw::waits(processor, stage)) {
    waits.push_back(
        {{"fifo", wait.fifo->basename()}, {"for", wait.starved ? "token" : "room"}, {"cycles", wait.cycles}});
  }
  return waits;
}

ordered_json units_document(const hw::Processor& processor) {
  ordered_json units = ordered_json::array();
  for (const hw::Stage* stage : processor.stages()) {
    const hw::StageStatistics statistics = stage->statistics(processor.cycles());
    units.push_back({{"name", stage->basename()},
                     {"busy", statistics.busy},
                     {"starved", statistics.starved},
                     {"blocked", statistics.blocked},
                     {"idle", statistics.idle},
                     {"waits", waits_document(processor, *stage)}});
  }
  return units;
}

/// Where the frame's cycles went: the chain of causes, and how far the machine is from what its work imposes.
ordered_json bottleneck_document(const hw::Processor& processor) {
  ordered_json chain = ordered_json::array();
  for (const hw::BottleneckLink& link : hw::bottleneck_chain(processor)) {
    chain.push_back({{"unit", link.unit}, {"busy", link.busy}});
    if (link.waited > 0) chain.back()[link.starved ? "starved_by_next" : "blocked_by_next"] = link.waited;
  }
  const hw::LowerBound bound = hw::lower_bound(processor);
  return {{"chain", chain}, {"lower_bound", {{"unit", bound.unit}, {"cycles", bound.cycles}}}};
}

ordered_json latency_document(const hw::LatencyHistogram& histogram) {
  ordered_json classes = ordered_json::array();
  histogram.for_each_class([&](hw::Cycle last, std::uint64_t pixels) {
    classes.push_back({{"up_to", last}, {"pixels", pixels}});
  });
  return {{"pixels", histogram.count()},
          {"mean", histogram.mean()},
          {"p50", histogram.percentile(0.5)},
          {"p90", histogram.percentile(0.9)},
          {"p99", histogram.percentile(0.99)},
          {"max", histogram.max()},
          {"histogram", classes}};
}

ordered_json latencies_document(const hw::Processor& processor, int max_level) {
  ordered_json by_level = ordered_json::array();
  hw::LatencyHistogram all;
  for (std::size_t level = 0; level <= static_cast<std::size_t>(max_level); ++level) {
    const hw::LatencyHistogram& histogram = processor.tree_accumulator().latencies()[level];
    by_level.push_back(latency_document(histogram));
    all += histogram;
  }
  ordered_json slowest = ordered_json::array();
  for (const hw::FinishedPixel& pixel : processor.tree_accumulator().slowest().list()) {
    const auto [row, column] = processor.place_of(pixel.pixel);
    slowest.push_back({{"row", row}, {"column", column}, {"cycles", pixel.latency}, {"level", pixel.deepest}});
  }
  return {{"all", latency_document(all)}, {"by_level", by_level}, {"slowest", slowest}};
}

ordered_json fifos_document(const hw::Processor& processor, const std::vector<hw::Occupancy>& occupancies) {
  ordered_json fifos = ordered_json::array();
  for (std::size_t k = 0; k < processor.fifos().size(); ++k) {
    const hw::FifoBase* fifo = processor.fifos()[k];
    const hw::FifoStatistics statistics = fifo->statistics(processor.cycles());
    const double mean = static_cast<double>(statistics.token_cycles) / static_cast<double>(processor.cycles());
    fifos.push_back(
        {{"name", fifo->basename()},
         {"depth", statistics.depth},
         {"max", statistics.max},
         {"mean", mean},
         {"tokens", statistics.tokens},
         {"reader_starved", statistics.starved},
         {"writer_blocked", statistics.blocked},
         {"occupancy", {{"stride", occupancies[k].stride()}, {"tokens", occupancies[k].points(processor.cycles())}}}});
  }
  return fifos;
}

}  // namespace

double frames_per_second(const hw::Processor& processor) {
  return processor.spec().clock_mhz * 1e6 / static_cast<double>(processor.cycles());
}

std::string text_of(const ordered_json& document) {
  return document.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

ordered_json render_document(const std::string& scene, const Camera& camera, const Method& method,
                             const DatapathFormats& formats, const Rendering& rendering) {
  const int max_level = method.pyramid ? method.pyramids.max_level : 0;
  const FrameStatistics& statistics = rendering.statistics;
  ordered_json document = head(scene, camera, method.name(), max_level, formats, method.pyramids.edge);
  add_counts(document, statistics, max_level);
  add_events(document, statistics.arithmetic, formats);
  const std::uint64_t none = statistics.primary_rays() + subdivision_rays * statistics.subdivisions;
  const std::uint64_t pixel = none - statistics.repeated_in_pixel;
  document["rays_by_reuse"] = {{"none", none}, {"pixel", pixel}, {"frame", pixel - statistics.repeated_between_pixels}};
  document["image"] = {{"sha256", image_sha256(rendering.image)}};
  return document;
}

ordered_json simulation_document(const std::string& scene, const Camera& camera, const hw::SimulationOptions& options,
                                 const hw::Processor& processor, const std::vector<hw::Occupancy>& occupancies) {
  ordered_json document = head(scene, camera, "pyramid", options.max_level, options.formats, options.edge);
  document["engine"] = options.engine == hw::Engine::decoupled ? "decoupled" : "lockstep";
  add_counts(document, processor.statistics(), options.max_level);
  add_events(document, processor.statistics().arithmetic, options.formats);
  document["rays_by_reuse"] = {{"none", processor.statistics().total_rays()}};
  document["image"] = {{"sha256", image_sha256(processor.image())}};
  document["machine"] = machine_document(processor);
  document["units"] = units_document(processor);
  document["fifos"] = fifos_document(processor, occupancies);
  document["bottleneck"] = bottleneck_document(processor);
  document["pixel_latency"] = latencies_document(processor, options.max_level);
  return document;
}

}  // namespace pyrasim::cli
