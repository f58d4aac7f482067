// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "json/json_reader.h"
#include "run/run.h"

namespace pyrasim {

/// A run as a file keeps it: the canonical JSON, and the names of scene, machine and the scene's objects.
nlohmann::ordered_json run_document(const Run& run, const Scene& scene);

/// How many of the scene's objects have a texture.
std::size_t textured_objects(const Scene& scene);

/// The run of such a document, but for its limit of cycles. Throws InputError.
Run read_run(const JsonReader& document);

}  // namespace pyrasim
