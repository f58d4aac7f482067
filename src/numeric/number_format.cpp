// SPDX-License-Identifier: Apache-2.0
#include "numeric/number_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <iterator>
#include <optional>
#include <utility>

#include "error.h"
#include "text/printable.h"

namespace pyrasim {
namespace {

constexpr std::array<std::pair<std::string_view, NumberFormat>, 6> named_formats{{{"double", NumberFormat()},
                                                                                  {"float", NumberFormat::single()},
                                                                                  {"fp16", fp16},
                                                                                  {"bf16", bf16},
                                                                                  {"tf32", tf32},
                                                                                  {"fp24", fp24}}};

constexpr bool within(int value, int min, int max) { return min <= value && value <= max; }

/// The number that `text` begins with, which is taken off; written without sign or leading zeros.
std::optional<int> take_number(std::string_view& text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const auto digits = static_cast<std::size_t>(end - text.data());
  const bool padded = digits > 1 && text.front() == '0';
  if (error != std::errc() || text.front() == '-' || padded) return std::nullopt;
  text.remove_prefix(digits);
  return number;
}

/// The two numbers of "<before>first<between>second".
std::optional<std::pair<int, int>> two_numbers(std::string_view text, std::string_view before,
                                               std::string_view between) {
  if (!text.starts_with(before)) return std::nullopt;
  text.remove_prefix(before.size());
  const auto first = take_number(text);
  if (!first || !text.starts_with(between)) return std::nullopt;
  text.remove_prefix(between.size());
  const auto second = take_number(text);
  if (!second || !text.empty()) return std::nullopt;
  return std::pair(*first, *second);
}

/// By its widths, if it is within the limits.
std::optional<NumberFormat> systematic_format(std::string_view name) {
  std::optional<NumberFormat> format;
  if (const auto floating = two_numbers(name, "e", "p")) {
    format = NumberFormat::floating(floating->first, floating->second);
  } else if (const auto fixed = two_numbers(name, "fix", ".")) {
    format = NumberFormat::fixed(fixed->first, fixed->second);
  }
  return format && format->within_limits() ? format : std::nullopt;
}

std::vector<NumberFormat> formats_to_compare() {
  std::vector<NumberFormat> formats;
  std::transform(named_formats.begin(), named_formats.end(), std::back_inserter(formats),
                 [](const auto& named) { return named.second; });
  for (int p = 9; p <= max_significand_bits; ++p) {
    if (p != 11) formats.push_back(NumberFormat::floating(8, p));  // 11 are tf32
  }
  for (int f = 12; f <= 32; f += 4) formats.push_back(NumberFormat::fixed(64, f));
  for (const auto& [w, f] : {std::pair(48, 16), {48, 20}, {48, 24}, {32, 12}, {32, 16}, {32, 20}, {24, 12}}) {
    formats.push_back(NumberFormat::fixed(w, f));
  }
  return formats;
}

}  // namespace

bool NumberFormat::within_limits() const {
  switch (kind) {
    case NumberKind::floating:
      return within(exponent_bits, min_exponent_bits, max_exponent_bits) &&
             within(significand_bits, min_significand_bits, max_significand_bits);
    case NumberKind::fixed:
      return within(bits, min_fixed_bits, max_fixed_bits) && within(fraction_bits, 0, bits - 1);
    case NumberKind::processor:
      break;
  }
  return *this == NumberFormat() || *this == single();
}

std::string NumberFormat::name() const {
  for (const auto& [name, format] : named_formats) {
    if (format == *this) return std::string(name);
  }
  return kind == NumberKind::fixed ? fmt::format("fix{}.{}", bits, fraction_bits)
                                   : fmt::format("e{}p{}", exponent_bits, significand_bits);
}

const std::vector<NumberFormat>& number_formats() {
  static const std::vector<NumberFormat> formats = formats_to_compare();
  return formats;
}

NumberFormat parse_number_format(std::string_view name) {
  std::string allowed;
  for (const auto& [known, format] : named_formats) {
    if (known == name) return format;
    allowed += fmt::format("{} or ", known);
  }
  if (const auto format = systematic_format(name)) return *format;
  throw UsageError(fmt::format(
      "number format {}: {}eEpP, E from {} to {} and P from {} to {}, or fixW.F, W from {} to {} and F from 0 to "
      "W - 1, is allowed",
      value_excerpt(name), allowed, min_exponent_bits, max_exponent_bits, min_significand_bits, max_significand_bits,
      min_fixed_bits, max_fixed_bits));
}

}  // namespace pyrasim
