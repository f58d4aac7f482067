// SPDX-License-Identifier: Apache-2.0
#include "numeric/number_format.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <utility>

#include "error.h"
#include "numeric/number_types.h"
#include "text/printable.h"

namespace pyrasim {
namespace {

template <class... Numbers>
std::vector<NumberFormat> formats_of(NumberTypes<Numbers...>) {
  return {FormatOf<Numbers>::value...};
}

constexpr std::array<std::pair<std::string_view, NumberFormat>, 6> named_formats{{{"double", FormatOf<double>::value},
                                                                                  {"float", FormatOf<float>::value},
                                                                                  {"fp16", FormatOf<Fp16>::value},
                                                                                  {"bf16", FormatOf<Bf16>::value},
                                                                                  {"tf32", FormatOf<Tf32>::value},
                                                                                  {"fp24", FormatOf<Fp24>::value}}};

/// The name by the widths, which every software format has.
std::string systematic_name(const NumberFormat& format) {
  return format.kind == NumberKind::fixed ? fmt::format("fix{}.{}", format.bits, format.fraction_bits)
                                          : fmt::format("e{}p{}", format.exponent_bits, format.significand_bits);
}

}  // namespace

std::string NumberFormat::name() const {
  for (const auto& [name, format] : named_formats) {
    if (format == *this) return std::string(name);
  }
  return systematic_name(*this);
}

const std::vector<NumberFormat>& number_formats() {
  static const std::vector<NumberFormat> formats = formats_of(CompiledNumberTypes());
  return formats;
}

NumberFormat parse_number_format(std::string_view name) {
  std::vector<std::string> names;
  for (const NumberFormat& format : number_formats()) {
    names.push_back(format.name());
    if (names.back() == name) return format;
    if (format.kind != NumberKind::processor && systematic_name(format) == name) return format;
  }
  throw UsageError(fmt::format("number format {}: {} is allowed", value_excerpt(name), fmt::join(names, " or ")));
}

}  // namespace pyrasim
