// SPDX-License-Identifier: Apache-2.0
//
// The part of a sweep that one process makes, and its file: a record a line, then a manifest. Case
// k belongs to shard k mod N. docs/02_use/many_machines.md.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace halfspace {

// Which of how many.
struct Shard {
  std::uint64_t index = 0;
  std::uint64_t count = 1;

  std::string text() const { return std::to_string(index) + "/" + std::to_string(count); }
  // Of so many cases, how many are the shard's.
  std::uint64_t share(std::uint64_t cases) const {
    return cases > index ? (cases - index + count - 1) / count : 0;
  }
};

inline constexpr std::uint64_t kMostShards = 1'000'000;

// "I/N", I counted from 0. Empty: what TEST_SHARD_INDEX and TEST_TOTAL_SHARDS say, else
// SLURM_ARRAY_TASK_ID and SLURM_ARRAY_TASK_COUNT, else 0/1. Throws Error(kUsage).
Shard parse_shard(const std::string& text);

// Who made a file, and of what: files that differ here do not belong together.
struct Provenance {
  std::string program;        // hashes, 16 hex digits: the program's file,
  std::string rtl;            // the RTL it builds,
  std::string specification;  // the specification and the scenes it names
  bool operator==(const Provenance&) const = default;
};
// That of this program. Throws Error(kFileRead).
Provenance provenance_of(std::uint64_t specification_hash);

// The last line of a shard's file.
struct Manifest {
  Provenance from;
  Shard shard;
  std::uint64_t cases = 0;     // of the whole sweep
  std::uint64_t records = 0;   // in this file
  std::uint64_t failed = 0;    // of those
  std::uint64_t left_out = 0;  // combinations of the specification that no case has
  std::uint32_t crc = 0;       // CRC-32 of all bytes before the manifest
  // What differs from run to run; comparison leaves it out.
  double seconds = 0;
  std::uint64_t resumed = 0;  // records that a run before this one made

  std::string line() const;  // with its newline
};
// Nothing when the line is no manifest of a version that this program reads.
std::optional<Manifest> parse_manifest(const std::string& line);

// "shard-00003-of-00016.jsonl"
std::string shard_file_name(const Shard& shard);

// A case that did not go well: its record has `error`, or the RTL differs.
template <class Json>
bool record_failed(const Json& record) {
  if (record.contains("error")) return true;
  const auto rtl = record.find("rtl");
  return rtl != record.end() && rtl->is_object() && !rtl->value("identical", true);
}

// Writes a shard's file: beside its destination, each record as soon as it is made, renamed when
// whole. What a killed run left is taken over, up to its last whole record; nobody waits for
// anybody, and two processes at the same shard both end well.
class ShardWriter {
 public:
  // Throws Error(kFileWrite).
  ShardWriter(const std::string& folder, const Shard& shard, const Provenance& from,
              std::uint64_t cases);
  ~ShardWriter();
  ShardWriter(const ShardWriter&) = delete;
  ShardWriter& operator=(const ShardWriter&) = delete;

  std::uint64_t resumed() const { return resumed_; }
  std::uint64_t records() const { return records_; }
  std::uint64_t failed() const { return failed_; }
  // When it returns, the record outlives the process.
  void add(const std::string& line, bool failed);
  void finish(Manifest manifest);

 private:
  void take_over(const Shard& shard);
  void write(std::string_view bytes);
  [[noreturn]] void fail(const char* what) const;

  std::string folder_;
  std::string path_;
  std::string prefix_;  // of the names of unfinished files of the same shard and provenance
  std::string partial_;
  int file_ = -1;
  std::uint64_t share_;
  std::uint64_t records_ = 0;
  std::uint64_t failed_ = 0;
  std::uint64_t resumed_ = 0;
  std::uint32_t crc_ = 0;
};

}  // namespace halfspace
