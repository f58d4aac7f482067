// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace pyrasim {

/// `text` as the content of an XML element or a quoted attribute. What XML 1.0 has no character for, control characters
/// and bytes that are not UTF-8, shows as U+FFFD.
std::string xml_text(std::string_view text);

}  // namespace pyrasim
