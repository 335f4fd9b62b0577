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

}  // namespace halfspace
