// SPDX-License-Identifier: Apache-2.0
#include "hw_model/record/recorded_work.h"

#include "hw_model/record/varint.h"

namespace pyrasim::hw {

RecordedWork::RecordedWork(const SceneContents& contents, std::size_t most)
    : columns(contents), rays(columns.size()), nodes(NodeColumns::size), most_(most) {}

void RecordedWork::ray(GridPoint point, const Seen& seen, const Work& work) {
  if (has_room()) columns.write(rays.add_row(), point, seen, work);
}

void RecordedWork::node(const Cell& cell, const TextureWork& work) {
  if (work == TextureWork()) return;  // most nodes show no texture
  if (has_room()) NodeColumns::write(nodes.add_row(), cell, work);
}

bool RecordedWork::has_room() {
  if (whole_ && rays.numbers() + nodes.numbers() >= most_) {
    whole_ = false;
    rays = WorkTable(rays.columns());
    nodes = WorkTable(nodes.columns());
  }
  return whole_;
}

std::string RecordedWork::packed() const {
  const std::string packed_rays = rays.packed();
  std::string bytes;
  append_varint(bytes, packed_rays.size());
  return bytes + packed_rays + nodes.packed();
}

bool RecordedWork::add_packed(std::string_view bytes) {
  const auto length = take_varint(bytes);
  if (!length || *length > bytes.size()) return false;
  return rays.add_packed(bytes.substr(0, *length)) && nodes.add_packed(bytes.substr(*length));
}

}  // namespace pyrasim::hw
