// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "io/error.hpp"
#include "io/tcov.hpp"
#include "stalls.hpp"
#include "vectors_format.hpp"
#include "vectors_meta.hpp"

namespace halfspace {
namespace {

constexpr std::string_view kMagic{"HSVECT\r\n", 8};
constexpr std::size_t kPrefix = 16;  // magic, version, CRC-32
// Clocks of the ready pattern of a stage whose clocks are not predicted.
constexpr std::size_t kPatternClocks = 4096;

[[noreturn]] void broken(const std::string& place, const std::string& text) {
  throw Error(ErrorCode::kVectorsBroken, place, text);
}

void put_bytes(std::string& out, std::uint64_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) out += static_cast<char>(value >> (8 * i) & 255u);
}

// Takes bytes from the front; throws when there are none.
class ByteReader {
 public:
  ByteReader(std::string_view bytes, const std::string& place) : rest_(bytes), place_(place) {}
  std::string_view take(std::size_t count) {
    if (count > rest_.size()) broken(place_, "the file ends too early (truncated?)");
    const std::string_view bytes = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return bytes;
  }
  std::uint64_t number(std::size_t bytes) {
    std::uint64_t value = 0;
    const std::string_view from = take(bytes);
    for (std::size_t i = 0; i < bytes; ++i) {
      value |= std::uint64_t{static_cast<std::uint8_t>(from[i])} << (8 * i);
    }
    return value;
  }
  bool done() const { return rest_.empty(); }

 private:
  std::string_view rest_;
  std::string place_;
};

// Whether the padding above a packed word's bits is zero.
bool padded(const PortWords& words, int bits) {
  return bits % 32 == 0 || words.back() >> (bits % 32) == 0;
}

std::string hex_line(const PortWords& words, int bits) {
  std::string line;
  for (int digit = (bits + 3) / 4; digit-- > 0;) {
    line += "0123456789abcdef"[words[static_cast<std::size_t>(digit / 8)] >> (digit % 8 * 4) & 15u];
  }
  return line + "\n";
}

// One word of `bits` bits from the front of a file.
PortWords hex_word(std::string_view& rest, int bits, const std::string& place) {
  const auto digits = static_cast<std::size_t>((bits + 3) / 4);
  if (rest.size() < digits + 1 || rest[digits] != '\n') {
    broken(place, fmt::format("a word has not {} digits (truncated?)", digits));
  }
  PortWords words(static_cast<std::size_t>((bits + 31) / 32));
  for (std::size_t i = 0; i < digits; ++i) {
    const std::size_t value = std::string_view("0123456789abcdef").find(rest[digits - 1 - i]);
    if (value == std::string_view::npos) broken(place, "a digit is not hexadecimal");
    words[i / 8] |= static_cast<std::uint32_t>(value) << (i % 8 * 4);
  }
  if (!padded(words, bits)) broken(place, "a word is too wide");
  rest.remove_prefix(digits + 1);
  return words;
}

Stalls stalls_of(const Values& run) {
  return run[kRunStall] == 0 ? Stalls() : Stalls(stall_probability(run), stall_seed(run));
}

std::uint64_t all_ready_words(const VectorSet& set) {
  std::uint64_t words = 0;
  for (const VectorRecord& record : set.records) {
    if (record.kind == RecordKind::kRun) words += ready_words(record.values);
  }
  return words;
}

// Clocks are a file's word: their pattern must not take memory before it is known to be theirs.
constexpr std::uint64_t kMostReadyWords = std::uint64_t{1} << 25;

std::string ready_lines(const VectorSet& set) {
  if (all_ready_words(set) > kMostReadyWords) {
    throw Error(ErrorCode::kVectorsSize, "", "more than 2^30 clocks of stalls");
  }
  std::string out;
  for (const VectorRecord& record : set.records) {
    if (record.kind != RecordKind::kRun) continue;
    const Stalls stalls = stalls_of(record.values);
    for (std::size_t word = 0; word < ready_words(record.values); ++word) {
      std::uint32_t bits = 0;
      for (std::size_t i = 0; i < 32; ++i) {
        bits |= static_cast<std::uint32_t>(stalls.ready(32 * word + i)) << i;
      }
      out += hex_line({bits}, 32);
    }
  }
  return out.empty() ? "ffffffff\n" : out;
}

}  // namespace

std::size_t ready_words(const Values& run) {
  if (run[kRunStall] == 0) return 0;
  const auto clocks = static_cast<std::size_t>(run[kRunClocks]);
  return ((clocks == 0 ? kPatternClocks : clocks) + 31) / 32;
}

