// SPDX-License-Identifier: Apache-2.0
//
// An option's named values, written once: what is read, what --help shows, what a refusal lists.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "io/error.hpp"

namespace halfspace {

template <class Value>
struct Choice {
  std::string_view name;
  Value value;
};

// "none|back|front"
template <class Value, std::size_t kCount>
std::string type_name_of(std::span<const Choice<Value>, kCount> choices) {
  std::string out;
  for (const Choice<Value>& choice : choices) {
    if (!out.empty()) out += '|';
    out += choice.name;
  }
  return out;
}

// The value with that name. Throws Error(code), "'left' is not none, back or front".
template <class Value, std::size_t kCount>
Value chosen(std::span<const Choice<Value>, kCount> choices, std::string_view name,
             const char* option, ErrorCode code = ErrorCode::kUsage) {
  std::string text = "'";
  text.append(name.substr(0, 40)).append("' is not ");
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (choices[i].name == name) return choices[i].value;
    if (i != 0) text += i + 1 == choices.size() ? " or " : ", ";
    text += choices[i].name;
  }
  throw Error(code, option, text);
}

}  // namespace halfspace
