// SPDX-License-Identifier: Apache-2.0
#include "shard.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <map>

#include "io/error.hpp"
#include "io/fnv.hpp"
#include "io/output_file.hpp"
#include "io/source_tree.hpp"

namespace halfspace {
namespace {

namespace fs = std::filesystem;

constexpr int kVersion = 1;

std::optional<std::uint64_t> whole_number(std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc() || end != text.data() + text.size()) return {};
  return value;
}

Shard checked(const std::string& place, const std::string& text, std::string_view index,
              std::string_view count) {
  const std::optional<std::uint64_t> i = whole_number(index);
  const std::optional<std::uint64_t> n = whole_number(count);
  if (!i || !n) {
    throw Error(ErrorCode::kUsage, place, fmt::format("'{:.40}' is not I/N, two numbers", text));
  }
  if (*n < 1 || *n > kMostShards || *i >= *n) {
    throw Error(ErrorCode::kUsage, place,
                fmt::format("'{:.40}' is out of range (I/N, 0 <= I < N <= {})", text, kMostShards));
  }
  return {*i, *n};
}

std::optional<Shard> from_environment(const std::string& index, const std::string& count) {
  const char* i = std::getenv(index.c_str());
  const char* n = std::getenv(count.c_str());
  if (i == nullptr || n == nullptr) return {};
  return checked(index + "/" + count, std::string(i) + "/" + n, i, n);
}

std::string hex(std::uint64_t value) { return fmt::format("{:016x}", value); }

std::uint64_t hash_of_rtl() {
  const char* set = std::getenv("HALFSPACE_RTL");
  const fs::path rtl =
      set != nullptr && *set != 0 ? fs::path(set) : folder_with("rtl/rtl.f") / "rtl";
  std::map<std::string, fs::path> files;  // in the order of their names
  std::error_code failed;
  for (const auto& entry : fs::recursive_directory_iterator(rtl, failed)) {
    const std::string name = fs::relative(entry.path(), rtl, failed).string();
    if (entry.is_regular_file(failed)) files[name] = entry.path();
  }
  Fnv hash;
  for (const auto& [name, path] : files) hash.add(name), hash.add(read_file(path.string()));
  return hash.value();
}

}  // namespace

Shard parse_shard(const std::string& text) {
  if (text.empty()) {
    if (const auto shard = from_environment("TEST_SHARD_INDEX", "TEST_TOTAL_SHARDS")) {
      return *shard;
    }
    const auto shard = from_environment("SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_COUNT");
    return shard.value_or(Shard());
  }
  const std::size_t slash = std::min(text.find('/'), text.size());
  return checked("--shard", text, std::string_view(text).substr(0, slash),
                 std::string_view(text).substr(std::min(slash + 1, text.size())));
}

Provenance provenance_of(std::uint64_t specification_hash) {
  Fnv program;
  program.add(read_file("/proc/self/exe"));
  return {hex(program.value()), hex(hash_of_rtl()), hex(specification_hash)};
}

std::string Manifest::line() const {
  nlohmann::ordered_json json;
  json["manifest"] = kVersion;
  json["program"] = from.program;
  json["rtl"] = from.rtl;
  json["specification"] = from.specification;
  json["shard"] = shard.text();
  json["cases"] = cases;
  json["records"] = records;
  json["failed"] = failed;
  json["left_out"] = left_out;
  json["crc32"] = fmt::format("{:08x}", crc);
  json["run"] = {{"seconds", seconds}, {"resumed", resumed}};
  return json.dump() + "\n";
}

std::optional<Manifest> parse_manifest(const std::string& line) {
  const auto json = nlohmann::json::parse(line, nullptr, false);
  if (!json.is_object() || json.value("manifest", nlohmann::json()) != kVersion) return {};
  try {
    Manifest out;
    out.from = {json.at("program"), json.at("rtl"), json.at("specification")};
    out.shard = parse_shard(json.at("shard").get<std::string>());
    out.cases = json.at("cases");
    out.records = json.at("records");
    out.failed = json.at("failed");
    out.left_out = json.at("left_out");
    out.crc =
        static_cast<std::uint32_t>(std::stoul(json.at("crc32").get<std::string>(), nullptr, 16));
    out.seconds = json.at("run").at("seconds");
    out.resumed = json.at("run").at("resumed");
    return out;
  } catch (const std::exception&) {
    return {};
  }
}

std::string shard_file_name(const Shard& shard) {
  return fmt::format("shard-{:05}-of-{:05}.jsonl", shard.index, shard.count);
}

}  // namespace halfspace
