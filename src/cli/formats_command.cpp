// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <iostream>

#include "cli/command.h"
#include "numeric/number_format.h"
#include "numeric/number_range.h"

namespace pyrasim::cli {
namespace {

std::string remark(const NumberFormat& format) {
  const std::string name = format.name();
  if (name == "double") return "IEEE 754 binary64; the default, computed by this machine's processor";
  if (name == "float") return "IEEE 754 binary32; computed by this machine's processor";
  const std::string systematic = fmt::format("e{}p{}", format.exponent_bits, format.significand_bits);
  std::string also = systematic == name ? "" : "also " + systematic;
  if (name == "fp16") return also + "; IEEE 754 binary16";
  if (name == "bf16") return also + "; bfloat16";
  if (name == "tf32") return also + "; TensorFloat-32";
  return also;
}

std::string floating_lines() {
  std::string text = fmt::format("{:<10}{:>5}{:>10}{:>13}{:>10}{:>15}{:>15}\n", "floating", "bits", "exponent",
                                 "significand", "below", "steps near 1", "steps near 0");
  for (const NumberFormat& format : number_formats()) {
    if (format.kind == NumberKind::fixed) continue;
    std::string line =
        fmt::format("{:<10}{:>5}{:>10}{:>13}{:>10}{:>15}{:>15}   {}", format.name(), format.bits, format.exponent_bits,
                    format.significand_bits, fmt::format("2^{}", integer_bits(format)),
                    fmt::format("2^{}", 1 - format.significand_bits),
                    fmt::format("2^-{}", finest_fraction_bits(format)), remark(format));
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + '\n';
  }
  return text;
}

std::string fixed_lines() {
  std::string text =
      fmt::format("{:<10}{:>5}{:>10}{:>13}{:>10}{:>15}\n", "fixed", "bits", "integer", "fraction", "below", "steps");
  for (const NumberFormat& format : number_formats()) {
    if (format.kind != NumberKind::fixed) continue;
    text += fmt::format("{:<10}{:>5}{:>10}{:>13}{:>10}{:>15}\n", format.name(), format.bits, integer_bits(format),
                        format.fraction_bits, fmt::format("2^{}", integer_bits(format)),
                        fmt::format("2^-{}", format.fraction_bits));
  }
  return text;
}

void print_formats() {
  std::cout
      << fmt::format(
             "The number formats that a datapath can compute in: double, float, and any eEpP or fixW.F. E bits of\n"
             "exponent are {} to {}, P of significand {} to {}; W bits in all {} to {}, F of fraction 0 to W - 1.\n"
             "--scalar of render, simulate and budget takes one for view vectors and intersections, or one for each:\n"
             "view_vectors=fp24,intersection=double. --formats of study numerics takes a list; without it the study\n"
             "takes these:\n\n",
             min_exponent_bits, max_exponent_bits, min_significand_bits, max_significand_bits, min_fixed_bits,
             max_fixed_bits)
      << floating_lines() << '\n'
      << fixed_lines()
      << "\nbelow: all numbers lie below it in magnitude. A significand counts its hidden bit, integer bits do not\n"
         "count the sign. Fixed point rounds to nearest, ties to even, and saturates.\n";
}

}  // namespace

void add_formats_command(const Command& program) {
  program.add_command("formats", "Say which number formats --scalar takes, and list bits and range of the usual ones.",
                      print_formats);
}

}  // namespace pyrasim::cli
