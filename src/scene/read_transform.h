// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "json/json_reader.h"
#include "surface/affine_map.h"

namespace pyrasim {

/// The member "transform": steps applied in order, or one alone. Throws InputError.
AffineMap read_transform(const JsonReader& reader);

/// make(), whose MapError becomes the InputError of `reader`.
template <class Make>
auto mapped_at(const JsonReader& reader, const Make& make) {
  try {
    return make();
  } catch (const MapError& error) {
    reader.fail(error.what(), error.allowed);
  }
}

}  // namespace pyrasim
