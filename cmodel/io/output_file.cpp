// SPDX-License-Identifier: Apache-2.0
#include "output_file.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <memory>
#include <utility>

#include "error.hpp"

namespace halfspace {

namespace fs = std::filesystem;

OutputFile::OutputFile(std::string path) : path_(std::move(path)) {
  std::error_code ignored;
  if (fs::is_directory(path_, ignored)) {
    throw Error(ErrorCode::kFileWrite, path_, "cannot write: it is a directory");
  }
  temporary_ = path_ + ".partial-" + std::to_string(::getpid());
  // A device such as /dev/full or /dev/stdout is written in place: there is nothing to rename.
  if (fs::exists(path_, ignored) && !fs::is_regular_file(path_, ignored)) temporary_ = path_;
  file_ = std::fopen(temporary_.c_str(), "wb");
  if (file_ == nullptr) {
    throw Error(ErrorCode::kFileWrite, path_, std::string("cannot write: ") + std::strerror(errno));
  }
  if (temporary_ != path_) removed_.emplace(temporary_);
}

OutputFile::~OutputFile() {
  if (file_ != nullptr) std::fclose(file_);
  if (removed_) std::remove(temporary_.c_str());
}

void OutputFile::fail(const char* what) {
  throw Error(ErrorCode::kFileWrite, path_, std::string(what) + ": " + std::strerror(errno));
}

void OutputFile::write(std::string_view bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size()) fail("cannot write");
}

void OutputFile::finish() {
  if (file_ == nullptr) return;
  if (std::fflush(file_) != 0 || std::ferror(file_) != 0) fail("cannot write");
  const int closed = std::fclose(std::exchange(file_, nullptr));
  if (closed != 0) fail("cannot write");
}

void OutputFile::commit() {
  finish();
  if (!removed_) return;
  if (std::rename(temporary_.c_str(), path_.c_str()) != 0) {
    fail("cannot rename the finished file into place");
  }
  removed_.reset();
}

OutputFile& OutputGroup::open(const std::string& path) {
  files_.push_back(std::make_unique<OutputFile>(path));
  return *files_.back();
}

void OutputGroup::commit() {
  for (const auto& file : files_) file->finish();
  for (const auto& file : files_) file->commit();
}

void write_text(const std::string& path, std::string_view text) {
  OutputFile file(path);
  file.write(text);
  file.commit();
}

void check_writable(const std::string& path) {
  if (path.empty()) throw Error(ErrorCode::kUsage, "", "an output has an empty name");
  OutputFile probe(path);
}

void check_distinct(const std::vector<std::string>& paths) {
  std::vector<fs::path> seen;
  for (const std::string& path : paths) {
    std::error_code ignored;
    const fs::path whole = fs::weakly_canonical(fs::absolute(path, ignored), ignored);
    // What is written to a device goes one after the other.
    if (path.empty() || (fs::exists(whole, ignored) && !fs::is_regular_file(whole, ignored))) {
      continue;
    }
    if (std::find(seen.begin(), seen.end(), whole) != seen.end()) {
      throw Error(ErrorCode::kUsage, path, "two outputs have this name");
    }
    seen.push_back(whole);
  }
}

std::string read_file(const std::string& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) {
    throw Error(ErrorCode::kFileRead, path, "cannot read: it is a directory");
  }
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                             &std::fclose);
  if (!file) {
    throw Error(ErrorCode::kFileRead, path, std::string("cannot read: ") + std::strerror(errno));
  }
  std::string text;
  std::array<char, 1 << 16> buffer;
  while (const std::size_t got = std::fread(buffer.data(), 1, buffer.size(), file.get())) {
    text.append(buffer.data(), got);
  }
  if (std::ferror(file.get()) != 0) {
    throw Error(ErrorCode::kFileRead, path, std::string("cannot read: ") + std::strerror(errno));
  }
  return text;
}

}  // namespace halfspace
