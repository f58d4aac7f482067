// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "hw_model/record/recorded_textures.h"
#include "intersect/intersector.h"
#include "run/executor.h"
#include "run/run.h"

namespace pyrasim {

/// A run whose work was recorded. It can be made again without its scene, on any machine.
struct RecordedRun {
  Run run;
  hw::Cycle cycles = 0;
  std::string image_sha256;
  std::string picture;  ///< PNG
  DatapathEvents arithmetic;
  std::shared_ptr<const Scene> scene;  ///< as many objects as there were, of which nothing is known but their names
  std::shared_ptr<const Intersector> intersector;        ///< a RecordedScene
  std::shared_ptr<const hw::RecordedTextures> textures;  ///< where the scene had some

  /// The frame on `machine`: its outcome is that of the true run there.
  Task on(const hw::MachineSpec& machine) const;
};

/// Throws InputError where the frame of `file`, made again on its own machine, came to another outcome: the program
/// that wrote it was another one.
void require_same_cycles(const std::string& file, const RecordedRun& recorded, const Outcome& outcome);

/// Of a run of `scene` that was just made. Without its picture.
RecordedRun recorded_run(const Run& run, const Scene& scene, const SceneContents& contents, const Outcome& outcome,
                         const hw::RecordedWork& work);

/// Reads a .ptrace file. Throws InputError where it is none, is damaged, or was broken off.
RecordedRun load_recorded_run(const std::filesystem::path& file);

}  // namespace pyrasim
