// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "files/file_place.h"

namespace pyrasim::cli {

/// What one command reads and writes, checked before anything is opened. No output may be another output or a file that
/// the command reads, by whatever name or link: one would be lost. Throws UsageError that names both options.
class OutputPlan {
 public:
  /// `option` names `file`, or leads to it, as a scene to its meshes. Nothing where the name is empty: not given.
  void reads(const std::string& option, const std::string& file);
  void reads(const std::string& option, const std::vector<std::string>& files);

  /// The name ("-": stdout) has to end in one of `endings`, unless there are none or the name leads to a device or a
  /// pipe. Nothing where the name is empty.
  void writes(const std::string& option, const std::string& file, const std::vector<std::string_view>& endings = {});

  /// Likewise; of any name but one that ends as those of another format that this program writes: `ending` is the
  /// usual one.
  void writes_usually(const std::string& option, const std::string& file, std::string_view ending);

  /// Where the table for people goes: stdout, or stderr where an output has taken that.
  std::ostream& table() const;
  bool writes_anything() const { return !written_.empty(); }

 private:
  struct Named {
    std::string option;
    std::string name;
    FilePlace place;
  };

  std::vector<Named> read_;
  std::vector<Named> written_;
  bool stdout_taken_ = false;
};

}  // namespace pyrasim::cli
