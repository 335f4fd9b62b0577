// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "interrupt.hpp"

namespace halfspace {

// A file that is whole or not there: written beside its destination under a temporary name and
// renamed by commit(). Destroyed without commit(), it leaves nothing behind. A link stays one: what
// it names is written. Devices, pipes, /dev/stdout and "-", which is standard output, are written
// in place. Every failure throws Error(kFileWrite) that names the destination and the reason; an
// output that is an input (is_input()), Error(kUsage).
class OutputFile {
 public:
  explicit OutputFile(std::string path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  const std::string& path() const { return path_; }
  // Where it is written: for libraries that open a file by its name.
  const std::string& temporary() const { return temporary_; }
  void write(std::string_view bytes);
  std::FILE* stream() { return file_; }  // for libraries that write to a stream
  // Everything is written and the file closed, still under its temporary name.
  void finish();
  // finish(), if that was not called, and the file is there. What was said on standard output
  // before is written first: when that fails, no file is.
  void commit();

 private:
  [[noreturn]] void fail(const char* what);

  std::string path_;
  std::string target_;  // path_ behind its links
  std::string temporary_;
  std::FILE* file_ = nullptr;
  std::optional<RemovedOnInterrupt> removed_;  // the temporary file is there
};

// Files that belong together: all are finished before the first is there, so that a full disk
// leaves none of them. A device is written in place, in the order of open().
class OutputGroup {
 public:
  OutputFile& open(const std::string& path);
  void commit();

 private:
  std::vector<std::unique_ptr<OutputFile>> files_;
};

// A file of that text.
void write_text(const std::string& path, std::string_view text);

// Throws Error(kFileWrite) when path could not be created, Error(kUsage) when it is an input: asked
// before long work starts, and after note_input().
void check_writable(const std::string& path);

// Throws Error(kFileWrite) when standard output does not take what was said so far.
void flush_standard_output();

// Throws Error(kUsage) when two of the outputs are the same file: one would replace the other.
// Empty names count as none.
void check_distinct(const std::vector<std::string>& paths);

// The whole of a file. Throws Error(kFileRead).
std::string read_file(const std::string& path);

}  // namespace halfspace
