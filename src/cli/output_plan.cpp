// SPDX-License-Identifier: Apache-2.0
#include "cli/output_plan.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>

#include "error.h"
#include "hw_model/trace/trace.h"

namespace pyrasim::cli {
namespace {

FilePlace descriptor_place(int descriptor) { return {{}, descriptor}; }

FilePlace output_place(const std::string& name) {
  return name == "-" ? descriptor_place(STDOUT_FILENO) : place_of(name);
}

/// A stream takes its kind from its reader.
bool is_stream(const FilePlace& place) {
  if (place.descriptor >= 0) return true;
  const auto type = std::filesystem::status(place.file).type();
  return type == std::filesystem::file_type::character || type == std::filesystem::file_type::fifo;
}

std::string ending_of(const std::string& name) { return std::filesystem::path(name).extension().string(); }

/// Whether a file of this program whose name ends so is of one format.
bool names_a_format(std::string_view ending) {
  constexpr std::array<std::string_view, 6> untraced{".csv", ".json", ".png", ".pfm", ".svg", ".pov"};
  const auto traced = [ending](const hw::TraceFormat& format) { return format.ending == ending; };
  return std::find(untraced.begin(), untraced.end(), ending) != untraced.end() ||
         std::any_of(hw::trace_formats.begin(), hw::trace_formats.end(), traced);
}

}  // namespace

void OutputPlan::reads(const std::string& option, const std::string& file) {
  if (!file.empty()) read_.push_back({option, file, place_of(file)});
}

void OutputPlan::reads(const std::string& option, const std::vector<std::string>& files) {
  for (const std::string& file : files) reads(option, file);
}

std::ostream& OutputPlan::table() const { return stdout_taken_ ? std::cerr : std::cout; }

void OutputPlan::writes(const std::string& option, const std::string& name,
                        const std::vector<std::string_view>& endings) {
  if (name.empty()) return;
  const FilePlace place = output_place(name);
  const auto fits = [&](std::string_view ending) { return ending_of(name) == ending; };
  if (!endings.empty() && std::none_of(endings.begin(), endings.end(), fits) && !is_stream(place)) {
    throw UsageError(
        fmt::format("{} {}: its name must end in {}, or be - for stdout", option, name, fmt::join(endings, ", ")));
  }
  for (const Named& other : written_) {
    if (same_place(place, other.place)) {
      throw UsageError(fmt::format("{} {} and {} {} are one file or stream; each output needs its own", other.option,
                                   other.name, option, name));
    }
  }
  for (const Named& input : read_) {
    if (same_place(place, input.place)) {
      throw UsageError(fmt::format("{} {}: {} reads this file ({}); an output needs a file of its own", option, name,
                                   input.option, input.name));
    }
  }
  // By its name the file is replaced, and what is still to come on stderr would be lost with the old one.
  if (place.descriptor < 0 && is_regular_file(place) && same_place(place, descriptor_place(STDERR_FILENO))) {
    throw UsageError(fmt::format("{} {}: stderr goes to this file; an output needs a file of its own", option, name));
  }
  if (same_place(place, descriptor_place(STDOUT_FILENO))) stdout_taken_ = true;
  written_.push_back({option, name, place});
}

void OutputPlan::writes_usually(const std::string& option, const std::string& name, std::string_view ending) {
  writes(option, name);
  const std::string its = ending_of(name);
  if (its == ending || !names_a_format(its) || is_stream(output_place(name))) return;
  throw UsageError(
      fmt::format("{} {}: {} is the ending of another format; one that ends in {} is allowed, or - for stdout", option,
                  name, its, ending));
}

}  // namespace pyrasim::cli
