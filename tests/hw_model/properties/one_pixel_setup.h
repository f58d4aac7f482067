// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "../../test_scenes.h"
#include "hw_model/plan/frame_setup.h"

namespace pyrasim::hw {

/// What a stage by itself is made from: a frame of one pixel without objects.
struct OnePixelSetup {
  MachineSpec spec;
  SimulationOptions options;
  Scene scene = empty_scene(1, 1, 1);
  PixelWindow window = scene.camera.rendered();
  std::shared_ptr<const Intersector> intersector = make_intersector(scene, options.formats.intersection);
  ViewVectors view_vectors{scene.camera.screen, 1, options.formats.view_vectors};

  FrameSetup frame() const { return {spec, scene, options, window, *intersector, view_vectors, {}}; }
};

}  // namespace pyrasim::hw
