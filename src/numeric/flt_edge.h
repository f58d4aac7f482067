// SPDX-License-Identifier: Apache-2.0
// Operations of Flt at the edges of its range: overflow, subnormal results, zero, infinities and NaN. Rare, hence
// apart.
#pragma once

#include "numeric/flt_format.h"

/// All operands and results are values of the format, held as doubles; of convert() only the result is. Counts
/// arithmetic_events. Without a format each throws std::logic_error: every operation comes here then.
namespace pyrasim::flt_edge {

[[gnu::cold]] double convert(const FltFormat& format, double x);
[[gnu::cold]] double add(const FltFormat& format, double a, double b);
[[gnu::cold]] double multiply(const FltFormat& format, double a, double b);
[[gnu::cold]] double divide(const FltFormat& format, double a, double b);
[[gnu::cold]] double square_root(const FltFormat& format, double x);

/// Whether product = a * b exactly, where it holds nearly and the product of doubles need not be exact.
[[gnu::cold]] bool is_product(double product, double a, double b);

}  // namespace pyrasim::flt_edge
