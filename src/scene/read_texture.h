// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "json/json_reader.h"
#include "texture/texture.h"

namespace pyrasim {

/// Throws InputError.
Texture read_texture(const JsonReader& reader);

}  // namespace pyrasim
