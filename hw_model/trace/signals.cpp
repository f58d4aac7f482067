// SPDX-License-Identifier: Apache-2.0
#include "hw_model/trace/signals.h"

#include <bit>
#include <limits>
#include <string_view>

namespace pyrasim::hw {
namespace {

std::size_t bits_for(std::uint64_t most) { return most == 0 ? 1 : static_cast<std::size_t>(std::bit_width(most)); }

}  // namespace

std::vector<Signal> signals_of(const Processor& processor, const TraceWindow& window) {
  using enum Signal::Kind;
  std::vector<Signal> signals;
  const auto add = [&](Signal::Kind kind, std::size_t source, const std::string& owner, std::string_view suffix,
                       std::size_t bits) {
    signals.push_back({kind, source, owner + std::string(suffix), bits, window.shows(owner)});
  };
  const std::vector<Stage*>& stages = processor.stages();
  const std::vector<FifoBase*>& fifos = processor.fifos();
  for (std::size_t k = 0; k < stages.size(); ++k) add(state, k, stages[k]->basename(), "", 2);
  for (std::size_t k = 0; k < fifos.size(); ++k) add(fill, k, fifos[k]->basename(), "", bits_for(fifos[k]->depth()));
  if (!window.detail) return signals;
  const auto [last_row, last_column] =
      processor.place_of(static_cast<std::uint32_t>(processor.image().pixels().size() - 1));
  for (std::size_t k = 0; k < stages.size(); ++k) {
    add(row, k, stages[k]->basename(), "_row", bits_for(static_cast<std::uint64_t>(last_row)));
    add(column, k, stages[k]->basename(), "_column", bits_for(static_cast<std::uint64_t>(last_column)));
    add(ray, k, stages[k]->basename(), "_ray", std::numeric_limits<std::uint64_t>::digits);
  }
  if (!window.pixels.empty()) return signals;
  for (std::size_t k = 0; k < fifos.size(); ++k) {
    add(valid, k, fifos[k]->basename(), "_valid", 1);
    add(ready, k, fifos[k]->basename(), "_ready", 1);
  }
  return signals;
}

}  // namespace pyrasim::hw
