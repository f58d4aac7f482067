// SPDX-License-Identifier: Apache-2.0
// The format in which a thread's Flt and Fix compute. An operator has no other way to know: whoever holds numbers of a
// format keeps it beside them, and sets it while he computes with them.
#pragma once

#include <concepts>
#include <utility>

#include "numeric/fix.h"
#include "numeric/flt.h"
#include "numeric/number_format.h"

namespace pyrasim {

/// All that computing in a format of `Scalar` takes.
template <class Scalar>
class ScalarFormat {
 public:
  /// Throws std::logic_error if `Scalar` cannot have it.
  explicit ScalarFormat(const NumberFormat& format) : format_(format) {}
  /// The one that is set on this thread.
  static ScalarFormat current() { return ScalarFormat(Scalar::format()); }

  NumberFormat number_format() const { return format_.number_format(); }
  const typename Scalar::Format& operator*() const { return format_; }

 private:
  explicit ScalarFormat(const typename Scalar::Format& format) : format_(format) {}

  typename Scalar::Format format_;
};

/// double and float have one format each.
template <std::floating_point Scalar>
class ScalarFormat<Scalar> {
 public:
  static ScalarFormat current() { return {}; }
  static NumberFormat number_format() { return std::same_as<Scalar, float> ? NumberFormat::single() : NumberFormat(); }
};

/// While it lives, this thread's numbers of type `Scalar` are of a format; then of the one before again.
template <class Scalar>
class FormatScope {
 public:
  explicit FormatScope(const ScalarFormat<Scalar>& format) : before_(std::exchange(Scalar::format(), *format)) {}
  explicit FormatScope(const NumberFormat& format) : FormatScope(ScalarFormat<Scalar>(format)) {}
  FormatScope(const FormatScope&) = delete;
  FormatScope& operator=(const FormatScope&) = delete;
  ~FormatScope() { Scalar::format() = before_; }

 private:
  typename Scalar::Format before_;
};

template <std::floating_point Scalar>
class FormatScope<Scalar> {
 public:
  explicit FormatScope(const ScalarFormat<Scalar>&) {}
};

/// The format of this thread's numbers of type `Scalar`.
template <class Scalar>
NumberFormat format_of() {
  return ScalarFormat<Scalar>::current().number_format();
}

}  // namespace pyrasim
