// SPDX-License-Identifier: Apache-2.0
// A sweep's rows: as CSV, and as a table for people.
#pragma once

#include <string>
#include <vector>

#include "cli/sweep_plan.h"
#include "run/outcome.h"

namespace pyrasim::cli {

inline constexpr std::string_view sweep_csv_header =
    "pyrasim,scene,scene_sha256,machine,settings_sha256,set,columns,rows,max_level,edge,reference,rays_primary,"
    "rays_subdivision,rays_total,subdivisions,rmse,max_error,cycles,frames_per_second,reference_rays\n";
/// The fields that say what was run: up to the reference.
inline constexpr std::size_t sweep_key_fields = 11;

/// The first fields of a point's row. Each is one line whatever names there are: so a line of the file is a row.
std::vector<std::string> sweep_key(const SweepPoint& point);
std::string sweep_csv_row(const SweepPoint& point, const Outcome& outcome);

/// What varies over the rows has a column: scenes and settings only where there are several.
class SweepTable {
 public:
  SweepTable(const std::vector<std::string>& scenes, const MachineAxes& machines);

  std::string header() const;
  std::string line(const SweepPoint& point, const Outcome& outcome) const;
  /// The point, for messages.
  std::string name_of(const SweepPoint& point) const;

 private:
  struct Column {
    std::string title;
    std::size_t width;
  };

  std::size_t scene_width_ = 0;  ///< 0: all rows have one scene
  std::vector<Column> settings_;
};

}  // namespace pyrasim::cli
