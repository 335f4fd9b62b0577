// SPDX-License-Identifier: Apache-2.0
#include "line_reader.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "io/error.hpp"

namespace halfspace {
namespace {

// Up to `count` bytes of a file from `at` on.
std::string read_part(const std::string& path, std::uint64_t at, std::size_t count) {
  std::string text(count, '\0');
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const ssize_t got =
      file < 0 ? -1 : ::pread(file, text.data(), text.size(), static_cast<off_t>(at));
  const int reason = errno;
  if (file >= 0) ::close(file);
  if (got < 0) {
    throw Error(ErrorCode::kFileRead, path, std::string("cannot read: ") + std::strerror(reason));
  }
  text.resize(static_cast<std::size_t>(got));
  return text;
}

}  // namespace

bool LineReader::fill() {
  const std::string more = read_part(path_, at_, buffer_);
  at_ += more.size();
  text_.erase(0, done_);
  done_ = 0;
  text_ += more;
  return !more.empty();
}

bool LineReader::next(std::string& line) {
  for (;;) {
    const std::size_t end = text_.find('\n', done_);
    if (end != std::string::npos) {
      line.assign(text_, done_, end + 1 - done_);
      done_ = end + 1;
      return true;
    }
    if (!fill()) return false;
  }
}

std::string last_line(const std::string& path) {
  constexpr std::size_t kMost = 1 << 16;
  std::error_code failed;
  const std::uint64_t size = std::filesystem::file_size(path, failed);
  if (failed) return {};
  const std::string text = read_part(path, size > kMost ? size - kMost : 0, kMost);
  if (text.empty() || text.back() != '\n') return {};
  const std::size_t before =
      text.size() < 2 ? std::string::npos : text.rfind('\n', text.size() - 2);
  return text.substr(before == std::string::npos ? 0 : before + 1);
}

}  // namespace halfspace
