// SPDX-License-Identifier: Apache-2.0
#include "study/format_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>

#include "study/xml_text.h"

namespace pyrasim {
namespace {

constexpr int width = 760;
constexpr int height = 440;
constexpr double left = 70;
constexpr double right = width - 210.0;
constexpr double top = 46;
constexpr double bottom = height - 56.0;
constexpr int least_bits = 6;
constexpr int most_bits = 34;

/// 0 lies at the bottom, 1 a step above it, then a step a decade.
class Axis {
 public:
  explicit Axis(std::uint64_t largest)
      : decades_(std::max(1.0, std::ceil(std::log10(std::max<double>(2, static_cast<double>(largest)))))) {}
  int decades() const { return static_cast<int>(decades_); }
  double y(std::uint64_t count) const {
    const double step = count == 0 ? 0 : 1 + std::log10(static_cast<double>(count));
    return bottom - (bottom - top) * step / (decades_ + 1);
  }

 private:
  double decades_;
};

double x(int bits) { return left + (right - left) * (bits - least_bits) / (most_bits - least_bits); }

struct Series {
  std::string_view name;
  std::string_view color;
  std::string_view dashes;  ///< empty: a full line
  bool fixed;
  std::uint64_t (*count)(const FormatRow&);
};

std::uint64_t changed(const FormatRow& row) { return row.changed_pixels; }
std::uint64_t flipped(const FormatRow& row) { return row.flips.flipped; }

constexpr std::array<Series, 4> all_series{{{"floating, changed pixels", "#1f6fb4", "", false, changed},
                                            {"floating, flipped decisions", "#1f6fb4", "5 4", false, flipped},
                                            {"fixed, changed pixels", "#c8551b", "", true, changed},
                                            {"fixed, flipped decisions", "#c8551b", "5 4", true, flipped}}};

int precision(const NumberFormat& format) {
  return format.kind == NumberKind::fixed ? format.fraction_bits : format.significand_bits - 1;
}

std::string label(double at_x, double at_y, std::string_view anchor, const std::string& text) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", at_x, at_y, anchor,
                     xml_text(text));
}

std::string line(double x1, double y1, double x2, double y2, std::string_view color, std::string_view dashes = "") {
  return fmt::format(
      "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\" stroke-dasharray=\"{}\"/>\n", x1, y1,
      x2, y2, color, dashes.empty() ? "none" : dashes);
}

std::string grid(const Axis& axis) {
  std::string svg;
  for (int bits = least_bits; bits <= most_bits; bits += 4) {
    svg += line(x(bits), top, x(bits), bottom, "#e4e4e4") + label(x(bits), bottom + 18, "middle", std::to_string(bits));
  }
  svg += line(left, bottom, right, bottom, "#888") + label(left - 8, bottom + 4, "end", "0");
  for (int decade = 0; decade <= axis.decades(); ++decade) {
    const auto count = static_cast<std::uint64_t>(std::llround(std::pow(10, decade)));
    svg += line(left, axis.y(count), right, axis.y(count), "#e4e4e4") +
           label(left - 8, axis.y(count) + 4, "end", fmt::format("{}", count));
  }
  return svg;
}

/// Formats of one precision (fp16 and tf32, say) are drawn as points above each other; the line joins the best.
std::string draw(const Series& series, const std::vector<FormatRow>& rows, const Axis& axis) {
  std::map<int, std::uint64_t> best;
  std::string svg;
  for (const FormatRow& row : rows) {
    const int bits = precision(row.format);
    if ((row.format.kind == NumberKind::fixed) != series.fixed || !row.usable() || bits > most_bits) continue;
    const std::uint64_t count = series.count(row);
    const auto [place, is_new] = best.emplace(bits, count);
    if (!is_new) place->second = std::min(place->second, count);
    svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.6\" fill=\"{}\"><title>{}: {}</title></circle>\n",
                       x(bits), axis.y(count), series.color, row.format.name(), count);
  }
  std::string points;
  for (const auto& [bits, count] : best) points += fmt::format("{:.1f},{:.1f} ", x(bits), axis.y(count));
  return svg + fmt::format(
                   "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\" "
                   "stroke-dasharray=\"{}\"/>\n",
                   points, series.color, series.dashes.empty() ? "none" : series.dashes);
}

}  // namespace

std::string format_plot(const std::vector<FormatRow>& rows, const std::string& title) {
  std::uint64_t largest = 0;
  for (const FormatRow& row : rows) largest = std::max({largest, changed(row), flipped(row)});
  const Axis axis(largest);
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
      "font-family=\"sans-serif\" font-size=\"12\" fill=\"#222\">\n<rect width=\"{0}\" height=\"{1}\" "
      "fill=\"white\"/>\n",
      width, height);
  svg += label(left, 24, "start", title) + grid(axis);
  svg += label((left + right) / 2, bottom + 40, "middle", "bits after the binary point of 1: P - 1 or F");
  double legend = top + 10;
  for (const Series& series : all_series) {
    svg += draw(series, rows, axis);
    svg += line(right + 12, legend - 4, right + 34, legend - 4, series.color, series.dashes);
    svg += label(right + 38, legend, "start", std::string(series.name));
    legend += 18;
  }
  return svg + "</svg>\n";
}

}  // namespace pyrasim
