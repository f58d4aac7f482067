// SPDX-License-Identifier: Apache-2.0
#include "cli/pixel_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "cli/frame_table.h"
#include "hw_model/plan/is_one_of.h"
#include "image/srgb.h"
#include "pyramid/classifier.h"
#include "text/printable.h"

namespace pyrasim::cli {
namespace {

constexpr std::array<std::string_view, 4> corner_names{"upper left", "upper right", "lower left", "lower right"};
constexpr std::array<std::string_view, subdivision_rays> point_names{"top", "left", "centre", "right", "bottom"};

/// A pixel's tree as lines of text, one for each node and ray.
class Tree {
 public:
  Tree(const Scene& scene, const hw::Processor& processor, const hw::PixelHistory& pixel, const SeenPoints& seen)
      : scene_(scene), processor_(processor), pixel_(pixel), seen_(seen) {
    text_ = fmt::format("{:<34}  {:<16}  {:<24}  {:>10}  {:>4}  {:>10}  {:>10}  {:>10}\n", "node or ray", "row, column",
                        "what it is or sees", "issued", "unit", "from", "to", "seen");
    for (std::size_t corner = 0; corner < 4; ++corner) {
      add_ray(corner_of(pixel.cell(), corner), hw::no_number, fmt::format("corner {}", corner_names[corner]), 0);
    }
    add_node(pixel.cell(), "pixel", 0);
  }
  const std::string& text() const { return text_; }

 private:
  void add_node(const Cell& cell, std::string_view name, std::size_t depth) {
    CornerSamples corners;
    for (std::size_t corner = 0; corner < 4; ++corner) corners[corner].seen = seen_.at(corner_of(cell, corner));
    const PyramidCase which = classify(corners);
    std::string what(pyramid_case_names[static_cast<std::size_t>(which)]);
    if (which == PyramidCase::covered) what += ": " + name_of(corners[0].seen);
    std::string line = fmt::format("{:<34}  {:<16}  {:<24}", std::string(2 * depth, ' ') + std::string(name),
                                   place_of(cell.corner), what);
    const hw::Hop* request = hop_to<hw::ViewVectorGenerator>(cell);
    if (request != nullptr) {
      const hw::Hop& node = *hop_to<hw::SubdivisionController>(cell);
      line += fmt::format("  classified at {}, sent to be split at {} as request {}", grouped(node.written),
                          grouped(request->written), request->subject.request);
    }
    text_ += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    if (request == nullptr) return;
    for (std::size_t point = 0; point < subdivision_rays; ++point) {
      add_ray(subdivision_point(cell, point), request->subject.request, point_names[point], depth + 1);
    }
    for (std::size_t child = 0; child < 4; ++child) add_node(subpixel(cell, child), corner_names[child], depth + 1);
  }

  void add_ray(GridPoint point, std::uint64_t request, std::string_view name, std::size_t depth) {
    const hw::Hop* to_unit = nullptr;
    const hw::Hop* to_classifier = nullptr;
    for (const hw::Hop& hop : pixel_.hops()) {
      const hw::Subject& ray = hop.subject;
      if (ray.is_node() || ray.point != point || ray.request != request || ray.ray == hw::no_number) continue;
      if (reads<hw::IntersectionUnit>(hop)) to_unit = &hop;
      if (reads<hw::PyramidClassifier>(hop) && !writes<hw::ViewVectorGenerator>(hop)) to_classifier = &hop;
    }
    if (to_unit == nullptr || to_classifier == nullptr) return;
    const hw::Stage& unit = *processor_.wires()[to_unit->fifo].reader;
    const std::string number = std::string(unit.basename()).substr(std::string(unit.basename()).rfind('_') + 1);
    text_ += fmt::format("{:<34}  {:<16}  {:<24}  {:>10}  {:>4}  {:>10}  {:>10}  {:>10}\n",
                         fmt::format("{}ray {}, {}", std::string(2 * depth, ' '), to_unit->subject.ray, name),
                         place_of(point), name_of(seen_.at(point)), grouped(to_unit->written), number,
                         grouped(to_unit->read), grouped(to_classifier->visible), grouped(to_classifier->read));
  }

