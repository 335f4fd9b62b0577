// SPDX-License-Identifier: Apache-2.0
//
// Text of other people, such as a name from a file, as it may be sent to a terminal: one short
// line. Without the library, so that every part may use it.
#pragma once

#include <string>
#include <string_view>

namespace halfspace {

// Bytes of the UTF-8 character at the front of a text that is not empty; 0 when there is none, or
// one that moves a terminal's cursor or colours it (U+0000..U+001F, U+007F..U+009F).
inline std::size_t printable_bytes(std::string_view text) {
  const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = byte(0);
  if (first < 0x80) return first >= 0x20 && first != 0x7f ? 1 : 0;
  const std::size_t size = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4 || text.size() < size) return 0;
  for (std::size_t i = 1; i < size; ++i) {
    if (byte(i) >> 6 != 2) return 0;
  }
  return first == 0xc2 && byte(1) < 0xa0 ? 0 : size;
}

// A message's first line.
inline std::string_view first_line(std::string_view text) {
  return text.substr(0, text.find_first_of("\r\n"));
}

// The text with \xHH for each byte that is not printable, a line's end too. One longer than
// kLongestLine loses its middle: the place stands in front, the reason at the end.
inline constexpr std::size_t kLongestLine = 480;
inline std::string printable(std::string_view text) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  constexpr std::size_t kEnd = kLongestLine / 3;
  std::string out;
  for (bool cut = false; !text.empty();) {
    if (!cut && out.size() > kLongestLine - kEnd && text.size() > kEnd) {
      std::size_t skip = text.size() - kEnd;
      while (skip < text.size() && (static_cast<unsigned char>(text[skip]) >> 6) == 2) ++skip;
      text.remove_prefix(skip);
      out += " ... ";
      cut = true;
      continue;
    }
    const std::size_t size = printable_bytes(text);
    if (size != 0) {
      out += text.substr(0, size);
    } else {
      const auto value = static_cast<unsigned char>(text[0]);
      out += "\\x";
      out += kDigits[value >> 4];
      out += kDigits[value & 15];
    }
    text.remove_prefix(size == 0 ? 1 : size);
  }
  return out;
}

}  // namespace halfspace
