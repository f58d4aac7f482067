// SPDX-License-Identifier: Apache-2.0
#include "hw_model/machine_settings.h"

#include <nlohmann/json.hpp>

#include "files/sha256.h"

namespace pyrasim::hw {
namespace {

std::string_view value_of(Dispatch dispatch) {
  for (const auto& [name, meaning] : dispatch_names) {
    if (meaning == dispatch) return name;
  }
  return {};
}

template <class Number>
Number value_of(Number number) {
  return number;
}

}  // namespace

nlohmann::ordered_json settings_document(const MachineSpec& spec) {
  nlohmann::ordered_json document = nlohmann::ordered_json::object();
  for_each_setting(spec, [&](const std::string& path, const auto& setting, const auto&) {
    nlohmann::ordered_json* node = &document;
    std::size_t begin = 0;
    for (std::size_t dot = path.find('.'); dot != std::string::npos; dot = path.find('.', begin)) {
      node = &(*node)[path.substr(begin, dot - begin)];
      begin = dot + 1;
    }
    (*node)[path.substr(begin)] = value_of(setting);
  });
  return document;
}

std::string settings_sha256(const MachineSpec& spec) { return sha256(settings_document(spec).dump()); }

}  // namespace pyrasim::hw
