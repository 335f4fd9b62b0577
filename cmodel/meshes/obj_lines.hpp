// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace halfspace {

// The lines of OBJ text. They end in LF, CR LF or CR; a backslash at the end joins the next one,
// but not in a comment, where a path of Windows may end in one.
class ObjLines {
 public:
  explicit ObjLines(std::string_view text);

  // The next line; false at the end.
  bool next();
  std::string_view line() const { return line_; }
  // The number of its first physical line.
  std::size_t number() const { return number_; }
  // The file ends in it without a line end.
  bool is_cut() const { return rest_.empty() && !ends_with_line_; }
  // Comments that ended in a backslash so far, and the first one's line.
  std::size_t comments_with_backslash() const { return with_backslash_; }
  std::size_t first_with_backslash() const { return first_with_backslash_; }
  std::size_t bytes_left() const { return rest_.size(); }

 private:
  std::string_view rest_;
  std::string_view line_;
  std::string joined_;
  bool ends_with_line_;
  std::size_t number_ = 0;
  std::size_t next_number_ = 1;
  std::size_t with_backslash_ = 0;
  std::size_t first_with_backslash_ = 0;
};

}  // namespace halfspace