std::string vectors_to_binary(const VectorSet& set) {
  const std::string json = vector_meta_json(set).dump();
  std::string body;
  put_bytes(body, json.size(), 4);
  body += json;
  put_bytes(body, set.records.size(), 8);
  const VectorLayouts all(set.meta);
  for (const VectorRecord& record : set.records) {
    const Layout& fields = all[record.kind];
    body += static_cast<char>(record.kind);
    const PortWords words = pack(record.values, fields);
    const auto bytes = static_cast<std::size_t>((layout_bits(fields) + 7) / 8);
    for (std::size_t i = 0; i < bytes; ++i) {
      body += static_cast<char>(words[i / 4] >> (8 * (i % 4)) & 255u);
    }
  }
  std::string out(kMagic);
  put_bytes(out, kVectorVersion, 4);
  put_bytes(out, crc32_of(body), 4);
  return out + body;
}

VectorSet vectors_from_binary(const std::string& bytes, const std::string& place) {
  ByteReader reader(bytes, place);
  if (reader.take(kMagic.size()) != kMagic) broken(place, "not a file of vectors (magic)");
  const std::uint64_t version = reader.number(4);
  if (version != kVectorVersion) {
    broken(place, fmt::format("version {}, this program reads {}", version, kVectorVersion));
  }
  if (reader.number(4) != crc32_of(std::string_view(bytes).substr(kPrefix))) {
    broken(place, "the CRC-32 is not that of the bytes");
  }
  const std::string json(reader.take(reader.number(4)));
  const VectorHeader header = parse_vector_meta(json, place);
  VectorSet set{header.meta, {}};
  const std::uint64_t count = reader.number(8);
  const VectorLayouts all(set.meta);
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::uint64_t kind = reader.number(1);
    if (kind >= kRecordKinds) broken(place, fmt::format("record {}: kind {}", i, kind));
    const Layout& layout = all[static_cast<RecordKind>(kind)];
    const int bits = layout_bits(layout);
    PortWords words(static_cast<std::size_t>((bits + 31) / 32));
    for (std::size_t byte = 0; byte < static_cast<std::size_t>((bits + 7) / 8); ++byte) {
      words[byte / 4] |= static_cast<std::uint32_t>(reader.number(1)) << (8 * (byte % 4));
    }
    if (!padded(words, bits)) broken(place, fmt::format("record {}: padding is not zero", i));
    set.records.push_back({static_cast<RecordKind>(kind), unpack(words, layout)});
  }
  if (!reader.done()) broken(place, "bytes follow the last record");
  require_vectors(set, header.counts, place);
  return set;
}

HexFiles vectors_to_hex(const VectorSet& set) {
  HexFiles files;
  const VectorLayouts all(set.meta);
  const std::array<std::string*, kRecordKinds> to{&files.run, &files.in, &files.out};
  for (const VectorRecord& record : set.records) {
    const Layout& layout = all[record.kind];
    *to[static_cast<std::size_t>(record.kind)] +=
        hex_line(pack(record.values, layout), layout_bits(layout));
  }
  files.ready = ready_lines(set);
  return files;
}

VectorSet vectors_from_hex(const HexFiles& files, const std::string& manifest,
                           const std::string& place) {
  const VectorHeader header = parse_vector_meta(manifest, place);
  VectorSet set{header.meta, {}};
  std::array<std::string_view, kRecordKinds> rest{files.run, files.in, files.out};
  const VectorLayouts all(set.meta);
  const auto take = [&](RecordKind kind) -> const Values& {
    const Layout& layout = all[kind];
    std::string_view& from = rest[static_cast<std::size_t>(kind)];
    const std::string where = fmt::format("{} ({})", place, kind_name(kind));
    if (from.empty()) broken(where, "the file ends too early (truncated?)");
    set.records.push_back({kind, unpack(hex_word(from, layout_bits(layout), where), layout)});
    return set.records.back().values;
  };
  while (!rest[0].empty()) {
    const std::int64_t inputs = take(RecordKind::kRun)[kRunInputs];
    for (std::int64_t i = 0; i < inputs; ++i) {
      const std::int64_t outputs = take(RecordKind::kIn)[kInOutputs];
      for (std::int64_t o = 0; o < outputs; ++o) take(RecordKind::kOut);
    }
  }
  if (!rest[1].empty() || !rest[2].empty()) broken(place, "words follow the last run's");
  // Its size first: it is short, whatever clocks the runs claim.
  constexpr std::size_t kWordBytes = 9;  // eight digits and the line's end
  if (files.ready.size() != kWordBytes * std::max<std::uint64_t>(all_ready_words(set), 1) ||
      files.ready != ready_lines(set)) {
    broken(place, "the ready pattern is not that of the runs");
  }
  require_vectors(set, header.counts, place);
  return set;
}

}  // namespace halfspace
