// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "cli/command.h"
#include "cli/output_plan.h"
#include "render/cost_maps.h"

namespace pyrasim::cli {

/// --map: pictures of what each pixel took.
class MapOutputs {
 public:
  /// `asked`: "KIND=FILE" each, of the first so many kinds of CostMap. Throws UsageError.
  MapOutputs(const std::vector<std::string>& asked, std::size_t kinds, OutputPlan& plan);

  /// Opens the files.
  void open();
  /// To be filled while the frame is made; null where no map is asked for. Throws LimitError where memory is too small.
  CostMaps* begin(const PixelWindow& window, int max_level);
  /// Once the frame is made; what the colours say goes to `table`.
  void write(std::ostream& table);

 private:
  struct Asked {
    CostMap kind;
    std::string file;
  };
  std::vector<Asked> asked_;
  std::vector<PictureOutput> files_;
  std::optional<CostMaps> maps_;
};

/// Adds --map with the first so many kinds.
void add_map_option(const Command& command, std::vector<std::string>& asked, std::size_t kinds);

}  // namespace pyrasim::cli
