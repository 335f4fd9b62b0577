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
#include "input_files.hpp"

namespace halfspace {

namespace fs = std::filesystem;

namespace {

// Where a file of that name is to be written.
struct Target {
  fs::path path;  // behind all links
  // A device such as /dev/full, a pipe, or what /dev/stdout stands for: there is nothing to rename.
  bool in_place = false;
};

Target target_of(const std::string& path) {
  constexpr int kMostLinks = 40;
  std::error_code failed;
  if (path == kStandardStream) return {path, true};
  Target target{fs::absolute(path, failed)};
  for (int i = 0; i < kMostLinks; ++i) {
    const std::string name = target.path.string();
    target.in_place = name.starts_with("/proc/") || name.starts_with("/dev/fd/");
    if (target.in_place || !fs::is_symlink(target.path, failed)) break;
    const fs::path next = fs::read_symlink(target.path, failed);
    target.path = target.path.parent_path() / next;
  }
  if (fs::exists(target.path, failed) && !fs::is_regular_file(target.path, failed)) {
    target.in_place = true;
  }
  return target;
}

void refuse_input(const std::string& path) {
  if (is_input(path)) throw Error(ErrorCode::kUsage, path, "is an input: it would be replaced");
}

std::FILE* open_to_write(const std::string& path) {
  if (path != kStandardStream) return std::fopen(path.c_str(), "wb");
  const int copy = ::dup(STDOUT_FILENO);
  return copy < 0 ? nullptr : ::fdopen(copy, "wb");
}

}  // namespace

OutputFile::OutputFile(std::string path) : path_(std::move(path)) {
  std::error_code ignored;
  refuse_input(path_);
  if (fs::is_directory(path_, ignored)) {
    throw Error(ErrorCode::kFileWrite, path_, "cannot write: it is a directory");
  }
  const Target target = target_of(path_);
  target_ = target.path.string();
  temporary_ = target.in_place ? path_ : target_ + ".partial-" + std::to_string(::getpid());
  const InterruptsHeld held;  // until it is known what to remove
  file_ = open_to_write(temporary_);
  if (file_ == nullptr) {
    throw Error(ErrorCode::kFileWrite, path_, std::string("cannot write: ") + std::strerror(errno));
  }
  if (!target.in_place) removed_.emplace(temporary_);
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
  if (removed_) refuse_input(path_);  // it may have been read since it was opened
  if (file_ == nullptr) return;
  if (std::fflush(file_) != 0 || std::ferror(file_) != 0) fail("cannot write");
  const int closed = std::fclose(std::exchange(file_, nullptr));
  if (closed != 0) fail("cannot write");
}

void OutputFile::commit() {
  finish();
  flush_standard_output();
  if (!removed_) return;
  const InterruptsHeld held;
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0) {
    fail("cannot rename the finished file into place");
  }
  if (!is_removed_on_interrupt(target_)) outputs_stay_on_interrupt();
  removed_.reset();
}

OutputFile& OutputGroup::open(const std::string& path) {
  files_.push_back(std::make_unique<OutputFile>(path));
  return *files_.back();
}

void OutputGroup::commit() {
  for (const auto& file : files_) file->finish();
  const InterruptsHeld held;  // all or none
  for (const auto& file : files_) file->commit();
}

void write_text(const std::string& path, std::string_view text) {
  OutputFile file(path);
  file.write(text);
  file.commit();
}

void flush_standard_output() {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return;
  throw Error(ErrorCode::kFileWrite, "", "cannot write to standard output");
}

void check_writable(const std::string& path) {
  if (path.empty()) throw Error(ErrorCode::kUsage, "", "an output has an empty name");
  refuse_input(path);
  if (path == kStandardStream) return;
  std::error_code ignored;
  if (target_of(path).in_place && !fs::is_directory(path, ignored)) {
    // To open a pipe and close it would end what its reader reads.
    if (::access(path.c_str(), W_OK) == 0) return;
    throw Error(ErrorCode::kFileWrite, path, std::string("cannot write: ") + std::strerror(errno));
  }
  OutputFile probe(path);
}

void check_distinct(const std::vector<std::string>& paths) {
  std::vector<fs::path> seen;
  for (const std::string& path : paths) {
    if (path.empty()) continue;
    const Target target = target_of(path);
    if (target.in_place) continue;  // one after the other
    std::error_code ignored;
    const fs::path whole = fs::weakly_canonical(target.path, ignored);
    if (std::find(seen.begin(), seen.end(), whole) != seen.end()) {
      throw Error(ErrorCode::kUsage, path, "two outputs have this name");
    }
    seen.push_back(whole);
  }
}

std::string read_file(const std::string& path) {
  note_input(path);
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
