// SPDX-License-Identifier: Apache-2.0
#include "trace/tracer_among.h"

template std::unique_ptr<pyrasim::Tracer> pyrasim::tracer_among(NarrowFloats, const Scene&, const NumberFormat&,
                                                                Search);
