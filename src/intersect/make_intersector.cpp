// SPDX-License-Identifier: Apache-2.0
#include <stdexcept>

#include "intersect/intersector_among.h"

namespace pyrasim {
namespace {

template <class... Groups>
std::unique_ptr<Intersector> intersector_among_groups(const Scene& scene, const NumberFormat& format, Search search) {
  std::unique_ptr<Intersector> intersector;
  ((intersector = intersector_among(Groups(), scene, format, search)) || ...);
  return intersector;
}

}  // namespace

std::unique_ptr<Intersector> make_intersector(const Scene& scene, const NumberFormat& format, Search search) {
  auto intersector =
      intersector_among_groups<ProcessorNumbers, NamedFloats, NarrowFloats, WideFloats, WideFixed, NarrowFixed>(
          scene, format, search);
  if (!intersector) throw std::logic_error("number format " + format.name() + " is not compiled in");
  return intersector;
}

}  // namespace pyrasim
