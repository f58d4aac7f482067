// SPDX-License-Identifier: Apache-2.0
#include <stdexcept>

#include "trace/tracer_among.h"

namespace pyrasim {
namespace {

template <class... Groups>
std::unique_ptr<Tracer> tracer_among_groups(const Scene& scene, const NumberFormat& format, Search search) {
  std::unique_ptr<Tracer> tracer;
  ((tracer = tracer_among(Groups(), scene, format, search)) || ...);
  return tracer;
}

}  // namespace

std::unique_ptr<Tracer> make_tracer(const Scene& scene, const NumberFormat& format, Search search) {
  auto tracer = tracer_among_groups<ProcessorNumbers, NamedFloats, NarrowFloats, WideFloats, WideFixed, NarrowFixed>(
      scene, format, search);
  if (!tracer) throw std::logic_error("number format " + format.name() + " is not compiled in");
  return tracer;
}

}  // namespace pyrasim
