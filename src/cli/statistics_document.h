// SPDX-License-Identifier: Apache-2.0
// What --stats writes: one JSON document, described by docs/schemas/statistics.schema.json.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "cli/command.h"
#include "hw_model/processor.h"
#include "hw_model/trace/occupancy.h"

namespace pyrasim::cli {

/// Of a rendered frame.
nlohmann::ordered_json render_document(const std::string& scene, const Camera& camera, const Method& method,
                                       const DatapathFormats& formats, const Rendering& rendering);

/// Of a simulated frame. `occupancies`: of the processor's FIFOs, in their order.
nlohmann::ordered_json simulation_document(const std::string& scene, const Camera& camera,
                                           const hw::SimulationOptions& options, const hw::Processor& processor,
                                           const std::vector<hw::Occupancy>& occupancies);

/// The document as text. A name that is not UTF-8 shows with U+FFFD in its place.
std::string text_of(const nlohmann::ordered_json& document);

/// At the machine's clock.
double frames_per_second(const hw::Processor& processor);

/// The simulation's statistics as a short table for people.
std::string simulation_table(const std::string& scene, const Camera& camera, int max_level,
                             const hw::Processor& processor);

}  // namespace pyrasim::cli
