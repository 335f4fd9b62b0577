// SPDX-License-Identifier: Apache-2.0
//
// Splitting text into tokens and tokens into numbers, for the readers of text formats. The current
// locale plays no part.
#pragma once

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace halfspace {

constexpr bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f';
}

// Takes the next blank-separated token off the front of `text`; empty at its end.
inline std::string_view next_token(std::string_view& text) {
  std::size_t begin = 0;
  while (begin < text.size() && is_blank(text[begin])) ++begin;
  std::size_t end = begin;
  while (end < text.size() && !is_blank(text[end])) ++end;
  const std::string_view token = text.substr(begin, end - begin);
  text.remove_prefix(end);
  return token;
}

// The whole token as a number, decimal, a leading + allowed; nothing when it is none. "nan" and
// "inf" are numbers; one too large for a double is infinite, one too small is 0.
inline std::optional<double> parse_number(std::string_view token) {
  if (token.size() > 1 && token[0] == '+' && token[1] != '-') token.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (end != token.data() + token.size() || error == std::errc::invalid_argument) return {};
  if (error == std::errc::result_out_of_range) {
    return std::strtod(std::string(token).c_str(), nullptr);
  }
  return value;
}

// The whole token as a whole number; nothing when it is none or does not fit.
inline std::optional<std::int64_t> parse_integer(std::string_view token) {
  if (token.size() > 1 && token[0] == '+' && token[1] != '-') token.remove_prefix(1);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (end != token.data() + token.size() || error != std::errc()) return {};
  return value;
}

// True when a float holds it without becoming infinite.
inline bool is_finite_float(double value) {
  return std::abs(value) <= static_cast<double>(std::numeric_limits<float>::max());
}

// A token as it is quoted in an error: at most 32 printable characters.
inline std::string shown(std::string_view token) {
  std::string text = "'";
  for (const char c : token.substr(0, 32)) text += c >= ' ' && c <= '~' ? c : '?';
  return text + (token.size() > 32 ? "...'" : "'");
}

}  // namespace halfspace
