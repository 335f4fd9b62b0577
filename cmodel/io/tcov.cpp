// SPDX-License-Identifier: Apache-2.0
#include "tcov.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <charconv>
#include <numeric>
#include <string_view>

#include "../snap.hpp"
#include "error.hpp"
#include "fit_range.hpp"

namespace halfspace {
namespace {

// Coordinates are limited so that no later arithmetic can overflow: 2^20 px.
constexpr std::int64_t kTcovCoordinateMax = std::int64_t{1} << 28;

// White-space separated tokens with their line numbers.
class Tokens {
 public:
  Tokens(std::string path, std::string text) : path_(std::move(path)), text_(std::move(text)) {}

  std::string_view word(const char* what) {
    skip_space();
    const std::size_t start = at_;
    while (at_ < text_.size() && !is_space(text_[at_])) ++at_;
    if (start == at_) fail(std::string("file ends where ") + what + " was expected (truncated?)");
    return std::string_view(text_).substr(start, at_ - start);
  }

  std::int64_t number(const char* what, std::int64_t low, std::int64_t high, int base = 10) {
    const std::string_view token = word(what);
    std::int64_t value = 0;
    const auto [end, error] =
        std::from_chars(token.data(), token.data() + token.size(), value, base);
    if (error != std::errc() || end != token.data() + token.size()) {
      fail(fmt::format("{} is not a number: '{:.40}'", what, token));
    }
    if (value < low || value > high) {
      fail(fmt::format("{} = {} is out of range ({}..{})", what, value, low, high));
    }
    return value;
  }

  int integer(const char* what, int low, int high) {
    return static_cast<int>(number(what, low, high));
  }

  bool at_end() {
    skip_space();
    return at_ == text_.size();
  }

  [[noreturn]] void fail(const std::string& text) const {
    throw Error(ErrorCode::kTcovBroken, place(), text);
  }

  std::size_t bytes_left() const { return text_.size() - at_; }
  int line() const { return line_; }
  std::string place() const { return fmt::format("{}:{}", path_, line_); }

