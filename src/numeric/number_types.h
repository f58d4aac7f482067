// SPDX-License-Identifier: Apache-2.0
// From a number format chosen when the program runs to the type that computes in it. Add a format here, to a group.
#pragma once

#include <stdexcept>
#include <type_traits>

#include "numeric/fix.h"
#include "numeric/flt.h"
#include "numeric/number_format.h"

namespace pyrasim {

template <class... Numbers>
struct NumberTypes {};

// In groups, so that what is instantiated for each of them can be spread over several files.
using ProcessorNumbers = NumberTypes<double, float>;
using NamedFloats = NumberTypes<Fp16, Bf16, Tf32, Fp24>;
using NarrowFloats = NumberTypes<Flt<8, 9>, Flt<8, 10>, Flt<8, 12>, Flt<8, 13>, Flt<8, 14>, Flt<8, 15>, Flt<8, 16>>;
using WideFloats = NumberTypes<Flt<8, 17>, Flt<8, 18>, Flt<8, 19>, Flt<8, 20>, Flt<8, 21>, Flt<8, 22>, Flt<8, 23>,
                               Flt<8, 24>, Flt<8, 25>>;
using WideFixed = NumberTypes<Fix<64, 12>, Fix<64, 16>, Fix<64, 20>, Fix<64, 24>, Fix<64, 28>, Fix<64, 32>>;
using NarrowFixed =
    NumberTypes<Fix<48, 16>, Fix<48, 20>, Fix<48, 24>, Fix<32, 12>, Fix<32, 16>, Fix<32, 20>, Fix<24, 12>>;

template <class... A, class... B>
NumberTypes<A..., B...> operator+(NumberTypes<A...>, NumberTypes<B...>);

using CompiledNumberTypes =
    decltype(ProcessorNumbers() + NamedFloats() + NarrowFloats() + WideFloats() + WideFixed() + NarrowFixed());

template <class Number>
struct FormatOf;
template <>
struct FormatOf<double> {
  static constexpr NumberFormat value{};
};
template <>
struct FormatOf<float> {
  static constexpr NumberFormat value{NumberKind::processor, 32, 8, 24, 0};
};
template <int E, int P>
struct FormatOf<Flt<E, P>> {
  static constexpr NumberFormat value{NumberKind::floating, E + P, E, P, 0};
};
template <int W, int F>
struct FormatOf<Fix<W, F>> {
  static constexpr NumberFormat value{NumberKind::fixed, W, 0, W - 1, F};
};

namespace detail {

template <class Visitor, class First, class... Others>
decltype(auto) with_number_type(const NumberFormat& format, Visitor& visitor, NumberTypes<First, Others...>) {
  if (format == FormatOf<First>::value) return visitor(std::type_identity<First>());
  if constexpr (sizeof...(Others) > 0) {
    return with_number_type(format, visitor, NumberTypes<Others...>());
  } else {
    throw std::logic_error("number format " + format.name() + " is not compiled in");
  }
}

}  // namespace detail

/// visitor(std::type_identity<Number>()) for the type that computes in `format`, one of number_formats(). Instantiates
/// the visitor for every type.
template <class Visitor>
decltype(auto) with_number_type(const NumberFormat& format, Visitor visitor) {
  return detail::with_number_type(format, visitor, CompiledNumberTypes());
}

}  // namespace pyrasim
