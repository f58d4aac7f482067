// SPDX-License-Identifier: Apache-2.0
#include "cli/statistics_document.h"

#include <nlohmann/json.hpp>

#include "hw_model/machine_settings.h"
#include "image/image_hash.h"
#include "numeric/arithmetic_events_json.h"
#include "version.h"

namespace pyrasim::cli {
namespace {

using nlohmann::ordered_json;

ordered_json head(const std::string& scene, const Screen& screen, const std::optional<PixelWindow>& window,
                  const std::string& method, int max_level, const DatapathFormats& formats, EdgePolicy edge,
                  TextureFilter texture) {
  ordered_json document{{"pyrasim", version()},
                        {"command", command_line()},
                        {"scene", scene},
                        {"method", method},
                        {"max_level", max_level},
                        {"edge", name_of(edge)},
                        {"texture", name_of(texture)},
                        {"scalar", formats.name()},
                        {"columns", screen.columns},
                        {"rows", screen.rows}};
  if (window) {
    document["window"] = {
        {"x", window->column}, {"y", window->row}, {"columns", window->columns}, {"rows", window->rows}};
  }
  return document;
}

ordered_json tests_document(const Tests& tests) {
  ordered_json surface_tests = ordered_json::object();
  for (std::size_t kind = 0; kind < surface_kinds; ++kind) {
    surface_tests[std::string(surface_traits[kind].name)] = tests.surface_tests[kind];
  }
  return {{"box_tests", tests.box_tests}, {"surface_tests", surface_tests}};
}

/// By light: of those with shadows.
ordered_json shadow_rays_document(const FrameStatistics& statistics) {
  const ShadowWork& work = statistics.work.shadow;
  ordered_json by_light = ordered_json::array();
  for (std::size_t light = 0; light < statistics.lights_with_shadows; ++light) by_light.push_back(work.rays[light]);
  return {{"total", work.total_rays()}, {"by_light", by_light}};
}

void add_counts(ordered_json& document, const FrameStatistics& statistics, int max_level) {
  ordered_json rays_by_level = ordered_json::array();
  ordered_json cases_by_level = ordered_json::array();
  for (std::size_t level = 0; level <= static_cast<std::size_t>(max_level); ++level) {
    rays_by_level.push_back(statistics.rays_by_level[level]);
    const auto& cases = statistics.cases_by_level[level];
    ordered_json counts = ordered_json::object();
    for (const PyramidCase which : {PyramidCase::empty, PyramidCase::covered, PyramidCase::edge}) {
      const auto k = static_cast<std::size_t>(which);
      counts[pyramid_case_names[k]] = cases[k];
    }
    cases_by_level.push_back(std::move(counts));
  }
  document["rays"] = {{"primary", statistics.primary_rays()},
                      {"subdivision", statistics.subdivision_rays_traced()},
                      {"total", statistics.total_rays()},
                      {"by_level", rays_by_level},
                      {"shadow", shadow_rays_document(statistics)}};
  document["cases"] = {{"by_level", cases_by_level}};
  document["subdivisions"] = statistics.subdivisions;
  document["terminal_nodes"] = statistics.terminal_nodes;
  document["work"] = tests_document(statistics.work);
  document["work"]["shadow"] = tests_document(statistics.work.shadow.tests);
  document["work"]["texture"] = {{"places", statistics.texture.places},
                                 {"lines", statistics.texture.lines},
                                 {"texels", statistics.texture.texels}};
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

ordered_json machine_document(const Run& run, const Outcome& outcome) {
  const hw::MachineSpec& spec = run.machine;
  ordered_json omitted = ordered_json::array();
  for (const hw::MachinePart& part : outcome.parts) {
    if (part.units == 0) omitted.push_back({{"name", part.name()}, {"reason", part.reason}});
  }
  ordered_json elaborated = ordered_json::array();
  for (const UnitAccount& unit : outcome.units) elaborated.push_back(unit.name);
  return {
      {"name", spec.name},
      {"settings", hw::settings_document(spec)},
      {"settings_sha256", hw::settings_sha256(spec)},
      {"clock_mhz", spec.clock_mhz},
      {"cycles", outcome.cycles},
      {"frames_per_second", frames_per_second(run, outcome.cycles)},
      {"budget", {{"goal_fps", spec.goal_fps}, {"cycles", spec.budget()}, {"met", outcome.cycles <= spec.budget()}}},
      {"elaborated", elaborated},
      {"omitted", omitted}};
}

ordered_json waits_document(const std::vector<WaitAccount>& list) {
  ordered_json waits = ordered_json::array();
  for (const WaitAccount& wait : list) {
    waits.push_back({{"fifo", wait.fifo}, {"for", wait.starved ? "token" : "room"}, {"cycles", wait.cycles}});
  }
  return waits;
}

ordered_json units_document(const Outcome& outcome) {
  ordered_json units = ordered_json::array();
  for (const UnitAccount& unit : outcome.units) {
    units.push_back({{"name", unit.name},
                     {"busy", unit.cycles.busy},
                     {"starved", unit.cycles.starved},
                     {"blocked", unit.cycles.blocked},
                     {"idle", unit.cycles.idle},
                     {"waits", waits_document(unit.waits)}});
  }
  return units;
}

/// Where the frame's cycles went: the chain of causes, and how far the machine is from what its work imposes.
ordered_json bottleneck_document(const Outcome& outcome) {
  ordered_json chain = ordered_json::array();
  for (const hw::BottleneckLink& link : outcome.bottleneck) {
    chain.push_back({{"unit", link.unit}, {"busy", link.busy}});
    if (link.waited > 0) chain.back()[link.starved ? "starved_by_next" : "blocked_by_next"] = link.waited;
  }
  const hw::LowerBound& bound = outcome.lower_bound;
  ordered_json document{{"chain", chain}, {"lower_bound", {{"unit", bound.unit}, {"cycles", bound.cycles}}}};
  for (const auto& [owed, place, cycles] : outcome.critical_path) {
    document["critical_path"].push_back({{"owed", owed}, {"place", place}, {"cycles", cycles}});
  }
  return document;
}

ordered_json latency_document(const LatencyAccount& latency) {
  ordered_json classes = ordered_json::array();
  for (const auto& [up_to, pixels] : latency.classes) classes.push_back({{"up_to", up_to}, {"pixels", pixels}});
  return {{"pixels", latency.pixels}, {"mean", latency.mean}, {"p50", latency.p50},  {"p90", latency.p90},
          {"p99", latency.p99},       {"max", latency.max},   {"histogram", classes}};
}

ordered_json latencies_document(const Outcome& outcome, int max_level) {
  ordered_json by_level = ordered_json::array();
  for (std::size_t level = 0; level <= static_cast<std::size_t>(max_level); ++level) {
    by_level.push_back(latency_document(outcome.latency_by_level[level]));
  }
  ordered_json slowest = ordered_json::array();
  for (const SlowPixel& pixel : outcome.slowest) {
    slowest.push_back({{"row", pixel.row}, {"column", pixel.column}, {"cycles", pixel.cycles}, {"level", pixel.level}});
  }
  return {{"all", latency_document(outcome.latency)}, {"by_level", by_level}, {"slowest", slowest}};
}

ordered_json fifos_document(const Outcome& outcome) {
  ordered_json fifos = ordered_json::array();
  for (const FifoAccount& fifo : outcome.fifos) {
    const double mean = static_cast<double>(fifo.use.token_cycles) / static_cast<double>(outcome.cycles);
    fifos.push_back({{"name", fifo.name},
                     {"depth", fifo.use.depth},
                     {"max", fifo.use.max},
                     {"mean", mean},
                     {"tokens", fifo.use.tokens},
                     {"reader_starved", fifo.use.starved},
                     {"writer_blocked", fifo.use.blocked},
                     {"occupancy", {{"stride", fifo.occupancy.stride}, {"tokens", fifo.occupancy.tokens}}}});
  }
  return fifos;
}

}  // namespace

std::string text_of(const ordered_json& document) {
  return document.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

ordered_json render_document(const std::string& scene, const Camera& camera, const Method& method,
                             const DatapathFormats& formats, const Rendering& rendering) {
  const int max_level = method.pyramid ? method.pyramids.max_level : 0;
  const FrameStatistics& statistics = rendering.statistics;
  ordered_json document = head(scene, camera.screen, camera.window, method.name(), max_level, formats,
                               method.pyramids.edge, method.pyramids.texture);
  add_counts(document, statistics, max_level);
  add_events(document, statistics.arithmetic, formats);
  const std::uint64_t none = statistics.primary_rays() + subdivision_rays * statistics.subdivisions;
  const std::uint64_t pixel = none - statistics.repeated_in_pixel;
  document["rays_by_reuse"] = {{"none", none}, {"pixel", pixel}, {"frame", pixel - statistics.repeated_between_pixels}};
  document["image"] = {{"sha256", image_sha256(rendering.image)}};
  return document;
}

ordered_json simulation_document(const Run& run, const Outcome& outcome) {
  ordered_json document =
      head(run.scene.name, run.screen, run.window, "pyramid", run.max_level, run.formats, run.edge, run.texture);
  document["engine"] = name_of(run.engine);
  add_counts(document, outcome.counts, run.max_level);
  add_events(document, outcome.counts.arithmetic, run.formats);
  document["rays_by_reuse"] = {{"none", outcome.counts.total_rays()}};
  document["image"] = {{"sha256", outcome.image_sha256}};
  document["machine"] = machine_document(run, outcome);
  document["units"] = units_document(outcome);
  document["fifos"] = fifos_document(outcome);
  document["bottleneck"] = bottleneck_document(outcome);
  document["pixel_latency"] = latencies_document(outcome, run.max_level);
  return document;
}

}  // namespace pyrasim::cli
