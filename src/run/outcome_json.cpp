// SPDX-License-Identifier: Apache-2.0
#include "run/outcome_json.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <ranges>

#include "error.h"
#include "run/outcome_fields.h"

namespace pyrasim {
namespace {

using nlohmann::json;

template <class Value>
concept Plain = std::integral<Value> || std::same_as<Value, std::string>;
template <class Value>
concept Optional = requires(Value value) {
  value.reset();
};
template <class Value>
concept Growing = requires(Value value) {
  value.emplace_back();
};

json packed_number(double value) {
  if (std::isfinite(value)) return value;
  return std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
}

double number_of(const json& document) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (document == "inf") return infinity;
  if (document == "-inf") return -infinity;
  return document == "nan" ? std::numeric_limits<double>::quiet_NaN() : document.get<double>();
}

template <class Value>
json packed(const Value& value) {
  if constexpr (std::same_as<Value, double>) {
    return packed_number(value);
  } else if constexpr (Plain<Value>) {
    return value;
  } else if constexpr (Optional<Value>) {
    return value ? packed(*value) : json();
  } else if constexpr (std::ranges::range<Value>) {
    json list = json::array();
    for (const auto& element : value) list.push_back(packed(element));
    return list;
  } else {
    json object = json::object();
    for_each_field(value, [&](const char* name, const auto& field) { object[name] = packed(field); });
    return object;
  }
}

template <class Value>
void read(const json& document, Value& value) {
  if constexpr (std::same_as<Value, double>) {
    value = number_of(document);
  } else if constexpr (Plain<Value>) {
    document.get_to(value);
  } else if constexpr (Optional<Value>) {
    if (!document.is_null()) read(document, value.emplace());
  } else if constexpr (Growing<Value>) {
    for (const json& element : document) read(element, value.emplace_back());
  } else if constexpr (std::ranges::range<Value>) {
    for (std::size_t k = 0; k < value.size(); ++k) read(document.at(k), value[k]);
  } else {
    for_each_field(value, [&](const char* name, auto& field) { read(document.at(name), field); });
  }
}

}  // namespace

json pack(const Outcome& outcome) { return packed(outcome); }

Outcome unpack(const json& document) {
  Outcome outcome;
  try {
    read(document, outcome);
  } catch (const json::exception& error) {
    throw InputError(fmt::format("it is not a run's outcome: {}", error.what()));
  }
  return outcome;
}

}  // namespace pyrasim
