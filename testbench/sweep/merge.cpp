// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "io/error.hpp"
#include "io/output_file.hpp"
#include "io/tcov.hpp"
#include "line_reader.hpp"
#include "sweep.hpp"

namespace halfspace {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kCheckBuffer = 1 << 20;
constexpr std::size_t kMergeBuffers = 1 << 26;  // of all shards together

[[noreturn]] void refuse(const std::string& place, const std::string& text) {
  throw Error(ErrorCode::kShards, place, text);
}

// Reads the whole file: the manifest must fit what stands before it.
Manifest check_file(const std::string& path) {
  const std::optional<Manifest> manifest = parse_manifest(last_line(path));
  if (!manifest) refuse(path, "its last line is no manifest: the file is not whole");
  LineReader lines(path, kCheckBuffer);
  std::uint32_t crc = 0;
  std::string line;
  for (std::uint64_t r = 0; r < manifest->records; ++r) {
    const std::uint64_t number = manifest->shard.index + r * manifest->shard.count;
    if (!lines.next(line) || !line.starts_with(fmt::format("{{\"case\":{},", number))) {
      refuse(path, fmt::format("record {} is not case {}", r, number));
    }
    crc = crc32_of(line, crc);
  }
  if (crc != manifest->crc) refuse(path, "the CRC-32 is not that of the records");
  if (!lines.next(line) || !parse_manifest(line) ||
      manifest->records != manifest->shard.share(manifest->cases)) {
    refuse(path, fmt::format("{} records are not those of shard {} of {} cases", manifest->records,
                             manifest->shard.text(), manifest->cases));
  }
  return *manifest;
}

// The shards must be parts of one sweep: two that are not are named.
void require_same(const ShardFile& one, const ShardFile& other) {
  const std::string place = other.path;
  const auto differs = [&](const char* what, const std::string& a, const std::string& b) {
    if (a != b) refuse(place, fmt::format("{} {}, but {} has {}", what, b, one.path, a));
  };
  differs("made by program", one.manifest.from.program, other.manifest.from.program);
  differs("made with RTL", one.manifest.from.rtl, other.manifest.from.rtl);
  differs("of specification", one.manifest.from.specification, other.manifest.from.specification);
  differs("one of shards", std::to_string(one.manifest.shard.count),
          std::to_string(other.manifest.shard.count));
}

bool is_shard(const fs::directory_entry& entry, const fs::path& except) {
  std::error_code failed;
  const std::string name = entry.path().filename().string();
  if (!name.ends_with(".jsonl") || !entry.is_regular_file(failed)) return false;
  if (!except.empty() && fs::weakly_canonical(entry.path(), failed) == except) return false;
  return name.starts_with("shard-") || parse_manifest(last_line(entry.path().string()));
}

// N of "shard-I-of-N...", whole or not; 0 when the name is another.
std::uint64_t count_in_name(const std::string& name) {
  unsigned long long index = 0, count = 0;
  return std::sscanf(name.c_str(), "shard-%llu-of-%llu.jsonl", &index, &count) == 2 ? count : 0;
}

}  // namespace

ShardFolder read_shards(const std::string& folder, const std::string& except) {
  std::error_code failed;
  if (!fs::is_directory(folder, failed)) refuse(folder, "not a folder: no shards to merge");
  const fs::path skipped = except.empty() ? fs::path() : fs::weakly_canonical(except, failed);
  ShardFolder out;
  std::vector<std::string> paths;
  for (const auto& entry : fs::directory_iterator(folder)) {
    out.count = std::max(out.count, count_in_name(entry.path().filename().string()));
    if (is_shard(entry, skipped)) paths.push_back(entry.path().string());
  }
  std::sort(paths.begin(), paths.end());
  if (out.count == 0 && paths.empty()) refuse(folder, "no shards to merge");
  for (const std::string& path : paths) {
    out.files.push_back({path, check_file(path)});
    require_same(out.files.front(), out.files.back());
  }
  std::sort(out.files.begin(), out.files.end(), [](const ShardFile& a, const ShardFile& b) {
    return a.manifest.shard.index < b.manifest.shard.index;
  });
  if (!out.files.empty()) out.count = out.files.front().manifest.shard.count;
  auto file = out.files.begin();
  for (std::uint64_t i = 0; i < out.count; ++i) {
    if (file == out.files.end() || file->manifest.shard.index != i) {
      out.missing.push_back(i);
      continue;
    }
    const ShardFile& first = *file++;
    if (file != out.files.end() && file->manifest.shard.index == i) {
      refuse(file->path, fmt::format("shard {} is there twice: {} holds it too",
                                     first.manifest.shard.text(), first.path));
    }
  }
  return out;
}

MergeOutcome merge_shards(const ShardFolder& shards, const std::string& out) {
  MergeOutcome result;
  OutputFile file(out);
  const std::size_t buffer = std::clamp<std::size_t>(kMergeBuffers / shards.count, 4096, 1 << 20);
  std::vector<LineReader> readers;
  for (const ShardFile& shard : shards.files) {
    readers.emplace_back(shard.path, buffer);
    result.failed += shard.manifest.failed;
  }
  const std::uint64_t cases = shards.files.front().manifest.cases;
  std::string line;
  for (; result.records < cases; ++result.records) {
    const std::size_t owner = result.records % shards.count;
    if (!readers[owner].next(line)) refuse(shards.files[owner].path, "changed while it was read");
    result.crc = crc32_of(line, result.crc);
    file.write(line);
  }
  file.commit();
  return result;
}

std::string ranges_text(const std::vector<std::uint64_t>& numbers) {
  std::string out;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t end = i + 1;
    while (end < numbers.size() && numbers[end] == numbers[end - 1] + 1) ++end;
    if (!out.empty()) out += ',';
    out += std::to_string(numbers[i]);
    if (end - i > 1) out += fmt::format("-{}", numbers[end - 1]);
    i = end;
  }
  return out;
}

}  // namespace halfspace