  template <class Kind>
  bool reads(const hw::Hop& hop) const {
    return hw::is_one_of<Kind>(*processor_.wires()[hop.fifo].reader);
  }
  template <class Kind>
  bool writes(const hw::Hop& hop) const {
    return hw::is_one_of<Kind>(*processor_.wires()[hop.fifo].writer);
  }
  /// The node's way to a stage; none where it did not go there.
  template <class Reader>
  const hw::Hop* hop_to(const Cell& cell) const {
    for (const hw::Hop& hop : pixel_.hops()) {
      const hw::Subject& node = hop.subject;
      if (node.point == cell.corner && node.log2_side == cell.log2_side && reads<Reader>(hop)) return &hop;
    }
    return nullptr;
  }

  /// "18.5, 14.125": in pixels.
  std::string place_of(GridPoint point) const {
    const double side = std::ldexp(1.0, processor_.max_level());
    return fmt::format("{}, {}", point.row / side, point.column / side);
  }
  std::string name_of(const Seen& seen) const {
    if (seen.object == no_object) return "nothing";
    const std::string& name = scene_.objects[seen.object].name;
    std::string text = name.empty() ? fmt::format("object {}", seen.object) : excerpt(name);
    if (processor_.contents().lights_with_shadows == 0) return text;
    std::vector<std::size_t> lights;
    for (std::size_t light = 0; light < max_shadow_lights; ++light) {
      if ((seen.lights >> light & 1U) != 0) lights.push_back(light);
    }
    return text + (lights.empty() ? ", in shadow" : fmt::format(", lit by {}", fmt::join(lights, ", ")));
  }

  const Scene& scene_;
  const hw::Processor& processor_;
  const hw::PixelHistory& pixel_;
  const SeenPoints& seen_;
  std::string text_;
};

std::string step_text(const hw::Processor& processor, const hw::LifeStep& step) {
  using Kind = hw::LifeStep::Kind;
  if (step.kind == Kind::waiting) return fmt::format("waiting in {}", processor.fifos()[step.place]->basename());
  const char* unit = processor.stages()[step.place]->basename();
  if (step.kind == Kind::held) return fmt::format("held by {}", unit);
  return fmt::format("{} of {}", step.kind == Kind::service ? "service" : "latency", unit);
}

/// What it owed its time to, the longest first.
std::string wait_lines(const hw::Processor& processor, const std::vector<hw::LifeStep>& life) {
  std::map<std::string, hw::Cycle> by_text;
  for (const hw::LifeStep& step : life) by_text[step_text(processor, step)] += step.end - step.begin;
  std::vector<std::pair<std::string, hw::Cycle>> lines(by_text.begin(), by_text.end());
  std::stable_sort(lines.begin(), lines.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  const hw::Cycle all = life.back().end - life.front().begin;
  std::string text;
  for (const auto& [what, cycles] : lines) {
    text += fmt::format("{:>12}  {:>5.1f} %  {}\n", grouped(cycles),
                        100 * static_cast<double>(cycles) / static_cast<double>(all), what);
  }
  return text;
}

}  // namespace

std::string pixel_report(const Scene& scene, const hw::Processor& processor, const hw::PixelHistory& pixel,
                         const SeenPoints& seen) {
  const std::vector<hw::LifeStep> life = pixel.life();
  const glm::vec3 color = processor.image().pixels()[pixel.pixel()];
  const auto byte = [](float linear) {
    return static_cast<int>(std::lround(255 * srgb_from_linear(std::clamp(static_cast<double>(linear), 0.0, 1.0))));
  };
  const hw::Cycle begin = life.front().begin;
  const hw::Cycle end = life.back().end;
  return fmt::format("colour   {:.4f} {:.4f} {:.4f} linear, #{:02x}{:02x}{:02x}\n", color.x, color.y, color.z,
                     byte(color.x), byte(color.y), byte(color.z)) +
         fmt::format("latency  {} cycles: from {}, when the scan sent its last corner, to {}; stored by {}\n\n",
                     grouped(end - begin), grouped(begin), grouped(end), grouped(pixel.stored())) +
         Tree(scene, processor, pixel, seen).text() + "\nWhat it took, by what came last each time:\n" +
         wait_lines(processor, life);
}

}  // namespace pyrasim::cli
