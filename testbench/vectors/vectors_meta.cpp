// SPDX-License-Identifier: Apache-2.0
#include "vectors_meta.hpp"

#include <fmt/format.h>

#include <charconv>
#include <nlohmann/json.hpp>

#include "fixed.hpp"
#include "io/config_json.hpp"
#include "io/error.hpp"
#include "io/json_text.hpp"
#include "io/scan.hpp"
#include "packets_of.hpp"

namespace halfspace {
namespace {

// "NAME BITS" for each field, "s" after the bits of a signed one.
nlohmann::ordered_json layout_json(const VectorMeta& meta) {
  nlohmann::ordered_json json;
  for (const RecordKind kind : kRecordKindList) {
    nlohmann::ordered_json fields = nlohmann::ordered_json::array();
    for (const PortField& field : vector_layout(kind, meta)) {
      fields.push_back(fmt::format("{} {}{}", field.name, field.bits, field.is_signed ? "s" : ""));
    }
    json[std::string(kind_name(kind))] = fields;
  }
  return json;
}

[[noreturn]] void broken(const std::string& place, const std::string& text) {
  throw Error(ErrorCode::kVectorsBroken, place, text);
}

const nlohmann::json& need(const nlohmann::json& json, const char* key, const std::string& place) {
  if (!json.is_object() || !json.contains(key)) broken(place, fmt::format("has no '{}'", key));
  return json[key];
}

std::string need_text(const nlohmann::json& json, const char* key, const std::string& place) {
  const nlohmann::json& value = need(json, key, place);
  if (!value.is_string()) broken(place, fmt::format("'{}' is not a string", key));
  return value;
}

std::uint64_t need_count(const nlohmann::json& json, const char* key, const std::string& place) {
  const nlohmann::json& value = need(json, key, place);
  if (!value.is_number_unsigned()) broken(place, fmt::format("'{}' is not a whole number", key));
  return value;
}

}  // namespace

nlohmann::ordered_json vector_meta_json(const VectorSet& set) {
  const VectorMeta& meta = set.meta;
  const VectorCounts counts = count_records(set);
  nlohmann::ordered_json json;
  json["halfspace_vectors"] = kVectorVersion;
  json["program"] = meta.program;
  json["stage"] = stage_name(meta.stage);
  json["level"] = meta.level;
  json["config"] = config_json(meta.config);
  json["seed"] = meta.seed;
  json["source"] = {{"kind", meta.source},
                    {"name", meta.source_name},
                    {"crc32", fmt::format("{:08x}", meta.source_crc)}};
  json["counts"] = {{"runs", counts.runs}, {"inputs", counts.inputs}, {"outputs", counts.outputs}};
  json["layout"] = layout_json(meta);
  return json;
}

nlohmann::json parse_vector_json(std::string_view text, const std::string& place) {
  constexpr ErrorCode kBroken = ErrorCode::kVectorsBroken;
  return parse_json(text, place, {kBroken, kBroken, kBroken});
}

VectorHeader parse_vector_meta(const nlohmann::json& json, const std::string& place) {
  if (!json.is_object()) broken(place, "not a JSON object");
  const std::uint64_t version = need_count(json, "halfspace_vectors", place);
  if (version != kVectorVersion) {
    broken(place, fmt::format("version {}, this program reads {}", version, kVectorVersion));
  }
  VectorHeader header;
  VectorMeta& meta = header.meta;
  const std::string stage = need_text(json, "stage", place);
  const std::optional<VectorStage> known = find_stage(stage);
  if (!known) broken(place, fmt::format("no stage '{:.40}'", stage));
  meta.stage = *known;
  meta.program = need_text(json, "program", place);
  try {
    meta.config = parse_config(need(json, "config", place).dump(), place);
  } catch (const Error& error) {
    throw Error(ErrorCode::kVectorsBroken, "", error.what());
  }
  const std::uint64_t level = need_count(json, "level", place);
  const int levels = meta.stage == VectorStage::kTileTraversal ? meta.config.levels() - 1 : 1;
  if (level >= static_cast<std::uint64_t>(levels)) broken(place, "'level' is out of range");
  meta.level = static_cast<int>(level);
  meta.seed = need_count(json, "seed", place);
  const nlohmann::json& source = need(json, "source", place);
  meta.source = need_text(source, "kind", place);
  meta.source_name = need_text(source, "name", place);
  const std::string crc = need_text(source, "crc32", place);
  const auto parsed = std::from_chars(crc.data(), crc.data() + crc.size(), meta.source_crc, 16);
  if (parsed.ec != std::errc() || parsed.ptr != crc.data() + crc.size()) {
    broken(place, "'crc32' is not eight hexadecimal digits");
  }
  const nlohmann::json& counts = need(json, "counts", place);
  header.counts = {need_count(counts, "runs", place), need_count(counts, "inputs", place),
                   need_count(counts, "outputs", place)};
  if (nlohmann::json(layout_json(meta)) != need(json, "layout", place)) {
    broken(place, "the layout is not that of this program for this configuration");
  }
  return header;
}

VectorHeader parse_vector_meta(const std::string& text, const std::string& place) {
  return parse_vector_meta(parse_vector_json(text, place), place);
}

void require_vectors(const VectorSet& set, const VectorCounts& promised, const std::string& place) {
  const VectorCounts counts = count_records(set);
  if (counts.runs != promised.runs || counts.inputs != promised.inputs ||
      counts.outputs != promised.outputs) {
    broken(place, fmt::format("{} runs, {} inputs, {} outputs, but the header says {}, {}, {} "
                              "(truncated?)",
                              counts.runs, counts.inputs, counts.outputs, promised.runs,
                              promised.inputs, promised.outputs));
  }
  if (counts.inputs == 0 || counts.outputs == 0) {
    throw Error(ErrorCode::kVectorsEmpty, place, "no input or no output: nothing to compare");
  }
  if (set.records.front().kind != RecordKind::kRun) broken(place, "does not start with a run");
  const auto book =
      static_cast<std::ptrdiff_t>(bookkeeping_fields(RecordKind::kIn, set.meta.stage));
  RecordKind before = RecordKind::kRun;
  for (std::size_t i = 0; i < set.records.size(); ++i) {
    const VectorRecord& record = set.records[i];
    if (record.kind == RecordKind::kOut && before == RecordKind::kRun) {
      broken(place, fmt::format("record {}: an output before any input", i));
    }
    before = record.kind;
    std::string fault;
    if (record.kind == RecordKind::kRun) fault = run_fault(record.values, set.meta);
    if (record.kind == RecordKind::kIn) {
      fault = stimulus_fault(Values(record.values.begin() + book, record.values.end()), set.meta);
    }
    if (!fault.empty()) {
      throw Error(ErrorCode::kVectorInput, place, fmt::format("record {}: {}", i, fault));
    }
  }
}

std::int64_t parse_field(std::string_view text, const PortField& field, const std::string& place) {
  const bool hex = text.starts_with("0x");
  const std::string_view digits = hex ? text.substr(2) : text;
  const char* end = digits.data() + digits.size();
  bool good = false;
  std::int64_t value = 0;
  if (field.is_signed && !hex) {
    const auto parsed = std::from_chars(digits.data(), end, value);
    good = parsed.ec == std::errc() && parsed.ptr == end && fits(value, field.bits);
  } else if (!field.is_signed) {
    std::uint64_t unsigned_value = 0;
    const auto parsed = std::from_chars(digits.data(), end, unsigned_value, hex ? 16 : 10);
    good = parsed.ec == std::errc() && parsed.ptr == end &&
           (field.bits == 64 || unsigned_value >> field.bits == 0);
    value = static_cast<std::int64_t>(unsigned_value);
  }
  if (!good) {
    broken(place, fmt::format("{} = {} is not a{} number of {} bits", field.name, shown(text),
                              field.is_signed ? " signed" : "n unsigned", field.bits));
  }
  return value;
}

}  // namespace halfspace
