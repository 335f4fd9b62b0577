// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "io/error.hpp"
#include "vectors_format.hpp"
#include "vectors_meta.hpp"

namespace halfspace {
namespace {

RecordKind parse_kind(std::string_view text, const std::string& place) {
  for (const RecordKind kind : kRecordKindList) {
    if (text == kind_name(kind)) return kind;
  }
  throw Error(ErrorCode::kVectorsBroken, place, "a record is neither run, in nor out");
}

// The lines of a text, one after the other, with their place for messages.
class Lines {
 public:
  Lines(const std::string& bytes, const std::string& file) : rest_(bytes), file_(file) {}

  bool next() {
    if (rest_.empty()) return false;
    const std::size_t end = rest_.find('\n');
    ++number_;
    if (end == std::string_view::npos) {
      throw Error(ErrorCode::kVectorsBroken, place(), "the last line does not end (truncated?)");
    }
    line_ = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    return true;
  }
  std::string_view line() const { return line_; }
  // An empty file has no line.
  std::string place() const { return number_ == 0 ? file_ : fmt::format("{}:{}", file_, number_); }
  [[noreturn]] void broken(const char* text) const {
    throw Error(ErrorCode::kVectorsBroken, place(), text);
  }

 private:
  std::string_view rest_;
  std::string_view line_;
  std::string file_;
  std::size_t number_ = 0;
};

// "kind,run.inputs,...,in.outputs,...,out.x,...": a column for each field of each kind.
std::string csv_columns(const VectorLayouts& all) {
  std::string line = "kind";
  for (const RecordKind kind : kRecordKindList) {
    for (const PortField& field : all[kind]) {
      line += fmt::format(",{}.{}", kind_name(kind), field.name);
    }
  }
  return line;
}

// The cells of a record's own kind. Those of the other kinds must be empty.
Values csv_values(const std::vector<std::string_view>& cells, RecordKind kind,
                  const VectorLayouts& all, const Lines& lines) {
  Values values;
  std::size_t at = 1;
  for (const RecordKind other : kRecordKindList) {
    for (const PortField& field : all[other]) {
      const std::string_view cell = cells[at++];
      if (other == kind) {
        values.push_back(parse_field(cell, field, lines.place()));
      } else if (!cell.empty()) {
        lines.broken("a cell of another kind of record is not empty");
      }
    }
  }
  return values;
}

}  // namespace

std::string vectors_to_csv(const VectorSet& set) {
  const VectorLayouts all(set.meta);
  std::string out = "# " + vector_meta_json(set).dump() + "\n" + csv_columns(all) + "\n";
  for (const VectorRecord& record : set.records) {
    out += kind_name(record.kind);
    for (const RecordKind kind : kRecordKindList) {
      const Layout& layout = all[kind];
      if (kind != record.kind) {
        out.append(layout.size(), ',');
        continue;
      }
      for (std::size_t i = 0; i < layout.size(); ++i) {
        out += ',';
        out += field_text(record.values[i], layout[i]);
      }
    }
    out += '\n';
  }
  return out;
}

VectorSet vectors_from_csv(const std::string& bytes, const std::string& place) {
  Lines lines(bytes, place);
  if (!lines.next() || !lines.line().starts_with("# {")) {
    lines.broken("does not start with '# ' and a JSON object");
  }
  const VectorHeader header = parse_vector_meta(std::string(lines.line().substr(2)), lines.place());
  VectorSet set{header.meta, {}};
  const VectorLayouts all(set.meta);
  std::size_t columns = 1;
  for (const RecordKind kind : kRecordKindList) columns += all[kind].size();
  if (!lines.next() || lines.line() != csv_columns(all)) {
    lines.broken("the columns are not those of the layout");
  }
  while (lines.next()) {
    std::vector<std::string_view> cells;
    std::string_view rest = lines.line();
    for (std::size_t comma = 0; comma != std::string_view::npos;) {
      comma = rest.find(',');
      cells.push_back(rest.substr(0, comma));
      if (comma != std::string_view::npos) rest.remove_prefix(comma + 1);
    }
    const RecordKind kind = parse_kind(cells[0], lines.place());
    if (cells.size() != columns) lines.broken("wrong number of cells");
    set.records.push_back({kind, csv_values(cells, kind, all, lines)});
  }
  require_vectors(set, header.counts, place);
  return set;
}

std::string vectors_to_json_lines(const VectorSet& set) {
  const VectorLayouts all(set.meta);
  std::string out = vector_meta_json(set).dump() + "\n";
  for (const VectorRecord& record : set.records) {
    out += fmt::format("{{\"kind\":\"{}\"", kind_name(record.kind));
    const Layout& layout = all[record.kind];
    for (std::size_t i = 0; i < layout.size(); ++i) {
      const std::string value = field_text(record.values[i], layout[i]);
      out += is_lanes(layout[i]) ? fmt::format(",\"{}\":\"{}\"", layout[i].name, value)
                                 : fmt::format(",\"{}\":{}", layout[i].name, value);
    }
    out += "}\n";
  }
  return out;
}

VectorSet vectors_from_json_lines(const std::string& bytes, const std::string& place) {
  Lines lines(bytes, place);
  if (!lines.next()) lines.broken("is empty");
  const VectorHeader header = parse_vector_meta(std::string(lines.line()), lines.place());
  VectorSet set{header.meta, {}};
  const VectorLayouts all(set.meta);
  while (lines.next()) {
    const nlohmann::json json = parse_vector_json(lines.line(), lines.place());
    if (!json.is_object() || !json.contains("kind") || !json["kind"].is_string()) {
      lines.broken("not a JSON object with a kind");
    }
    const RecordKind kind = parse_kind(json["kind"].get<std::string>(), lines.place());
    const Layout& layout = all[kind];
    if (json.size() != layout.size() + 1) lines.broken("wrong number of fields");
    Values values;
    for (const PortField& field : layout) {
      const auto found = json.find(field.name);
      if (found == json.end()) {
        throw Error(ErrorCode::kVectorsBroken, lines.place(), "has no field " + field.name);
      }
      values.push_back(parse_field(found->is_string() ? found->get<std::string>() : found->dump(),
                                   field, lines.place()));
    }
    set.records.push_back({kind, values});
  }
  require_vectors(set, header.counts, place);
  return set;
}

}  // namespace halfspace
