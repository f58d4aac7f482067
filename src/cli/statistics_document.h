// SPDX-License-Identifier: Apache-2.0
// What --stats writes: one JSON document, described by docs/schemas/statistics.schema.json.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "cli/command.h"
#include "run/outcome.h"
#include "run/run.h"

namespace pyrasim::cli {

/// Of a rendered frame.
nlohmann::ordered_json render_document(const std::string& scene, const Camera& camera, const Method& method,
                                       const DatapathFormats& formats, const Rendering& rendering);

/// Of a simulated frame.
nlohmann::ordered_json simulation_document(const Run& run, const Outcome& outcome);

/// The document as text. A name that is not UTF-8 shows with U+FFFD in its place.
std::string text_of(const nlohmann::ordered_json& document);

/// The simulation's statistics as a short table for people.
std::string simulation_table(const Run& run, const Outcome& outcome);

/// The machine's boxes and their parts as a table for people: which were built, why, and what they cost.
std::string parts_table(const Outcome& outcome);

}  // namespace pyrasim::cli
