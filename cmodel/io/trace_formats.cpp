// SPDX-License-Identifier: Apache-2.0
#include "trace_formats.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "error.hpp"

namespace halfspace {
namespace {

using Packets = std::vector<TracePacket>;

// --- Chrome trace events ----------------------------------------------------------------------

class ChromeWriter {
 public:
  explicit ChromeWriter(const Config& config) {
    fmt::format_to(out(),
                   "{{\"displayTimeUnit\":\"ns\",\"otherData\":{{\"unit\":\"1 us is one clock\","
                   "\"levels\":{},\"samples\":{}}},\n\"traceEvents\":[\n"
                   "{{\"name\":\"process_name\",\"ph\":\"M\",\"pid\":1,\"tid\":0,"
                   "\"args\":{{\"name\":\"hs_rasterizer\"}}}}",
                   config.levels(), config.samples);
  }
  void track(const std::string& name) {
    ++track_;
    fmt::format_to(out(),
                   ",\n{{\"name\":\"thread_name\",\"ph\":\"M\",\"pid\":1,\"tid\":{0},"
                   "\"args\":{{\"name\":\"{1}\"}}}}"
                   ",\n{{\"name\":\"thread_sort_index\",\"ph\":\"M\",\"pid\":1,\"tid\":{0},"
                   "\"args\":{{\"sort_index\":{0}}}}}",
                   track_, name);
  }
  // In the track's register in clocks from .. to, both included.
  void slice(const std::string& name, std::uint64_t from, std::uint64_t to,
             const TracePacket& packet) {
    fmt::format_to(out(),
                   ",\n{{\"name\":\"{}\",\"ph\":\"X\",\"pid\":1,\"tid\":{},\"ts\":{},\"dur\":{},"
                   "\"args\":{{\"triangle\":{},\"x\":{},\"y\":{},\"covered\":{},\"waited\":{}}}}}",
                   name, track_, from, to - from + 1, packet.triangle, packet.x, packet.y,
                   packet.covered, to - from);
  }
  std::string finish() {
    text_ += "\n]}\n";
    return std::move(text_);
  }

 private:
  std::back_insert_iterator<std::string> out() { return std::back_inserter(text_); }
  std::string text_;
  int track_ = 0;
};

std::string place(const char* what, const TracePacket& packet) {
  return fmt::format("{} ({},{})", what, packet.x, packet.y);
}

// Each packet that entered a stage: what it became, or that it ended in the last register.
void chrome_stage(ChromeWriter& writer, const Packets& in, const Packets& out, bool tiles) {
  for (const TracePacket& packet : in) {
    const std::string name =
        tiles ? place("tile", packet) : fmt::format("triangle {}", packet.triangle);
    if (packet.count == 0) {
      writer.slice((tiles ? "empty " : "dropped ") + name, packet.ended, packet.ended, packet);
    } else {
      const TracePacket& left = out[packet.first];
      writer.slice(name, left.offered, left.clock, left);
    }
  }
}

// --- Kanata -------------------------------------------------------------------------------------

struct Operation {
  std::uint64_t start = 0;
  bool tile = false;
  std::size_t index = 0;  // in link 0, or in the link into coverage
};

struct Command {
  enum Kind : std::uint8_t { kBegin, kStart, kEnd, kRetire, kFlush };
  std::uint64_t clock = 0;
  std::uint32_t operation = 0;
  Kind kind = kBegin;
  bool waiting = false;    // lane 1
  std::int16_t stage = 0;  // -1: S; level of the pyramid
};

class KanataWriter {
 public:
  explicit KanataWriter(const TraceLog& log)
      : levels_(log.config().levels()), packets_(trace_packets(log)) {}

  std::string run() {
    list_operations();
    for (std::uint32_t id = 0; id < operations_.size(); ++id) {
      operation_ = id;
      const Operation& operation = operations_[id];
      if (operation.tile) {
        tile(operation.index);
      } else {
        triangle(packets_[0][operation.index]);
      }
    }
    // An operation's own commands keep their order, and operations theirs.
    std::stable_sort(commands_.begin(), commands_.end(),
                     [](const Command& a, const Command& b) { return a.clock < b.clock; });
    return text();
  }

