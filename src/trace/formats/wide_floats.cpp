// SPDX-License-Identifier: Apache-2.0
#include "trace/tracer_among.h"

template std::unique_ptr<pyrasim::Tracer> pyrasim::tracer_among(WideFloats, const Scene&, const NumberFormat&, Search);
