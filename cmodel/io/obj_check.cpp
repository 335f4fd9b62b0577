// SPDX-License-Identifier: Apache-2.0
#include "obj_check.hpp"

#include <array>
#include <charconv>
#include <cstdint>
#include <vector>

#include "error.hpp"
#include "scan.hpp"

namespace halfspace {
namespace {

struct ObjVertex {
  std::array<double, 6> number{0, 0, 0, 1, 1, 1};  // x y z r g b
};

// A positive index that was not yet defined where it was used.
struct ForwardReference {
  std::int64_t index;
  std::size_t line;
};

void append_number(std::string& text, double value) {
  std::array<char, 32> buffer;
  const auto [end, error] =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), static_cast<float>(value));
  text += ' ';
  text.append(buffer.data(), end);
}

class ObjChecker {
 public:
  ObjChecker(const std::string& path, std::string_view text) : path_(path), rest_(text) {}

  PlainObj run() {
    if (const std::size_t nul = rest_.find('\0'); nul != std::string_view::npos) {
      throw Error(ErrorCode::kMeshBroken, path_,
                  "byte " + std::to_string(nul) + " is zero: this is not OBJ text");
    }
    const bool ends_with_line = rest_.empty() || rest_.back() == '\n' || rest_.back() == '\r';
    std::string line;
    while (take_line(line)) {
      // What is wrong with the last line of a file that just stops is that the file stops.
      cut_short_ = rest_.empty() && !ends_with_line;
      check_line(line);
    }
    finish(ends_with_line);
    return compose();
  }

 private:
  [[noreturn]] void fail(ErrorCode code, const std::string& text, std::size_t line) const {
    throw Error(code, path_ + ":" + std::to_string(line), text);
  }
  [[noreturn]] void broken(const std::string& text) const {
    fail(ErrorCode::kMeshBroken,
         cut_short_ ? "the file ends in the middle of a line (" + text + ")" : text, line_);
  }

  // One logical line, continuations joined; line_ is the number of its first physical line.
  bool take_line(std::string& line) {
    line.clear();
    if (rest_.empty()) return false;
    line_ = next_line_;
    for (bool more = true; more && !rest_.empty();) {
      const std::size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
      line.append(rest_.substr(0, end));
      const bool crlf = rest_.substr(end, 2) == "\r\n";
      rest_.remove_prefix(std::min(rest_.size(), end + (crlf ? 2 : 1)));
      ++next_line_;
      more = !line.empty() && line.back() == '\\';
      if (more) line.back() = ' ';
    }
    return true;
  }

  void check_line(std::string_view line) {
    const std::string_view whole = line;
    const std::string_view keyword = next_token(line);
    if (keyword == "v") {
      check_vertex(line);
    } else if (keyword == "vn") {
      check_normal(line);
    } else if (keyword == "vt") {
      for (int i = 0; i < 1 || !line.empty(); ++i) {
        const std::string_view token = next_token(line);
        if (token.empty() && i > 0) break;
        number(token);
      }
      ++texture_coordinates_;
    } else if (keyword == "f" || keyword == "fo") {  // fo: an obsolete spelling
      check_face(line);
    } else if (keyword == "usemtl" || keyword == "mtllib") {
      body_.append(whole).push_back('\n');
    }
  }

  double number(std::string_view token) const {
    if (token.empty()) broken("a number is missing");
    const std::optional<double> value = parse_number(token);
    if (!value) broken(shown(token) + " is not a number");
    if (!is_finite_float(*value)) {
      fail(ErrorCode::kMeshNotFinite, shown(token) + " is not a finite single-precision number",
           line_);
    }
    return *value;
  }

  void check_vertex(std::string_view line) {
    std::array<double, 8> value{};
    std::size_t count = 0;
    for (std::string_view token = next_token(line); !token.empty() && token[0] != '#';
         token = next_token(line)) {
      if (count == value.size()) broken("a vertex has at most 7 numbers");
      value[count++] = number(token);
    }
    if (count < 3) broken("a vertex needs 3 numbers, here are " + std::to_string(count));
    if (count == 5) broken("a vertex has 3, 4, 6 or 7 numbers, here are 5");
    ObjVertex& vertex = vertices_.emplace_back();
    const bool coloured = count >= 6;
    for (std::size_t i = 0; i < (coloured ? 6U : 3U); ++i) vertex.number[i] = value[i];
    has_colours_ = has_colours_ || coloured;
  }

  void check_normal(std::string_view line) {
    body_ += "vn";
    for (int i = 0; i < 3; ++i) append_number(body_, number(next_token(line)));
    body_ += '\n';
    ++normals_;
  }

