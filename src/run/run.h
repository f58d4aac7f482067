// SPDX-License-Identifier: Apache-2.0
// A run as a value: all that decides what a simulation gives.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hw_model/machine_spec.h"
#include "hw_model/simulation_options.h"
#include "intersect/datapath_formats.h"
#include "pyramid/terminal_color.h"
#include "scene/scene.h"

namespace pyrasim {

/// A scene as it was read.
struct SceneFiles {
  std::string name;    ///< the scene file's, as the user gave it
  std::string sha256;  ///< of what it was read from, see sha256_of_files()
};

/// SHA-256 of the bytes of `files`, each in its place; empty where one cannot be read again, as a pipe.
std::string sha256_of_files(const std::vector<std::string>& files);

/// Scene, frame, method and machine. What a host needs beside it (threads, say) is no part of it: no result depends on
/// that.
struct Run {
  SceneFiles scene;
  Screen screen;  ///< in place of the scene's own
  std::optional<PixelWindow> window;
  int max_level = 3;
  EdgePolicy edge = EdgePolicy::mean;
  TextureFilter texture = TextureFilter::integral;
  DatapathFormats formats;
  hw::MachineSpec machine;
  hw::Engine engine = hw::Engine::decoupled;
  hw::Cycle max_cycles = hw::never;
  std::string reference = "none";  ///< what the picture is measured against, by its method's name

  PixelWindow rendered() const { return window.value_or(PixelWindow{0, 0, screen.columns, screen.rows}); }
};

/// All settings in effect, as one document with sorted keys. What only names something, the scene file and the machine,
/// is left out.
nlohmann::json canonical_json(const Run& run);

/// SHA-256 of the canonical JSON, in which the scene stands as that of its bytes, and of the program's version: runs of
/// one key have equal outcomes. None where the scene could be read once only: nobody knows whether it is the same.
std::optional<std::string> run_key(const Run& run);

/// Of a frame that takes so many cycles, at the machine's clock.
double frames_per_second(const Run& run, hw::Cycle cycles);

std::string_view name_of(EdgePolicy edge);       ///< "mean", "drop"
std::string_view name_of(TextureFilter filter);  ///< "integral", "point"
std::string_view name_of(hw::Engine engine);     ///< "decoupled", "lockstep"

}  // namespace pyrasim