 private:
  const Packets& leaves() const { return packets_[static_cast<std::size_t>(levels_)]; }

  // The packet at which a leaf's line of descent entered each level, the leaf's last.
  std::vector<const TracePacket*> descent(std::size_t leaf) const {
    std::vector<const TracePacket*> line(static_cast<std::size_t>(levels_));
    for (auto link = static_cast<std::size_t>(levels_); link >= 1; --link) {
      line[link - 1] = &packets_[link][leaf];
      leaf = packets_[link][leaf].parent;
    }
    return line;
  }
  std::size_t first_level() const { return levels_ > 1 ? 1 : 0; }

  void list_operations() {
    for (std::size_t i = 0; i < packets_[0].size(); ++i) {
      operations_.push_back({packets_[0][i].clock, false, i});
    }
    for (std::size_t i = 0; i < leaves().size(); ++i) {
      operations_.push_back({descent(i)[first_level()]->clock, true, i});
    }
    std::stable_sort(operations_.begin(), operations_.end(),
                     [](const Operation& a, const Operation& b) { return a.start < b.start; });
  }

  void add(std::uint64_t clock, Command::Kind kind, int stage = 0, bool waiting = false) {
    commands_.push_back({clock, operation_, kind, waiting, static_cast<std::int16_t>(stage)});
  }
  void wait(const TracePacket& packet, int stage) {
    if (packet.offered == packet.clock) return;
    add(packet.offered, Command::kStart, stage, true);
    add(packet.clock, Command::kEnd, stage, true);
  }

  void triangle(const TracePacket& packet) {
    add(packet.clock, Command::kBegin);
    add(packet.clock, Command::kStart, -1);
    const Packets& roots = packets_[1];
    if (packet.count != 0) wait(roots[packet.first], -1);
    add(packet.ended, Command::kEnd, -1);
    if (packet.count == 0) return add(packet.ended, Command::kFlush);
    if (levels_ == 1) return add(packet.ended, Command::kRetire);
    const TracePacket& root = roots[packet.first];
    add(root.clock, Command::kStart, 0);
    for (std::size_t k = root.first; k < root.first + root.count; ++k) wait(packets_[2][k], 0);
    add(root.ended, Command::kEnd, 0);
    add(root.ended, root.count == 0 ? Command::kFlush : Command::kRetire);
  }

  void tile(std::size_t index) {
    const std::vector<const TracePacket*> line = descent(index);
    const TracePacket& leaf = *line.back();
    add(line[first_level()]->clock, Command::kBegin);
    for (std::size_t level = 1; level + 1 < line.size(); ++level) {
      const int stage = static_cast<int>(level);
      add(line[level]->clock, Command::kStart, stage);
      wait(*line[level + 1], stage);
      add(line[level + 1]->clock, Command::kEnd, stage);
    }
    add(leaf.clock, Command::kStart, levels_ - 1);
    if (leaf.count != 0) wait(packets_.back()[leaf.first], levels_ - 1);
    add(leaf.ended, Command::kEnd, levels_ - 1);
    add(leaf.ended, leaf.count == 0 ? Command::kFlush : Command::kRetire);
  }

  std::string stage_name(const Command& command) const {
    if (command.waiting) return "wait";
    if (command.stage < 0) return "S";
    return command.stage + 1 == levels_ ? "C" : fmt::format("T{}", command.stage);
  }

  std::string label(const Operation& operation) const {
    if (!operation.tile) return fmt::format("triangle {}", packets_[0][operation.index].triangle);
    const TracePacket& leaf = leaves()[operation.index];
    const std::uint32_t covered = leaf.count == 0 ? 0 : packets_.back()[leaf.first].covered;
    return fmt::format("tile ({},{}) of triangle {}: {} samples", leaf.x, leaf.y, leaf.triangle,
                       covered);
  }

