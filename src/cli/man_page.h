// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "cli/command_description.h"

namespace pyrasim::cli {

/// The manual page of section 1, in the man macros of roff (man-pages(7), groff_man(7)).
std::string man_page(const CommandDescription& program, std::string_view version);

}  // namespace pyrasim::cli
