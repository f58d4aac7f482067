// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "scene/scene.h"

namespace pyrasim {

/// Whether a scene file of that name is read as NFF: it ends in ".nff".
bool is_nff(const std::filesystem::path& file);

/// Reads a scene in the Neutral File Format (Haines, A Proposal for Standard Graphics Environments, IEEE CG&A 7(11),
/// 1987): v, b, l, f, s, c, p and pp. Surfaces have the colour times Kd of the last f, and both their sides are seen.
/// Throws InputError "FILE:LINE: what is wrong; what is allowed".
Scene load_nff(const std::filesystem::path& file);
/// The same of a file's text; `name` is the file's.
Scene read_nff(std::string_view text, const std::string& name);

}  // namespace pyrasim
