// SPDX-License-Identifier: Apache-2.0
// The kernels compiled for a group of number formats, a file for each group: none takes long to compile, and they
// compile side by side.
#pragma once

#include <memory>

#include "intersect/scene_intersector.h"

namespace pyrasim {

/// The intersector for `format` if that is the format of one of `Numbers`; else none.
template <class... Numbers>
std::unique_ptr<Intersector> intersector_among(NumberTypes<Numbers...>, const Scene& scene, const NumberFormat& format,
                                               Search search) {
  std::unique_ptr<Intersector> intersector;
  const auto make = [&]<class Number>(std::type_identity<Number>) {
    if (format == FormatOf<Number>::value) intersector = std::make_unique<SceneIntersector<Number>>(scene, search);
  };
  (make(std::type_identity<Numbers>()), ...);
  return intersector;
}

extern template std::unique_ptr<Intersector> intersector_among(ProcessorNumbers, const Scene&, const NumberFormat&,
                                                               Search);
extern template std::unique_ptr<Intersector> intersector_among(NamedFloats, const Scene&, const NumberFormat&, Search);
extern template std::unique_ptr<Intersector> intersector_among(NarrowFloats, const Scene&, const NumberFormat&, Search);
extern template std::unique_ptr<Intersector> intersector_among(WideFloats, const Scene&, const NumberFormat&, Search);
extern template std::unique_ptr<Intersector> intersector_among(WideFixed, const Scene&, const NumberFormat&, Search);
extern template std::unique_ptr<Intersector> intersector_among(NarrowFixed, const Scene&, const NumberFormat&, Search);

}  // namespace pyrasim
