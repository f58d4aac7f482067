// SPDX-License-Identifier: Apache-2.0
#include "run/run.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "error.h"
#include "files/sha256.h"
#include "hw_model/machine_settings.h"
#include "hw_model/run_control.h"
#include "json/json_file.h"
#include "version.h"

namespace pyrasim {

using nlohmann::json;

std::string sha256_of_files(const std::vector<std::string>& files) {
  std::string digests;
  for (const std::string& file : files) {
    if (!std::filesystem::is_regular_file(file)) return {};
    try {
      digests += sha256(read_text(file));
    } catch (const Error&) {  // of the library
      throw;
    } catch (const std::runtime_error&) {  // the file has gone meanwhile
      return {};
    }
  }
  return sha256(digests);
}

json canonical_json(const Run& run) {
  const Screen& screen = run.screen;
  const PixelWindow window = run.rendered();
  return {
      {"scene", {{"sha256", run.scene.sha256}}},
      {"screen",
       {{"columns", screen.columns}, {"rows", screen.rows}, {"dx", screen.dx}, {"dy", screen.dy}, {"dz", screen.dz}}},
      {"window", {{"x", window.column}, {"y", window.row}, {"columns", window.columns}, {"rows", window.rows}}},
      {"method", "pyramid"},
      {"max_level", run.max_level},
      {"edge", name_of(run.edge)},
      {"texture", name_of(run.texture)},
      {"scalar",
       {{"view_vectors", run.formats.view_vectors.name()}, {"intersection", run.formats.intersection.name()}}},
      {"machine", json(hw::settings_document(run.machine))},
      {"engine", name_of(run.engine)},
      {"max_cycles", std::min(run.max_cycles, hw::longest_frame)},
      {"reference", run.reference}};
}

std::optional<std::string> run_key(const Run& run) {
  if (run.scene.sha256.empty()) return std::nullopt;
  return sha256(json{{"pyrasim", version()}, {"run", canonical_json(run)}}.dump());
}

double frames_per_second(const Run& run, hw::Cycle cycles) {
  return run.machine.clock_mhz * 1e6 / static_cast<double>(cycles);
}

std::string_view name_of(EdgePolicy edge) { return edge == EdgePolicy::mean ? "mean" : "drop"; }

std::string_view name_of(TextureFilter filter) { return filter == TextureFilter::integral ? "integral" : "point"; }

std::string_view name_of(hw::Engine engine) { return engine == hw::Engine::decoupled ? "decoupled" : "lockstep"; }

}  // namespace pyrasim