  std::string text() const {
    std::string out = "Kanata\t0004\nC=\t0\n";
    const auto to = std::back_inserter(out);
    std::uint64_t now = 0;
    std::uint64_t retired = 0;
    for (const Command& command : commands_) {
      if (command.clock != now) fmt::format_to(to, "C\t{}\n", command.clock - now);
      now = command.clock;
      const std::uint32_t id = command.operation;
      const Operation& operation = operations_[id];
      switch (command.kind) {
        case Command::kBegin:
          fmt::format_to(to, "I\t{0}\t{1}\t{2}\nL\t{0}\t0\t{3}\n", id, operation.index,
                         operation.tile ? 1 : 0, label(operation));
          break;
        case Command::kStart:
        case Command::kEnd:
          fmt::format_to(to, "{}\t{}\t{}\t{}\n", command.kind == Command::kStart ? 'S' : 'E', id,
                         command.waiting ? 1 : 0, stage_name(command));
          break;
        case Command::kRetire: fmt::format_to(to, "R\t{}\t{}\t0\n", id, retired++); break;
        case Command::kFlush: fmt::format_to(to, "R\t{}\t{}\t1\n", id, retired); break;
      }
    }
    return out;
  }

  int levels_;
  std::vector<Packets> packets_;
  std::vector<Operation> operations_;
  std::vector<Command> commands_;
  std::uint32_t operation_ = 0;
};

// A gzip file of one member, without name and time: equal text makes equal bytes.
std::string compress(const std::string& text) {
  z_stream stream{};
  constexpr int kGzip = 15 + 16;
  if (deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, kGzip, 8, Z_DEFAULT_STRATEGY) !=
      Z_OK) {
    throw Error(ErrorCode::kInternal, "zlib", "cannot start");
  }
  gz_header header{};  // time 0
  header.os = 255;     // unknown, the same everywhere
  deflateSetHeader(&stream, &header);
  std::string out;
  std::array<char, 1 << 16> buffer;
  std::size_t from = 0;
  int state = Z_OK;
  while (state != Z_STREAM_END) {
    if (stream.avail_in == 0) {
      const std::size_t piece = std::min<std::size_t>(text.size() - from, 1u << 30);
      stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data() + from));
      stream.avail_in = static_cast<uInt>(piece);
      from += piece;
    }
    stream.next_out = reinterpret_cast<Bytef*>(buffer.data());
    stream.avail_out = static_cast<uInt>(buffer.size());
    state = deflate(&stream, from == text.size() ? Z_FINISH : Z_NO_FLUSH);
    out.append(buffer.data(), buffer.size() - stream.avail_out);
  }
  deflateEnd(&stream);
  return out;
}

constexpr std::string_view kChrome = ".json";
constexpr std::string_view kKanata = ".kanata.gz";

}  // namespace

std::string chrome_trace(const TraceLog& log) {
  const std::vector<Packets> packets = trace_packets(log);
  ChromeWriter writer(log.config());
  writer.track("input");
  for (const TracePacket& packet : packets[0]) {
    writer.slice(fmt::format("triangle {}", packet.triangle), packet.offered, packet.clock, packet);
  }
  writer.track("triangle_setup");
  chrome_stage(writer, packets[0], packets[1], false);
  for (std::size_t level = 0; level + 3 < packets.size(); ++level) {
    writer.track(fmt::format("tile_traversal[{}]", level));
    for (const TracePacket& packet : packets[level + 2]) {
      writer.slice(place("node", packet), packet.offered, packet.clock, packet);
    }
    // These end in an earlier register than the one whose packets the track above shows.
    writer.track(fmt::format("tile_traversal[{}], without a live child", level));
    for (const TracePacket& packet : packets[level + 1]) {
      if (packet.count != 0) continue;
      writer.slice(place("node", packet), packet.ended, packet.ended, packet);
    }
  }
  writer.track("coverage");
  chrome_stage(writer, packets[packets.size() - 2], packets.back(), true);
  return writer.finish();
}

std::string kanata_trace(const TraceLog& log) { return KanataWriter(log).run(); }

bool is_trace_file(std::string_view path) {
  return path.ends_with(kChrome) || path.ends_with(kKanata);
}

std::string model_trace_path(const std::string& path) {
  const std::string_view extension = path.ends_with(kKanata) ? kKanata : kChrome;
  return path.substr(0, path.size() - extension.size()) + ".model" + std::string(extension);
}

void write_trace(OutputFile& file, const TraceLog& log) {
  file.write(file.path().ends_with(kKanata) ? compress(kanata_trace(log)) : chrome_trace(log));
}

}  // namespace halfspace
