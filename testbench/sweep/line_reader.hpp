// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace halfspace {

// A file's lines from the first on. Between two reads the file is closed, so that any number of
// readers takes no more than one file descriptor.
class LineReader {
 public:
  // buffer: bytes to read at a time.
  LineReader(std::string path, std::size_t buffer) : path_(std::move(path)), buffer_(buffer) {}

  // The next line with its newline; false at the end, where a line without a newline is none.
  // Throws Error(kFileRead).
  bool next(std::string& line);

 private:
  bool fill();

  std::string path_;
  std::size_t buffer_;
  std::uint64_t at_ = 0;  // of the file, after text_
  std::string text_;
  std::size_t done_ = 0;  // of text_
};

// The last line of a file, of up to 64 KiB; empty when it does not end in a newline.
std::string last_line(const std::string& path);

}  // namespace halfspace
