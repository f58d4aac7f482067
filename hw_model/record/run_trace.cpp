// SPDX-License-Identifier: Apache-2.0
#include "hw_model/record/run_trace.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "image/image_hash.h"
#include "image/png.h"
#include "numeric/arithmetic_events_json.h"
#include "version.h"

namespace pyrasim::hw {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t rows_of_chunk = 65536;
constexpr std::size_t longest_number = 5;  ///< bytes of a difference of two numbers of 32 bits
static_assert(longest_number * (1 + rows_of_chunk * std::max(RayColumns::most, NodeColumns::size)) <=
              most_content_bytes);

ordered_json stages_document(const Processor& processor) {
  ordered_json stages = ordered_json::array();
  for (const Stage* stage : processor.stages()) stages.push_back({{"name", stage->basename()}, {"box", stage->box()}});
  return stages;
}

ordered_json fifos_document(const Processor& processor) {
  ordered_json fifos = ordered_json::array();
  for (const auto& [fifo, writer, reader] : processor.wires()) {
    fifos.push_back({{"name", fifo->basename()},
                     {"depth", fifo->depth()},
                     {"writer", writer->basename()},
                     {"reader", reader->basename()}});
  }
  return fifos;
}

ordered_json contents_document(const SceneContents& contents) {
  ordered_json surfaces = ordered_json::object();
  for (std::size_t kind = 0; kind < surface_kinds; ++kind) {
    surfaces[std::string(surface_traits[kind].name)] = contents.surfaces[kind];
  }
  return {{"surfaces", surfaces},
          {"inner_nodes", contents.inner_nodes},
          {"shadow_inner_nodes", contents.shadow_inner_nodes},
          {"lights_with_shadows", contents.lights_with_shadows}};
}

}  // namespace

RunTrace::RunTrace(Processor& processor, const ordered_json& run, OutputFile& output)
    : processor_(processor), writer_(output), waiting_(processor.contents()) {
  write_header(run);
  processor.attach(static_cast<WorkSink&>(*this));
}

void RunTrace::write_header(const ordered_json& run) {
  const ordered_json header{{"pyrasim", version()},
                            {"run", run},
                            {"contents", contents_document(processor_.contents())},
                            {"stages", stages_document(processor_)},
                            {"fifos", fifos_document(processor_)},
                            {"columns", {{"rays", waiting_.columns.names()}, {"nodes", NodeColumns::names()}}}};
  writer_.write(ChunkType::header, header.dump(-1, ' ', false, ordered_json::error_handler_t::replace));
}

void RunTrace::ray(GridPoint point, const Seen& seen, const Work& work) {
  waiting_.ray(point, seen, work);
  if (waiting_.rays.rows() == rows_of_chunk) write(ChunkType::rays, waiting_.rays);
}

void RunTrace::node(const Cell& cell, const TextureWork& work) {
  waiting_.node(cell, work);
  if (waiting_.nodes.rows() == rows_of_chunk) write(ChunkType::nodes, waiting_.nodes);
}

void RunTrace::write(ChunkType type, WorkTable& rows) {
  if (rows.rows() == 0) return;
  writer_.write(type, rows.packed());
  (type == ChunkType::rays ? rays_ : nodes_) += rows.rows();
  rows.clear();
}

void RunTrace::finish(Cycle cycles) {
  write(ChunkType::rays, waiting_.rays);
  write(ChunkType::nodes, waiting_.nodes);
  writer_.write(ChunkType::image, encode_png(processor_.image()));
  const DatapathEvents events = processor_.statistics().arithmetic;
  const ordered_json end{{"complete", processor_.complete()},
                         {"cycles", cycles},
                         {"rays", rays_},
                         {"nodes", nodes_},
                         {"image_sha256", image_sha256(processor_.image())},
                         {"arithmetic",
                          {{"view_vectors", events_document(events.view_vectors)},
                           {"intersection", events_document(events.intersection)}}}};
  writer_.write(ChunkType::end, end.dump());
}

}  // namespace pyrasim::hw
