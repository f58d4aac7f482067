// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>

#include "files/output_file.h"
#include "hw_model/view/frame_tables.h"

namespace pyrasim::hw {

/// A run as the trace page holds it: of `processor`, whose frame of `cycles` is over or was broken off. `run` describes
/// scene and settings, `name` tells it from another run of the page, `picture` is a PNG file's bytes.
std::string page_run(const Processor& processor, const FrameTables& tables, Cycle cycles,
                     const nlohmann::ordered_json& run, const std::string& name, std::string_view picture);

/// Writes the trace page of one run or of two: a HTML file that needs nothing beside itself.
void write_page(OutputFile& output, std::span<const std::string> runs);

}  // namespace pyrasim::hw
