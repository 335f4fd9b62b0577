// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include "io/error.hpp"
#include "io/output_file.hpp"
#include "io/tcov.hpp"
#include "shard.hpp"

namespace halfspace {
namespace {

namespace fs = std::filesystem;

std::string host_name() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "host";
}

struct Whole {
  std::size_t bytes = 0;
  std::uint64_t records = 0;
  std::uint64_t failed = 0;
};

// The records at the start of a text that are whole and the shard's, in order.
Whole whole_records(const std::string& text, const Shard& shard) {
  Whole out;
  for (;;) {
    const std::size_t end = text.find('\n', out.bytes);
    if (end == std::string::npos) return out;
    const auto line = text.begin() + static_cast<std::ptrdiff_t>(out.bytes);
    const auto json = nlohmann::json::parse(line, text.begin() + static_cast<std::ptrdiff_t>(end),
                                            nullptr, false);
    const std::uint64_t expected = shard.index + out.records * shard.count;
    if (!json.is_object() || json.value("case", nlohmann::json()) != expected) return out;
    ++out.records;
    out.failed += record_failed(json) ? 1 : 0;
    out.bytes = end + 1;
  }
}

}  // namespace

ShardWriter::ShardWriter(const std::string& folder, const Shard& shard, const Provenance& from,
                         std::uint64_t cases)
    : folder_(folder),
      path_((fs::path(folder) / shard_file_name(shard)).string()),
      prefix_(fmt::format("{}.{}-{}-{}.partial-", shard_file_name(shard), from.program, from.rtl,
                          from.specification)),
      share_(shard.share(cases)) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  const std::string own = fmt::format("{}{}-{}", prefix_, host_name(), ::getpid());
  for (int i = 0; file_ < 0; ++i) {
    partial_ = (fs::path(folder) / fmt::format("{}-{}", own, i)).string();
    file_ = ::open(partial_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0666);
    if (file_ < 0 && errno != EEXIST) fail("cannot write");
  }
  take_over(shard);
}

ShardWriter::~ShardWriter() {
  if (file_ >= 0) ::close(file_);
}

void ShardWriter::take_over(const Shard& shard) {
  Whole best;
  std::string text;
  for (const auto& entry : fs::directory_iterator(folder_)) {
    const std::string path = entry.path().string();
    if (path == partial_ || !entry.path().filename().string().starts_with(prefix_)) continue;
    try {
      std::string other = read_file(path);
      const Whole whole = whole_records(other, shard);
      if (whole.records <= best.records) continue;
      best = whole;
      text = std::move(other);
    } catch (const Error&) {  // its process has just finished and removed it
    }
  }
  text.resize(best.bytes);
  write(text);
  records_ = resumed_ = std::min(best.records, share_);
  failed_ = best.failed;
}

void ShardWriter::add(const std::string& line, bool failed) {
  write(line);
  ++records_;
  failed_ += failed ? 1 : 0;
}

void ShardWriter::finish(Manifest manifest) {
  manifest.records = records_;
  manifest.failed = failed_;
  manifest.resumed = resumed_;
  manifest.crc = crc_;
  write(manifest.line());
  // On the disk before the name is: a node that fails may lose neither or both.
  if (::fsync(file_) != 0 && errno != EINVAL) fail("cannot write");
  if (::close(std::exchange(file_, -1)) != 0) fail("cannot write");
  if (std::rename(partial_.c_str(), path_.c_str()) != 0) {
    // Another process finished the same shard first and removed this file: the result is there.
    if (errno != ENOENT || !fs::exists(path_)) fail("cannot rename the finished file into place");
  }
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder_, ignored)) {
    if (entry.path().filename().string().starts_with(prefix_)) fs::remove(entry.path(), ignored);
  }
}

void ShardWriter::write(std::string_view bytes) {
  crc_ = crc32_of(bytes, crc_);
  while (!bytes.empty()) {
    const ssize_t done = ::write(file_, bytes.data(), bytes.size());
    if (done < 0 && errno != EINTR) fail("cannot write");
    if (done > 0) bytes.remove_prefix(static_cast<std::size_t>(done));
  }
}

void ShardWriter::fail(const char* what) const {
  throw Error(ErrorCode::kFileWrite, path_, fmt::format("{}: {}", what, std::strerror(errno)));
}

}  // namespace halfspace
