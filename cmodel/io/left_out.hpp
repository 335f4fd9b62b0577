// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace halfspace {

// What a file has that is not drawn, or not as the file says, by kind: counted for the statistics,
// and said in one note.
class LeftOut {
 public:
  struct Kind {
    std::string key;   // in the statistics
    std::string one;   // "a face of fewer than 3 corners"
    std::string many;  // "faces of fewer than 3 corners"
    std::uint64_t count = 0;
    std::size_t line = 0;  // of the first; 0: not known
  };

  // key: its name in the statistics. one, many: how the note calls it.
  void add(std::string_view key, std::string_view one, std::string_view many,
           std::uint64_t count = 1, std::size_t line = 0);

  bool empty() const { return kinds_.empty(); }
  const std::vector<Kind>& kinds() const { return kinds_; }
  // "left out: 1 face of fewer than 3 corners (line 9), 600 bytes after the data".
  std::string note() const;

 private:
  std::vector<Kind> kinds_;
};

}  // namespace halfspace
