// SPDX-License-Identifier: Apache-2.0
#include "cli/map_outputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>
#include <span>

#include "error.h"
#include "image/write_image.h"
#include "text/printable.h"

namespace pyrasim::cli {
namespace {

std::string names(std::size_t kinds, const char* separator) {
  return fmt::format("{}", fmt::join(std::span(cost_map_names).first(kinds), separator));
}

}  // namespace

MapOutputs::MapOutputs(const std::vector<std::string>& asked, std::size_t kinds, OutputPlan& plan) {
  for (const std::string& text : asked) {
    const std::size_t equals = text.find('=');
    const auto known = std::span(cost_map_names).first(kinds);
    const auto kind = std::find(known.begin(), known.end(), text.substr(0, equals));
    if (equals == std::string::npos || equals + 1 == text.size() || kind == known.end()) {
      throw UsageError(fmt::format("--map {}: KIND=FILE is allowed, as in rays=rays.png; of the kinds {}",
                                   value_excerpt(text), names(kinds, ", ")));
    }
    asked_.push_back({static_cast<CostMap>(kind - known.begin()), text.substr(equals + 1)});
    plan.writes(fmt::format("--map {}", *kind), asked_.back().file);
    image_file_kind(asked_.back().file);
  }
}

void MapOutputs::open() {
  for (const Asked& asked : asked_) files_.emplace_back(ImageOutput{.file = asked.file, .format = {}});
}

CostMaps* MapOutputs::begin(const PixelWindow& window, int max_level) {
  return asked_.empty() ? nullptr : &maps_.emplace(window, max_level);
}

void MapOutputs::write(std::ostream& table) {
  for (std::size_t k = 0; k < asked_.size(); ++k) {
    const auto& [kind, file] = asked_[k];
    files_[k].write(image_file_kind(file) == ImageFile::pfm ? maps_->numbers(kind) : maps_->picture(kind));
    table << fmt::format("map           {}: {}\n", one_line(file), maps_->legend(kind));
  }
}

void add_map_option(const Command& command, std::vector<std::string>& asked, std::size_t kinds) {
  command
      .add_texts("--map", asked,
                 "a picture of what each pixel took, may be given for several: " + names(kinds, ", ") +
                     "; a .pfm file holds the numbers")
      .type_name(fmt::format("{}=IMAGE", names(kinds, "|")));
}

}  // namespace pyrasim::cli
