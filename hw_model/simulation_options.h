// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>

#include "hw_model/cycle.h"
#include "intersect/datapath_formats.h"
#include "intersect/intersector.h"
#include "pyramid/terminal_color.h"
#include "render/cost_maps.h"
#include "render/parallel.h"

namespace pyrasim::hw {

class RecordedTextures;

enum class Engine : std::uint8_t {
  decoupled,  ///< stages run ahead in their own time; fast
  lockstep,   ///< every advance of time is a wait on the SystemC kernel; slow, and the oracle
};

struct SimulationOptions {
  int max_level = 3;
  EdgePolicy edge = EdgePolicy::mean;
  TextureFilter texture = TextureFilter::integral;
  Engine engine = Engine::decoupled;
  DatapathFormats formats;
  /// Of the scene in formats.intersection; none: the machine makes its own.
  std::shared_ptr<const Intersector> intersector;
  /// Of a frame whose intersector is a RecordedScene: what its nodes took of textures. None: as the scene says.
  std::shared_ptr<const RecordedTextures> textures;
  Cycle max_cycles = never;   ///< the machine stops once it cannot end within so many
  int threads = 1;            ///< of the host: from 2 on, one traces corners ahead for the decoupled engine
  CostMaps* maps = nullptr;   ///< of the window, to be filled; they outlive the machine
  bool check_machine = true;  ///< refuse a machine that cannot hold the frame; off only to see it deadlock
  Progress progress;
};

}  // namespace pyrasim::hw
