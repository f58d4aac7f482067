// SPDX-License-Identifier: Apache-2.0
#include "cli/trace_outputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <iostream>

#include "cli/nearest.h"
#include "error.h"
#include "hw_model/trace/gtkw_save.h"
#include "text/printable.h"

namespace pyrasim::cli {
namespace {

std::vector<std::string_view> endings() {
  std::vector<std::string_view> endings;
  endings.reserve(hw::trace_formats.size());
  for (const hw::TraceFormat& format : hw::trace_formats) endings.push_back(format.ending);
  return endings;
}

/// The first, of streams whose names say nothing.
const hw::TraceFormat& format_of(const std::string& file) {
  const auto found = std::find_if(
      hw::trace_formats.begin(), hw::trace_formats.end(),
      [ending = std::filesystem::path(file).extension()](const auto& format) { return ending == format.ending; });
  return found == hw::trace_formats.end() ? hw::trace_formats.front() : *found;
}

/// "10M". Throws UsageError.
std::uint64_t parse_bytes(const std::string& text) {
  constexpr std::string_view suffixes = "KMG";  // thousands, each of the one before
  std::uint64_t bytes = 0;
  const char* const text_end = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), text_end, bytes);
  const std::size_t power = end == text_end ? 0 : suffixes.find(*end) + 1;  // 0: none, or an unknown one
  const bool whole = end == text_end || (power > 0 && end + 1 == text_end);
  if (error != std::errc() || !whole || bytes == 0 || bytes > 1'000'000'000) {
    throw UsageError(
        fmt::format("--trace-limit {}: a number of bytes from 1 to 1000000000, or of as many K, M or G, is allowed",
                    value_excerpt(text)));
  }
  for (std::size_t k = 0; k < power; ++k) bytes *= 1000;
  return bytes;
}

}  // namespace

TraceOutputs::TraceOutputs(const TraceOptions& asked, const PixelWindow& rendered, OutputPlan& plan)
    : window_(asked.window) {
  if (window_.from >= window_.to) {
    throw UsageError(
        fmt::format("--trace-from {} --trace-to {}: no cycle lies between them; more of the second is needed",
                    window_.from, window_.to));
  }
  for (const std::string& pixel : asked.pixels) {
    window_.pixels.push_back(parse_pixel(pixel, rendered, "--trace-pixel"));
  }
  const bool asks_for_a_part =
      window_.from > 0 || window_.to != hw::never || !window_.units.empty() || !asked.pixels.empty() || asked.limit;
  if (asks_for_a_part && asked.files.empty()) {
    throw UsageError("--trace-from, --trace-to, --trace-unit, --trace-pixel and --trace-limit go with --trace FILE");
  }
  const auto shows_signals = [](const std::string& file) { return format_of(file).waveform; };
  if (window_.detail && std::none_of(asked.files.begin(), asked.files.end(), shows_signals)) {
    throw UsageError("--trace-detail goes with --trace FILE.vcd, FILE.fst or FILE.gtkw");
  }
  if (asked.limit) window_.limit = parse_bytes(*asked.limit);
  for (const std::string& file : asked.files) {
    plan.writes("--trace", file, endings());
    asked_.push_back({file, &format_of(file)});
    if (asked_.back().format->ending == ".gtkw") plan.writes("--trace", hw::GtkwSave::states_file(file).string());
  }
  if (asks_for_a_part &&
      std::none_of(asked_.begin(), asked_.end(), [](const Asked& file) { return file.format->windowed; })) {
    throw UsageError(
        "--trace-from, --trace-to, --trace-unit, --trace-pixel and --trace-limit do not apply to .ptrace and .html, "
        "which are of the whole frame; they go with a --trace FILE of another format");
  }
}

void TraceOutputs::open() {
  for (const Asked& asked : asked_) outputs_.push_back(std::make_unique<RevisableOutput>(asked.file));
}

void TraceOutputs::begin(hw::Processor& processor, const nlohmann::ordered_json& run) {
  require_names(processor);
  for (std::size_t k = 0; k < asked_.size(); ++k) {
    traces_.push_back(asked_[k].format->make(processor, window_, run, outputs_[k]->file()));
    if (!asked_[k].format->revises) outputs_[k]->publish();
  }
}

/// What is written for nothing is noticed before the frame is simulated.
void TraceOutputs::require_names(const hw::Processor& processor) const {
  std::vector<std::string> names;
  for (const hw::Stage* stage : processor.stages()) names.emplace_back(stage->basename());
  for (const hw::FifoBase* fifo : processor.fifos()) names.emplace_back(fifo->basename());
  for (const std::string& pattern : window_.units) {
    hw::TraceWindow alone;
    alone.units = {pattern};
    if (std::any_of(names.begin(), names.end(), [&](const std::string& name) { return alone.shows(name); })) continue;
    const auto near = nearest(pattern, names);
    throw UsageError(fmt::format("--trace-unit {}: no unit or FIFO of this machine has such a name; {}",
                                 value_excerpt(pattern),
                                 near ? *near + " is near" : "pyrasim diagram shows those that there are"));
  }
}

void TraceOutputs::finish(hw::Cycle cycles) {
  for (std::size_t k = 0; k < traces_.size(); ++k) {
    traces_[k]->finish(cycles);
    outputs_[k]->commit();
    if (const auto end = traces_[k]->full()) {
      std::cerr << fmt::format("pyrasim: warning: --trace {}: ends at cycle {}, with --trace-limit\n", asked_[k].file,
                               *end);
    }
  }
}

void TraceOptions::add(const Command& command) {
  command
      .add_texts(
          "--trace", files,
          "what units and FIFOs do over time, may be given for several files: .vcd and .fst (GTKWave), .pftrace "
          "(Perfetto), .json (Chrome), .kanata (Konata: a row for each ray), .gtkw (how GTKWave shows .vcd and .fst), "
          ".ptrace (for pyrasim whatif and view), .html (a page for browsers); - for VCD on stdout")
      .type_name("FILE.vcd|.fst|.pftrace|.json|.kanata|.gtkw|.ptrace|.html|-");
  command.add_integer("--trace-from", window.from, 0, hw::never - 1, "the first cycle that traces show")
      .type_name("CYCLE");
  command.add_integer("--trace-to", window.to, 1, hw::never - 1, "the cycle with which traces end").type_name("CYCLE");
  command
      .add_texts("--trace-unit", window.units,
                 "the units and FIFOs that traces show, as a shell's pattern: 'intersection_unit*'; repeatable")
      .type_name("GLOB");
  command.add_texts("--trace-pixel", pixels, "only what is about this pixel: its rays and nodes; repeatable")
      .type_name("ROW,COLUMN");
  command.add_flag("--trace-detail", window.detail,
                   ".vcd, .fst and .gtkw have signals more: row, column and ray that units work on, valid and ready of "
                   "FIFOs");
  command
      .add_text(
          "--trace-limit", limit,
          "a file of --trace ends when it has so many bytes (K, M, G: thousands, millions, thousands of millions)")
      .type_name("SIZE");
}

}  // namespace pyrasim::cli
