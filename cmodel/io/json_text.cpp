// SPDX-License-Identifier: Apache-2.0
#include "json_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

namespace halfspace {
namespace {

std::string place_at(std::string_view text, std::size_t byte, const std::string& place) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text.size()));
  return fmt::format("{}:{}", place, 1 + std::count(text.begin(), end, '\n'));
}

// Where it is nested too deep; npos: nowhere. Before the text is known to be JSON, so that the
// library never sees one that is.
std::size_t too_deep(std::string_view text) {
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\') ++i;
      if (c == '"') in_string = false;
    } else if (c == '"') {
      in_string = true;
    } else if (c == '[' || c == '{') {
      if (++depth > kMostJsonDepth) return i;
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return std::string_view::npos;
}

}  // namespace

nlohmann::json parse_json(std::string_view text, const std::string& place,
                          const JsonFaults& faults) {
  const std::size_t deep = too_deep(text);
  if (deep != std::string_view::npos) {
    throw Error(faults.broken, place_at(text, deep, place),
                fmt::format("JSON nested deeper than {} levels", kMostJsonDepth));
  }
  std::vector<std::set<std::string>> keys(kMostJsonDepth + 2);  // of the objects that are open
  std::string twice;
  const auto see = [&](int depth, nlohmann::json::parse_event_t event, nlohmann::json& parsed) {
    using Event = nlohmann::json::parse_event_t;
    const auto level = static_cast<std::size_t>(depth);
    if (event == Event::object_start) keys[level + 1].clear();
    if (event == Event::key && !keys[level].insert(parsed.get<std::string>()).second) {
      twice = parsed.get<std::string>();
    }
    return true;
  };
  nlohmann::json json;
  try {
    json = nlohmann::json::parse(text, see);
  } catch (const nlohmann::json::parse_error& error) {
    throw Error(faults.broken, place_at(text, error.byte, place), "not valid JSON");
  } catch (const nlohmann::json::out_of_range& error) {
    const std::string_view what = error.what();
    const std::size_t quote = std::min(what.find('\''), what.size());
    throw Error(faults.range, place,
                fmt::format("{:.40} is beyond every number's range", what.substr(quote)));
  }
  if (!twice.empty()) {
    throw Error(faults.twice, place, fmt::format("key '{:.40}' is there twice", twice));
  }
  return json;
}

}  // namespace halfspace
