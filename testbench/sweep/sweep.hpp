// SPDX-License-Identifier: Apache-2.0
//
// A sweep, shard by shard, and the merging of its shards.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cases.hpp"
#include "shard.hpp"

namespace halfspace {

struct SweepOutcome {
  std::string path;
  std::uint64_t records = 0;
  std::uint64_t failed = 0;
  std::string first_failure;  // "case N: TEXT", of this run; empty: none
  bool was_there = false;     // whole from an earlier run
};

// Makes the shard's file in `folder`, unless a whole one of the same program and specification is
// there; goes on where a killed run stopped. Throws Error.
SweepOutcome run_shard(const SweepSpecification& specification, const SweepCases& cases,
                       const std::string& folder, const Shard& shard);

// Builds the RTL of every configuration that a case has, into the cache; how many. Throws Error.
std::uint64_t build_rtl(const SweepCases& cases);

// The shards in a folder.
struct ShardFile {
  std::string path;
  Manifest manifest;
};
struct ShardFolder {
  std::vector<ShardFile> files;        // by shard
  std::uint64_t count = 0;             // shards there should be
  std::vector<std::uint64_t> missing;  // in order
};
// Every .jsonl file of the folder that ends in a manifest, but `except`, checked: bytes against the
// CRC-32, the cases that belong to it, in order. Throws Error(kShards): none, a broken one, two
// programs, specifications or numbers of shards, one shard twice.
ShardFolder read_shards(const std::string& folder, const std::string& except);

// The records of all cases in order; none of the shards is missing. Memory does not grow with them.
struct MergeOutcome {
  std::uint64_t records = 0;
  std::uint64_t failed = 0;
  std::uint32_t crc = 0;  // of the file
};
MergeOutcome merge_shards(const ShardFolder& shards, const std::string& out);

// "3,7,12-14"
std::string ranges_text(const std::vector<std::uint64_t>& numbers);

}  // namespace halfspace