 private:
  static bool is_space(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r'; }
  void skip_space() {
    for (; at_ < text_.size() && is_space(text_[at_]); ++at_) line_ += text_[at_] == '\n' ? 1 : 0;
  }

  std::string path_;
  std::string text_;
  std::size_t at_ = 0;
  int line_ = 1;
};

// CRC-32 of `count` equal bytes that follow those whose CRC is `before`, in about log2(count)^2
// steps: the picture of a span need not be there.
std::uint32_t crc32_of_run(std::uint8_t value, std::uint64_t count, std::uint32_t before) {
  uLong run = ::crc32_z(0, &value, 1);  // of `length` such bytes
  uLong crc = before;
  for (std::uint64_t length = 1; count != 0; length *= 2, count /= 2) {
    if (count % 2 != 0) crc = ::crc32_combine(crc, run, static_cast<z_off_t>(length));
    run = ::crc32_combine(run, run, static_cast<z_off_t>(length));
  }
  return static_cast<std::uint32_t>(crc);
}

void read_hits(Tokens& tokens, TcovCase& tcov, int spans, bool keep) {
  const auto pixels = static_cast<std::size_t>(tcov.width) * static_cast<std::size_t>(tcov.height);
  if (keep) tcov.hits.resize(pixels);
  std::size_t at = 0;
  std::uint32_t crc = 0;
  for (int i = 0; i < spans; ++i) {
    const auto gap = static_cast<std::size_t>(tokens.number("span gap", 0, INT32_MAX));
    const auto length = static_cast<std::size_t>(tokens.number("span length", 0, INT32_MAX));
    const auto value = static_cast<std::uint8_t>(tokens.integer("span value", 0, 255));
    if (at + gap + length > pixels) tokens.fail("span goes beyond the frame");
    at += gap;
    if (keep) std::fill_n(tcov.hits.begin() + static_cast<std::ptrdiff_t>(at), length, value);
    at += length;
    crc = crc32_of_run(value, length, crc32_of_run(0, gap, crc));
  }
  if (spans > 0 && tcov.crc != 0 && tcov.crc != crc32_of_run(0, pixels - at, crc)) {
    tokens.fail(fmt::format("case {}: the picture does not fit its CRC (damaged)", tcov.id));
  }
}

[[noreturn]] void refuse_size(const TcovCase& tcov, int most, const std::string& place) {
  throw Error(ErrorCode::kSize, place,
              fmt::format("case {}: {}x{} is larger than the configuration's {} pixels", tcov.id,
                          tcov.width, tcov.height, most));
}

void require_room(const TcovCase& tcov, const TcovReading& reading, std::uint64_t& pixels_left,
                  const std::string& place) {
  if (tcov.width > reading.max_size || tcov.height > reading.max_size) {
    refuse_size(tcov, reading.max_size, place);
  }
  const auto pixels =
      static_cast<std::uint64_t>(tcov.width) * static_cast<std::uint64_t>(tcov.height);
  if (pixels > pixels_left) {
    throw Error(ErrorCode::kScene, place,
                fmt::format("case {}: the cases up to here have more than {} pixels: make several "
                            "files",
                            tcov.id, kTcovMaxPixels));
  }
  pixels_left -= pixels;
}

TcovCase read_case(Tokens& tokens, const TcovReading& reading, std::uint64_t& pixels_left) {
  if (tokens.word("'case'") != "case") tokens.fail("'case' expected");
  TcovCase tcov;
  tcov.line = tokens.line();
  tcov.id = tokens.integer("case id", INT32_MIN, INT32_MAX);
  tcov.tag = tokens.word("tag");
  tcov.width = tokens.integer("width", 1, kTcovMaxSize);
  tcov.height = tokens.integer("height", 1, kTcovMaxSize);
  require_room(tcov, reading, pixels_left, tokens.place());
  const int triangles = tokens.integer("triangle count", 0, INT32_MAX);
  const int spans = tokens.integer("span count", 0, INT32_MAX);
  tcov.crc = static_cast<std::uint32_t>(tokens.number("CRC", 0, UINT32_MAX, 16));
  tcov.sum = static_cast<std::uint64_t>(tokens.number("sum", 0, INT64_MAX));
  // A triangle takes at least 12 bytes and a span 6: a count the file cannot hold is damage.
  if (static_cast<std::size_t>(triangles) > tokens.bytes_left() / 11 ||
      static_cast<std::size_t>(spans) > tokens.bytes_left() / 5) {
    tokens.fail("more triangles or spans are announced than the file holds (truncated?)");
  }
  tcov.triangles.resize(static_cast<std::size_t>(triangles));
  for (auto& triangle : tcov.triangles) {
    for (std::int64_t& value : triangle) {
      value = tokens.number("coordinate", -kTcovCoordinateMax, kTcovCoordinateMax);
    }
  }
  read_hits(tokens, tcov, spans, reading.hits);
  return tcov;
}

void write_case(OutputFile& file, const TcovCase& tcov) {
  std::string spans;
  std::size_t count = 0;
  std::size_t done = 0;
  const std::vector<std::uint8_t>& hits = tcov.hits;
  for (std::size_t at = 0; at < hits.size();) {
    std::size_t end = at + 1;
    while (end < hits.size() && hits[end] == hits[at]) ++end;
    if (hits[at] != 0) {
      fmt::format_to(std::back_inserter(spans), "{} {} {}{}", at - done, end - at, hits[at],
                     ++count % 16 == 0 ? '\n' : ' ');
      done = end;
    }
    at = end;
  }
  const std::uint64_t sum = std::accumulate(hits.begin(), hits.end(), std::uint64_t{0});
  file.write(fmt::format("case {} {} {} {} {} {} {:08x} {}\n", tcov.id, tcov.tag, tcov.width,
                         tcov.height, tcov.triangles.size(), count, crc32_of(hits), sum));
  for (const auto& t : tcov.triangles) file.write(fmt::format("{}\n", fmt::join(t, " ")));
  file.write(spans);
  if (!spans.empty() && spans.back() != '\n') file.write("\n");
}

}  // namespace

std::vector<TcovCase> read_tcov(const std::string& path, const TcovReading& reading) {
  Tokens tokens(path, read_file(path));
  if (tokens.word("'TCOV'") != "TCOV") tokens.fail("not a TCOV file");
  if (tokens.word("version") != "1") tokens.fail("TCOV version 1 expected");
  const int count = tokens.integer("case count", 0, INT32_MAX);
  std::vector<TcovCase> cases;
  std::uint64_t pixels_left = reading.hits ? kTcovMaxPixels : ~std::uint64_t{0};
  for (int i = 0; i < count; ++i) cases.push_back(read_case(tokens, reading, pixels_left));
  if (!tokens.at_end()) tokens.fail("text after the last case");
  return cases;
}

void write_tcov(OutputFile& file, const std::vector<TcovCase>& cases) {
  file.write(fmt::format("TCOV 1 {}\n", cases.size()));
  for (const TcovCase& tcov : cases) write_case(file, tcov);
}

TcovTriangles tcov_triangles(const TcovCase& tcov, const Config& config, const std::string& place) {
  const std::string where = fmt::format("{}:{}", place, tcov.line);
  if (tcov.width > config.max_size() || tcov.height > config.max_size()) {
    refuse_size(tcov, config.max_size(), where);
  }
  TcovTriangles out;
  out.triangles.reserve(tcov.triangles.size());
  const int shift = kTcovFractionBits - config.subpixel_bits;
  for (const auto& source : tcov.triangles) {
    Triangle triangle;
    triangle.tag = static_cast<std::uint32_t>(out.triangles.size());
    std::array<std::int32_t, 6> snapped{};
    for (std::size_t i = 0; i < 6; ++i) {
      const std::int64_t value = shift >= 0 ? snap_shift(source[i], shift, config.snap)
                                            : source[i] * (std::int64_t{1} << -shift);
      out.resnapped += shift > 0 && value * (std::int64_t{1} << shift) != source[i] ? 1u : 0u;
      if (value < config.coordinate_min() || value > config.coordinate_max()) {
        throw Error(ErrorCode::kTcovRange, where,
                    fmt::format("case {} triangle {}: coordinate {} (1/256 px) is beyond the "
                                "configuration's range",
                                tcov.id, out.triangles.size(), source[i]));
      }
      snapped[i] = static_cast<std::int32_t>(value);
    }
    triangle.vertex = {
        {{snapped[0], snapped[1]}, {snapped[2], snapped[3]}, {snapped[4], snapped[5]}}};
    require_extent(triangle, triangle.tag, config, fmt::format("{}: case {}", where, tcov.id));
    out.triangles.push_back(triangle);
  }
  return out;
}

std::uint32_t crc32_of(const std::vector<std::uint8_t>& bytes, std::uint32_t before) {
  return static_cast<std::uint32_t>(::crc32_z(before, bytes.data(), bytes.size()));
}

std::uint32_t crc32_of(std::string_view bytes, std::uint32_t before) {
  const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
  return static_cast<std::uint32_t>(::crc32_z(before, data, bytes.size()));
}

}  // namespace halfspace
