// SPDX-License-Identifier: Apache-2.0
#include "intersect/intersector_among.h"

template std::unique_ptr<pyrasim::Intersector> pyrasim::intersector_among(WideFloats, const Scene&, const NumberFormat&,
                                                                          Search);
