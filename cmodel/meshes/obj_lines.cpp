// SPDX-License-Identifier: Apache-2.0
#include "obj_lines.hpp"

#include <algorithm>

#include "../io/scan.hpp"

namespace halfspace {
namespace {

// A comment of its own line or after a statement; names may have a # in them, but not after a
// blank.
bool has_comment(std::string_view line) {
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '#' && (i == 0 || is_blank(line[i - 1]))) return true;
  }
  return false;
}

}  // namespace

ObjLines::ObjLines(std::string_view text)
    : rest_(text), ends_with_line_(text.empty() || text.back() == '\n' || text.back() == '\r') {
  if (rest_.starts_with("\xef\xbb\xbf")) rest_.remove_prefix(3);
}

bool ObjLines::next() {
  if (rest_.empty()) return false;
  number_ = next_number_;
  joined_.clear();
  for (bool is_first = true;; is_first = false) {
    const std::size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
    line_ = rest_.substr(0, end);
    const bool crlf = rest_.substr(end, 2) == "\r\n";
    rest_.remove_prefix(std::min(rest_.size(), end + (crlf ? 2 : 1)));
    ++next_number_;
    bool more = !line_.empty() && line_.back() == '\\';
    if (more && has_comment(line_)) {
      if (with_backslash_++ == 0) first_with_backslash_ = next_number_ - 1;
      more = false;
    }
    if (is_first && !more) return true;  // as it stands in the file
    joined_.append(line_);
    if (more) joined_.back() = ' ';
    line_ = joined_;
    if (!more || rest_.empty()) return true;
  }
}

}  // namespace halfspace
