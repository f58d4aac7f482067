// SPDX-License-Identifier: Apache-2.0
#include "readers.h"

#include <nlohmann/json.hpp>
#include <string>

#include "error.h"
#include "image/png.h"
#include "json/json_file.h"
#include "mesh/load_mesh.h"
#include "mesh/mtl_file.h"
#include "mesh/split_mesh.h"
#include "render/pyramid_renderer.h"
#include "scene/load_scene.h"
#include "scene/nff_scene.h"
#include "texture/image_texture.h"

namespace pyrasim::fuzz {
namespace {

template <class Read>
void pass_over_mistakes(const Read& read) {
  try {
    read();
  } catch (const Error&) {
  }
}

/// What can be read can be rendered.
void render(Scene scene) {
  if (scene.objects.size() > 100) return;
  scene.camera.screen.columns = 3;
  scene.camera.screen.rows = 2;
  const SceneIntersector<double> intersector(scene);
  render_pyramids(scene, intersector, {.max_level = 1, .threads = 1});
}

}  // namespace

void read_scene(std::string_view bytes) {
  pass_over_mistakes([&] { render(pyrasim::read_scene("fuzz.json", parse_json(bytes, "fuzz.json"))); });
}

void read_obj(std::string_view bytes) {
  pass_over_mistakes([&] { split_mesh(read_mesh(bytes, "fuzz.obj"), true, true); });
}

void read_mtl(std::string_view bytes) {
  pass_over_mistakes([&] { pyrasim::read_mtl(bytes, "fuzz.mtl"); });
}

void read_nff(std::string_view bytes) {
  pass_over_mistakes([&] { render(pyrasim::read_nff(bytes, "fuzz.nff")); });
}

void read_png(std::string_view bytes) {
  pass_over_mistakes([&] {
    const ImageTexture texture(decode_png(bytes, "fuzz.png"), Wrap::repeat);
    TextureWork work;
    texture.mean({{{0.1, 0.2}, {0.9, 0.3}, {0.8, 1.7}, {-0.3, 0.6}}}, work);
  });
}

}  // namespace pyrasim::fuzz
