// SPDX-License-Identifier: Apache-2.0
#include "study/format_study.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace pyrasim {
namespace {

bool is_fixed(const NumberFormat& format) { return format.kind == NumberKind::fixed; }

/// "e8 p17", "i11 f20"
std::string widths(const NumberFormat& format) {
  if (is_fixed(format)) return fmt::format("i{} f{}", format.bits - 1 - format.fraction_bits, format.fraction_bits);
  return fmt::format("e{} p{}", format.exponent_bits, format.significand_bits);
}

std::string decibels(double psnr) { return std::isinf(psnr) ? "inf" : fmt::format("{:.1f}", psnr); }

std::string verdict(const std::vector<FormatRow>& rows, bool fixed) {
  const auto format = smallest_unchanged(rows, fixed);
  const char* kind = fixed ? "fixed point" : "floating point";
  if (!format) return fmt::format("  {}: none of these\n", kind);
  return fmt::format("  {}: {}, {} bits ({})\n", kind, format->name(), format->bits, widths(*format));
}

}  // namespace

std::optional<NumberFormat> smallest_unchanged(const std::vector<FormatRow>& rows, bool fixed) {
  std::optional<NumberFormat> smallest;
  for (const FormatRow& row : rows) {
    if (is_fixed(row.format) != fixed || !row.usable() || row.changed_pixels > 0) continue;
    const auto size = [](const NumberFormat& format) { return std::pair(format.bits, format.fraction_bits); };
    if (!smallest || size(row.format) < size(*smallest)) smallest = row.format;
  }
  return smallest;
}

std::string format_table_header() {
  return fmt::format("{:>9} {:>4} {:>7} {:>9} {:>9} {:>7} {:>7} {:>7} {:>9} {:>10} {:>10}\n", "format", "bits", "",
                     "changed", "flipped", "extra", "lost", "PSNR dB", "rays", "cycles", "saturated");
}

std::string format_table_row(const FormatRow& row) {
  const std::string name = fmt::format("{:>9} {:>4} {:>7} ", row.format.name(), row.format.bits, widths(row.format));
  if (!row.usable()) return name + row.refused + "\n";
  return name + fmt::format("{:>9} {:>9} {:>7} {:>7} {:>7} {:>9} {:>10} {:>10}\n", row.changed_pixels,
                            row.flips.flipped, row.flips.extra_subdivisions, row.flips.lost_subdivisions,
                            decibels(row.psnr), row.rays, row.cycles,
                            row.counts_events() ? fmt::format("{}", row.events.saturations) : "-");
}

std::string format_verdict(const std::vector<FormatRow>& rows) {
  return "the smallest format that leaves every pixel of the 8-bit picture as in double:\n" + verdict(rows, false) +
         verdict(rows, true);
}

std::string format_csv_header() {
  return "format,bits,exponent_bits,significand_bits,fraction_bits,changed_pixels,decisions,flipped,extra_subdivisions,"
         "lost_subdivisions,psnr,rays,cycles,saturations,underflows,inexact,divisions_by_zero,invalid\n";
}

std::string format_csv_row(const FormatRow& row) {
  const NumberFormat& format = row.format;
  const std::string name = fmt::format("{},{},{},{},{},", format.name(), format.bits, format.exponent_bits,
                                       format.significand_bits, format.fraction_bits);
  if (!row.usable()) return name + ",,,,,,,,,,,,\n";
  const std::string events = row.counts_events()
                                 ? fmt::format("{},{},{},{},{}\n", row.events.saturations, row.events.underflows,
                                               row.events.inexact, row.events.divisions_by_zero, row.events.invalid)
                                 : ",,,,\n";
  return name +
         fmt::format("{},{},{},{},{},{},{},{},", row.changed_pixels, row.flips.decisions, row.flips.flipped,
                     row.flips.extra_subdivisions, row.flips.lost_subdivisions, row.psnr, row.rays, row.cycles) +
         events;
}

}  // namespace pyrasim
