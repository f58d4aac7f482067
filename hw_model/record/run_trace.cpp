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
    : processor_(processor),
      writer_(output),
      ray_columns_(processor.contents()),
      rays_{ChunkType::rays, WorkTable(ray_columns_.size())},
      nodes_{ChunkType::nodes, WorkTable(NodeColumns::size)} {
  write_header(run);
  processor.attach(static_cast<WorkSink&>(*this));
}

void RunTrace::write_header(const ordered_json& run) {
  const ordered_json header{{"pyrasim", version()},
                            {"run", run},
                            {"contents", contents_document(processor_.contents())},
                            {"stages", stages_document(processor_)},
                            {"fifos", fifos_document(processor_)},
                            {"columns", {{"rays", ray_columns_.names()}, {"nodes", NodeColumns::names()}}}};
  writer_.write(ChunkType::header, header.dump(-1, ' ', false, ordered_json::error_handler_t::replace));
}

void RunTrace::ray(GridPoint point, const Seen& seen, const Work& work) {
  ray_columns_.write(rays_.table.add_row(), point, seen, work);
  if (rays_.table.rows() == rows_of_chunk) write(rays_);
}

void RunTrace::node(const Cell& cell, const TextureWork& work) {
  if (work == TextureWork()) return;  // most nodes show no texture
  NodeColumns::write(nodes_.table.add_row(), cell, work);
  if (nodes_.table.rows() == rows_of_chunk) write(nodes_);
}

void RunTrace::write(Rows& rows) {
  if (rows.table.rows() == 0) return;
  writer_.write(rows.type, rows.table.packed());
  rows.written += rows.table.rows();
  rows.table.clear();
}

void RunTrace::finish(Cycle cycles) {
  write(rays_);
  write(nodes_);
  writer_.write(ChunkType::image, encode_png(processor_.image()));
  const DatapathEvents events = processor_.statistics().arithmetic;
  const ordered_json end{{"complete", processor_.complete()},
                         {"cycles", cycles},
                         {"rays", rays_.written},
                         {"nodes", nodes_.written},
                         {"image_sha256", image_sha256(processor_.image())},
                         {"arithmetic",
                          {{"view_vectors", events_document(events.view_vectors)},
                           {"intersection", events_document(events.intersection)}}}};
  writer_.write(ChunkType::end, end.dump());
}

}  // namespace pyrasim::hw
