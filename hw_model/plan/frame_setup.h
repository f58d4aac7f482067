// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "camera/view_vector.h"
#include "hw_model/machine_spec.h"
#include "hw_model/simulation_options.h"
#include "scene/scene.h"

namespace pyrasim::hw {

/// What every stage is made from, each taking what it needs: the machine's settings and the frame.
struct FrameSetup {
  const MachineSpec& spec;
  const Scene& scene;
  const SimulationOptions& options;
  const PixelWindow& window;
  const Intersector& intersector;  ///< outlives the stages
  const ViewVectors& view_vectors;
  Progress progress;  ///< told how much of the frame is stored
};

}  // namespace pyrasim::hw
