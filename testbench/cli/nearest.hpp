// SPDX-License-Identifier: Apache-2.0
//
// What somebody may have meant who typed a name that does not exist.
#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace halfspace {

// Letters to change, insert, drop or swap with their neighbour, to make one word of the other.
inline std::size_t typing_distance(std::string_view a, std::string_view b) {
  // Rows of the table of prefixes: the one before the last, the last, and the one being made.
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t change = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, change});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before.swap(last);
    last.swap(row);
  }
  return last[b.size()];
}

// The name nearest to the word, or the only one that begins with it or that it begins with; empty
// when none is near. Dashes in front do not count.
inline std::string nearest(std::string_view word, std::span<const std::string> names) {
  const auto bare = [](std::string_view text) {
    return text.substr(std::min(text.find_first_not_of('-'), text.size()));
  };
  const std::string_view typed = bare(word);
  if (typed.empty() || typed.size() > 40) return {};
  std::size_t least = typed.size() <= 3 ? 1 : typed.size() <= 6 ? 2 : 3;
  std::string found;
  std::size_t begin = 0;
  std::string longer;
  for (const std::string& name : names) {
    const std::size_t distance = typing_distance(typed, bare(name));
    if (distance < least || (distance == least && found.empty())) {
      least = distance;
      found = name;
    }
    const bool more = bare(name).size() >= 3 && typed.starts_with(bare(name));
    if (more || bare(name).starts_with(typed)) {
      ++begin;
      longer = name;
    }
  }
  return begin == 1 ? longer : found;
}

// ": is it 'render'?" for a message; empty when no name is near.
inline std::string suggestion(std::string_view word, std::span<const std::string> names) {
  const std::string name = nearest(word, names);
  return name.empty() ? "" : ": is it '" + name + "'?";
}

}  // namespace halfspace
