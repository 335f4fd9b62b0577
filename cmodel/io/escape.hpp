// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace halfspace {

// text as it must stand in HTML or SVG, in an element or in an attribute's double quotes.
std::string escaped(std::string_view text);

// text in single quotes, for a shell.
std::string quoted(const std::string& text);

// text of a file or a command line as it is shown: control characters, and bytes that are no UTF-8,
// as \xNN, so that none reaches a terminal; of more than `most` bytes the first, and "...".
std::string printable(std::string_view text, std::size_t most = 4096);

}  // namespace halfspace