  // One index of a reference, made absolute; `defined` so far. Checked at the end of the file when
  // it points forward.
  std::int64_t index(std::string_view token, std::int64_t defined, const char* what,
                     std::vector<ForwardReference>& forward) const {
    const std::optional<std::int64_t> value = parse_integer(token);
    if (!value) broken(shown(token) + " is not an index");
    if (*value == 0) fail(ErrorCode::kMeshIndex, "index 0: OBJ counts from 1", line_);
    if (*value < -defined) {
      fail(ErrorCode::kMeshIndex,
           "index " + std::to_string(*value) + ", but only " + std::to_string(defined) + " " +
               what + " stand before this line",
           line_);
    }
    if (*value > defined) forward.push_back({*value, line_});
    return *value < 0 ? defined + *value + 1 : *value;
  }

  void check_face(std::string_view line) {
    std::size_t corners = 0;
    body_ += 'f';
    for (std::string_view token = next_token(line); !token.empty() && token[0] != '#';
         token = next_token(line)) {
      check_corner(token);
      ++corners;
    }
    body_ += '\n';
    if (corners < 3) broken("a face needs 3 vertices, here are " + std::to_string(corners));
    ++faces_;
  }

  // v, v/t, v//n or v/t/n.
  void check_corner(std::string_view token) {
    std::array<std::string_view, 3> part;
    std::size_t count = 0;
    for (std::string_view rest = token;;) {
      if (count == part.size()) broken(shown(token) + " has more than two slashes");
      const std::size_t slash = std::min(rest.find('/'), rest.size());
      part[count++] = rest.substr(0, slash);
      if (slash == rest.size()) break;
      rest.remove_prefix(slash + 1);
    }
    if (part[count - 1].empty()) broken(shown(token) + " ends in a slash");
    const std::int64_t vertex =
        index(part[0], static_cast<std::int64_t>(vertices_.size()), "vertices", forward_vertices_);
    if (static_cast<std::size_t>(vertex) > used_.size()) {
      // No further than the file can still define: a vertex takes at least seven bytes.
      const std::size_t limit = vertices_.size() + rest_.size() / 7 + 1;
      used_.resize(std::max(used_.size(), std::min(static_cast<std::size_t>(vertex), limit)));
    }
    if (static_cast<std::size_t>(vertex) <= used_.size()) {
      used_[static_cast<std::size_t>(vertex) - 1] = 1;
    }
    body_.append(" ").append(std::to_string(vertex));
    if (!part[1].empty()) {
      index(part[1], texture_coordinates_, "texture coordinates", forward_texture_);
    }
    if (!part[2].empty()) {
      body_.append("//").append(
          std::to_string(index(part[2], normals_, "normals", forward_normals_)));
    }
  }

  void check_forward(const std::vector<ForwardReference>& forward, std::int64_t defined,
                     const char* what) const {
    for (const ForwardReference& reference : forward) {
      if (reference.index <= defined) continue;
      fail(ErrorCode::kMeshIndex,
           "index " + std::to_string(reference.index) + ", but the file has " +
               std::to_string(defined) + " " + what,
           reference.line);
    }
  }

  void finish(bool ends_with_line) const {
    check_forward(forward_vertices_, static_cast<std::int64_t>(vertices_.size()), "vertices");
    check_forward(forward_texture_, texture_coordinates_, "texture coordinates");
    check_forward(forward_normals_, normals_, "normals");
    if (ends_with_line) return;
    std::size_t unused = vertices_.size();
    for (const std::uint8_t is_used : used_) unused -= is_used;
    if (unused == 0) return;
    fail(ErrorCode::kMeshBroken,
         "the file ends without a line end and " + std::to_string(unused) +
             " vertices are used by no face: it looks truncated",
         line_);
  }

  PlainObj compose() const {
    PlainObj plain;
    plain.faces = faces_;
    plain.text.reserve(vertices_.size() * 32 + body_.size());
    for (const ObjVertex& vertex : vertices_) {
      plain.text += 'v';
      for (std::size_t i = 0; i < (has_colours_ ? 6U : 3U); ++i) {
        append_number(plain.text, vertex.number[i]);
      }
      plain.text += '\n';
    }
    plain.text += body_;
    return plain;
  }

  const std::string& path_;
  std::string_view rest_;
  std::size_t line_ = 0;
  std::size_t next_line_ = 1;
  bool cut_short_ = false;
  std::vector<ObjVertex> vertices_;
  std::vector<std::uint8_t> used_;
  std::int64_t texture_coordinates_ = 0;
  std::int64_t normals_ = 0;
  std::vector<ForwardReference> forward_vertices_, forward_texture_, forward_normals_;
  std::string body_;
  std::size_t faces_ = 0;
  bool has_colours_ = false;
};

}  // namespace

PlainObj check_obj(const std::string& path, std::string_view text) {
  return ObjChecker(path, text).run();
}

}  // namespace halfspace
