// SPDX-License-Identifier: Apache-2.0
#include "intersect/datapath_formats.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "error.h"
#include "numeric/number_range.h"
#include "text/printable.h"

namespace pyrasim {
namespace {

constexpr std::string_view view_vectors_key = "view_vectors";
constexpr std::string_view intersection_key = "intersection";

/// The fraction bits by which no two points of the grid fall together. Lengths in units of dx.
int needed_fraction_bits(const Screen& screen, std::int64_t steps) {
  return static_cast<int>(
      std::ceil(-std::log2(std::min(screen.dy, screen.dz) / (screen.dx * static_cast<double>(steps)))));
}

/// The integer bits that hold the squared length of the longest view vector.
int needed_integer_bits(const Screen& screen) {
  const double y = screen.rows * screen.dy / (2 * screen.dx);
  const double z = screen.columns * screen.dz / (2 * screen.dx);
  return std::ilogb(1 + y * y + z * z) + 1;
}

void require_bits(std::string_view stage, const NumberFormat& format, int fraction_needed, int integer_needed) {
  if (finest_fraction_bits(format) < fraction_needed) {
    throw UsageError(
        fmt::format("--scalar {} for {}: neighbouring points of the screen's grid fall together; multiples of 2^-{} "
                    "are needed, or a coarser grid: fewer pixels, or a lower MAX_LEVEL or N",
                    format.name(), stage, fraction_needed));
  }
  if (integer_bits(format) < integer_needed) {
    throw UsageError(
        fmt::format("--scalar {} for {}: the view vector through the screen's corner is too long; numbers up to "
                    "2^{} are needed, or a narrower field of view",
                    format.name(), stage, integer_needed));
  }
}

}  // namespace

std::string DatapathFormats::name() const {
  if (view_vectors == intersection) return view_vectors.name();
  return fmt::format("{}={},{}={}", view_vectors_key, view_vectors.name(), intersection_key, intersection.name());
}

DatapathFormats parse_datapath_formats(std::string_view text) {
  if (text.find('=') == std::string_view::npos) {
    const NumberFormat format = parse_number_format(text);
    return {format, format};
  }
  DatapathFormats formats;
  std::vector<std::string_view> named;
  bool more = true;
  while (more) {
    const std::string_view part = text.substr(0, text.find(','));
    more = part.size() < text.size();
    text.remove_prefix(part.size() + (more ? 1 : 0));
    const std::size_t sign = std::min(part.find('='), part.size());
    const std::string_view stage = part.substr(0, sign);
    if (std::find(named.begin(), named.end(), stage) != named.end()) {
      throw UsageError(fmt::format("{}: a second format for {}; one is allowed", excerpt(part), stage));
    }
    named.push_back(stage);
    const std::string_view format = part.substr(std::min(sign + 1, part.size()));
    if (stage == view_vectors_key) {
      formats.view_vectors = parse_number_format(format);
    } else if (stage == intersection_key) {
      formats.intersection = parse_number_format(format);
    } else {
      throw UsageError(fmt::format("{}: FORMAT, or {}=FORMAT,{}=FORMAT is allowed", value_excerpt(part),
                                   view_vectors_key, intersection_key));
    }
  }
  return formats;
}

std::optional<std::string> check_addressing(const DatapathFormats& formats, const Screen& screen, std::int64_t steps) {
  const int fraction_needed = needed_fraction_bits(screen, steps);
  const int integer_needed = needed_integer_bits(screen);
  require_bits(view_vectors_key, formats.view_vectors, fraction_needed, integer_needed);
  require_bits(intersection_key, formats.intersection, fraction_needed, integer_needed);
  const double points = static_cast<double>(std::max(screen.columns, screen.rows)) * static_cast<double>(steps);
  const int needed = static_cast<int>(std::ceil(std::log2(points))) + 4;
  const auto bits = [](const NumberFormat& format) {
    return format.kind == NumberKind::fixed ? std::numeric_limits<int>::max() : format.significand_bits;
  };
  const bool in_view_vectors = bits(formats.view_vectors) <= bits(formats.intersection);
  const NumberFormat& narrowest = in_view_vectors ? formats.view_vectors : formats.intersection;
  if (bits(narrowest) >= needed) return std::nullopt;
  return fmt::format(
      "--scalar {} for {}: {} significand bits are fewer than the {} by which no two of {:.0f} grid points along a "
      "side "
      "come near each other; borders of objects will be ragged",
      narrowest.name(), in_view_vectors ? view_vectors_key : intersection_key, narrowest.significand_bits, needed,
      points);
}

}  // namespace pyrasim
