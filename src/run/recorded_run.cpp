// SPDX-License-Identifier: Apache-2.0
#include "run/recorded_run.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "error.h"
#include "hw_model/record/chunk_reader.h"
#include "hw_model/record/recorded_scene.h"
#include "json/json_file.h"
#include "pyramid/cell.h"
#include "run/outcome_fields.h"
#include "run/run_document.h"
#include "text/counted.h"

namespace pyrasim {
namespace {

constexpr IntegerRange count{0};

std::size_t size_of(const JsonReader& reader) { return static_cast<std::size_t>(reader.integer(count)); }

SceneContents read_contents(const JsonReader& reader) {
  SceneContents contents;
  const JsonReader surfaces = reader.member("surfaces");
  for (std::size_t kind = 0; kind < surface_kinds; ++kind) {
    contents.surfaces[kind] = size_of(surfaces.member(surface_traits[kind].name));
  }
  contents.inner_nodes = size_of(reader.member("inner_nodes"));
  contents.shadow_inner_nodes = size_of(reader.member("shadow_inner_nodes"));
  contents.lights_with_shadows =
      static_cast<std::size_t>(reader.member("lights_with_shadows").integer({0, max_shadow_lights}));
  return contents;
}

ArithmeticEvents read_events(const JsonReader& reader) {
  ArithmeticEvents events;
  for_each_field(events, [&](const char* key, std::uint64_t& number) {
    number = static_cast<std::uint64_t>(reader.member(key).integer(count));
  });
  return events;
}

std::vector<std::string> read_names(const JsonReader& reader) {
  std::vector<std::string> names;
  for (const JsonReader& name : reader.elements()) names.push_back(name.string());
  return names;
}

/// A file's content, as far as it is there.
struct Content {
  nlohmann::json header;
  SceneContents contents;
  hw::WorkTable rays{1};
  hw::WorkTable nodes{hw::NodeColumns::size};
  std::optional<std::string> picture;
  nlohmann::json end;  ///< null: it was broken off
};

/// Takes what is in a chunk behind the header; whether one such as it may be there.
bool take(Content& content, const hw::Chunk& chunk, const std::string& name) {
  switch (chunk.type) {
    case hw::ChunkType::header:
      return false;
    case hw::ChunkType::rays:
      return content.rays.add_packed(chunk.content);
    case hw::ChunkType::nodes:
      return content.nodes.add_packed(chunk.content);
    case hw::ChunkType::image:
      return !std::exchange(content.picture, chunk.content);
    case hw::ChunkType::end:
      content.end = parse_json(chunk.content, name);
      return true;
    default:  // unknown
      return true;
  }
}

Content read(const std::filesystem::path& file) {
  const std::string name = file.string();
  hw::ChunkReader chunks(file);
  const auto first = chunks.next();
  if (!first || first->type != hw::ChunkType::header) {
    throw InputError(fmt::format("{}: it has no header; it has to be as simulate wrote it", name));
  }
  Content content;
  content.header = parse_json(first->content, name);
  const JsonReader header(name, content.header);
  content.contents = read_contents(header.member("contents"));
  const hw::RayColumns columns(content.contents);
  const JsonReader names = header.member("columns");
  if (read_names(names.member("rays")) != columns.names() ||
      read_names(names.member("nodes")) != hw::NodeColumns::names()) {
    names.fail("they are those of another version", "a file of this version's simulate is allowed");
  }
  content.rays = hw::WorkTable(columns.size());
  while (const auto chunk = chunks.next()) {
    if (!take(content, *chunk, name)) hw::fail_damaged(name);
    if (chunk->type == hw::ChunkType::end && !(chunks.at_end() && content.picture)) hw::fail_damaged(name);
  }
  return content;
}

/// As many as there were, without what they are.
std::shared_ptr<const Scene> scene_of(const std::vector<std::string>& objects) {
  Scene scene;
  for (const std::string& name : objects) scene.objects.push_back({name, {}, {}});
  return std::make_shared<const Scene>(std::move(scene));
}

hw::PointTable points_of(const hw::WorkTable& rows, const Run& run) { return {rows, run.rendered(), run.max_level}; }

/// What stands for the scene: `name` in messages, of `textured` objects with a texture.
void set_work(RecordedRun& recorded, const std::string& name, const SceneContents& contents, hw::PointTable rays,
              const hw::WorkTable& nodes, std::size_t textured) {
  const Run& run = recorded.run;
  if (textured > 0) {
    recorded.textures = std::make_shared<const hw::RecordedTextures>(textured, points_of(nodes, run));
  }
  recorded.intersector = std::make_shared<const hw::RecordedScene>(
      name, contents, ViewVectors(run.screen, std::int64_t{1} << run.max_level), std::move(rays));
}

void require_whole(const std::string& name, const Content& content) {
  if (!content.end.is_null() && JsonReader(name, content.end).member("complete").boolean()) return;
  throw InputError(fmt::format("{}: the run was broken off, {} {} recorded; a trace of a whole frame is needed", name,
                               counted(content.rays.rows(), "ray"), of_number(content.rays.rows(), "is", "are")));
}

/// No ray saw one that is not there.
void require_objects(const std::string& name, const hw::WorkTable& rays, std::size_t objects) {
  for (std::size_t k = 0; k < rays.rows(); ++k) {
    if (hw::RayColumns::object(rays.row(k)) > objects) hw::fail_damaged(name);
  }
}

/// Fewer rays than corners are no frame, however large it claims to be: noticed before that takes memory.
void require_rays(const JsonReader& header, std::size_t rays, const PixelWindow& window) {
  if (rays / (static_cast<std::size_t>(window.columns) + 1) > static_cast<std::size_t>(window.rows)) return;
  header.fail(fmt::format("{} recorded, and a frame of {}x{} pixels has more corners", counted(rays, "ray"),
                          window.columns, window.rows),
              "the file has to be as simulate wrote it");
}

/// Every frame traces the corners of its raster.
void require_corners(const JsonReader& header, const hw::PointTable& rays, const Run& run) {
  const PixelWindow window = run.rendered();
  for (int row = 0; row <= window.rows; ++row) {
    for (int column = 0; column <= window.columns; ++column) {
      const GridPoint corner =
          pixel_cell(window, static_cast<std::uint32_t>(row), static_cast<std::uint32_t>(column), run.max_level).corner;
      if (rays.find(corner) != nullptr) continue;
      header.fail(fmt::format("no ray through row {}, column {} of the grid is recorded", corner.row, corner.column),
                  "the file has to be as simulate wrote it");
    }
  }
}

}  // namespace

RecordedRun load_recorded_run(const std::filesystem::path& file) {
  const std::string name = file.string();
  Content content = read(file);
  require_whole(name, content);
  const JsonReader header(name, content.header);
  const JsonReader end(name, content.end);
  if (size_of(end.member("rays")) != content.rays.rows() || size_of(end.member("nodes")) != content.nodes.rows()) {
    end.fail("rays or nodes are missing", "the file has to be as simulate wrote it");
  }
  RecordedRun recorded;
  const JsonReader run = header.member("run");
  recorded.run = read_run(run);
  recorded.cycles = static_cast<hw::Cycle>(end.member("cycles").integer(count));
  recorded.picture = std::move(*content.picture);
  recorded.image_sha256 = end.member("image_sha256").string();
  const JsonReader arithmetic = end.member("arithmetic");
  recorded.arithmetic = {read_events(arithmetic.member("view_vectors")),
                         read_events(arithmetic.member("intersection"))};
  recorded.scene = scene_of(read_names(run.member("objects")));
  require_objects(name, content.rays, recorded.scene->objects.size());
  require_rays(header, content.rays.rows(), recorded.run.rendered());
  hw::PointTable rays = points_of(content.rays, recorded.run);
  require_corners(header, rays, recorded.run);
  set_work(recorded, name, content.contents, std::move(rays), content.nodes, size_of(run.member("textured_objects")));
  return recorded;
}

RecordedRun recorded_run(const Run& run, const Scene& scene, const SceneContents& contents, const Outcome& outcome,
                         const hw::RecordedWork& work) {
  std::vector<std::string> names;
  for (const Object& object : scene.objects) names.push_back(object.name);
  RecordedRun recorded{run, outcome.cycles, outcome.image_sha256, {}, outcome.counts.arithmetic, scene_of(names), {},
                       {}};
  set_work(recorded, "the recorded frame", contents, points_of(work.rays, run), work.nodes, textured_objects(scene));
  return recorded;
}

void require_same_cycles(const std::string& file, const RecordedRun& recorded, const Outcome& outcome) {
  if (outcome.cycles == recorded.cycles) return;
  throw InputError(
      fmt::format("{}: its frame took {}, and takes {} when it is made again; a file of this "
                  "version's simulate is allowed",
                  file, counted(recorded.cycles, "cycle"), outcome.cycles));
}

Task RecordedRun::on(const hw::MachineSpec& machine) const {
  Task task{run, scene, intersector};
  task.textures = textures;
  task.run.machine = machine;
  task.run.formats = {};  // what rays saw is known
  task.measure = [sha256 = image_sha256, events = arithmetic](const Simulation&, Outcome& outcome) {
    outcome.image_sha256 = sha256;
    outcome.counts.arithmetic = events;
  };
  return task;
}

}  // namespace pyrasim
