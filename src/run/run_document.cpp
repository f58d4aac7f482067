// SPDX-License-Identifier: Apache-2.0
#include "run/run_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

namespace pyrasim {

using nlohmann::ordered_json;

ordered_json run_document(const Run& run, const Scene& scene) {
  ordered_json document = canonical_json(run);
  document["scene"]["name"] = run.scene.name;
  document["machine"]["name"] = run.machine.name;
  if (!run.window) document.erase("window");
  ordered_json& names = document["objects"] = ordered_json::array();
  for (const Object& object : scene.objects) names.push_back(object.name);
  document["textured_objects"] = textured_objects(scene);
  return document;
}

std::size_t textured_objects(const Scene& scene) {
  return static_cast<std::size_t>(std::count_if(scene.objects.begin(), scene.objects.end(),
                                                [](const Object& object) { return object.texture != nullptr; }));
}

namespace {

Screen read_screen(const JsonReader& reader) {
  constexpr IntegerRange size{1, max_screen_size};
  constexpr NumberRange length{0, std::numeric_limits<double>::max(), true};
  return {static_cast<int>(reader.member("columns").integer(size)),
          static_cast<int>(reader.member("rows").integer(size)), reader.member("dx").number(length),
          reader.member("dy").number(length), reader.member("dz").number(length)};
}

PixelWindow read_window(const JsonReader& reader, const Screen& screen) {
  const auto number = [&](const char* key, int least, int most) {
    return static_cast<int>(reader.member(key).integer({least, most}));
  };
  const int column = number("x", 0, screen.columns - 1);
  const int row = number("y", 0, screen.rows - 1);
  return {column, row, number("columns", 1, screen.columns - column), number("rows", 1, screen.rows - row)};
}

}  // namespace

Run read_run(const JsonReader& document) {
  Run run;
  const JsonReader scene = document.member("scene");
  run.scene = {scene.member("name").string(), scene.member("sha256").string()};
  run.screen = read_screen(document.member("screen"));
  if (const auto window = document.find("window")) run.window = read_window(*window, run.screen);
  run.max_level = static_cast<int>(document.member("max_level").integer({0, max_level_limit}));
  run.edge = document.member("edge").choice<EdgePolicy>({{"mean", EdgePolicy::mean}, {"drop", EdgePolicy::drop}});
  run.texture = document.member("texture").choice<TextureFilter>(
      {{"integral", TextureFilter::integral}, {"point", TextureFilter::point}});
  const JsonReader formats = document.member("scalar");
  run.formats =
      parse_datapath_formats(fmt::format("view_vectors={},intersection={}", formats.member("view_vectors").string(),
                                         formats.member("intersection").string()));
  run.machine = hw::read_machine(document.member("machine"));
  run.engine = document.member("engine").choice<hw::Engine>(
      {{"decoupled", hw::Engine::decoupled}, {"lockstep", hw::Engine::lockstep}});
  return run;
}

}  // namespace pyrasim
