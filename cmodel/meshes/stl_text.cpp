// SPDX-License-Identifier: Apache-2.0
#include "stl_text.hpp"

#include <algorithm>
#include <cctype>

#include "../io/error.hpp"
#include "../io/scan.hpp"

namespace halfspace {
namespace {

std::string lower(std::string_view text) {
  std::string out(text.substr(0, 64));
  for (char& c : out) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

class StlText {
 public:
  using Sink = std::function<void(const std::array<glm::dvec3, 3>&, std::size_t)>;

  explicit StlText(const MeshSource& source) : source_(source), rest_(source.bytes) {
    if (rest_.starts_with("\xef\xbb\xbf")) rest_.remove_prefix(3);
  }

  // The first word that is in no comment, in small letters.
  std::string first_word() { return word(); }
  std::string_view rest() const { return rest_; }

  void read(const Sink& sink) {
    std::size_t facets = 0;
    for (std::string keyword = word(); !keyword.empty(); keyword = word()) {
      if (keyword == "end") keyword += word();  // "end solid"
      if (keyword == "endfacet") {
        close_facet(sink);
        if (++facets % kReportEvery == 0) source_.report(rest_.size());
      } else {
        read_keyword(keyword);
      }
    }
    if (in_facet_) fail("the file ends inside a facet");
    if (!closed_) {
      source_.left_out.add("missing_endsolid", "endsolid that is not there: the file may be cut",
                           "endsolids that are not there");
    }
  }

 private:
  [[noreturn]] void fail(const std::string& text, ErrorCode code = ErrorCode::kMeshBroken) const {
    throw Error(code, source_.path + ":" + std::to_string(line_), text);
  }

  std::string_view token() {
    std::size_t blanks = 0;
    for (; blanks < rest_.size() && (is_blank(rest_[blanks]) || rest_[blanks] == '\0'); ++blanks) {
      const bool crlf = rest_[blanks] == '\r' && rest_.substr(blanks + 1, 1) == "\n";
      if (rest_[blanks] == '\n' || (rest_[blanks] == '\r' && !crlf)) ++line_;
    }
    rest_.remove_prefix(blanks);
    return next_token(rest_);
  }

  void skip_line() { rest_.remove_prefix(std::min(rest_.find_first_of("\r\n"), rest_.size())); }

  std::string word() {
    for (;;) {
      const std::string_view text = token();
      if (!text.starts_with('#') && !text.starts_with("//")) return lower(text);
      skip_line();
    }
  }

  void read_keyword(const std::string& keyword) {
    if (keyword == "solid" || keyword == "endsolid") {
      if (in_facet_) fail(keyword + " inside a facet");
      closed_ = keyword == "endsolid";
      skip_line();  // its name
    } else if (keyword == "facet") {
      if (in_facet_) fail("a facet inside a facet");
      in_facet_ = true;
      corners_ = 0;
      skip_normal();
    } else if (keyword == "vertex") {
      read_vertex();
    } else if (keyword == "color") {
      skip_line();
    } else if (keyword != "outer" && keyword != "loop" && keyword != "endloop") {
      fail(shown(keyword) + " is not an STL keyword");
    }
  }

  // Whatever stands before the corners. Normals are made from these.
  void skip_normal() {
    for (int i = 0; i < 4; ++i) {  // the word, three numbers
      const std::string_view before = rest_;
      const std::size_t line = line_;
      const std::string next = lower(token());
      if (next == "outer" || next == "vertex" || next == "endfacet" || next == "end") {
        rest_ = before;
        line_ = line;
        return;
      }
    }
  }

  void read_vertex() {
    if (!in_facet_) fail("a vertex outside a facet");
    glm::dvec3 corner(0.0);
    for (int i = 0; i < 3; ++i) {
      const std::string_view text = token();
      const std::optional<double> value = parse_coordinate(text);
      if (text.empty()) fail("the file ends inside a facet");
      if (!value) fail(shown(text) + " is not a number");
      if (!is_finite_float(*value)) {
        fail(shown(text) + " is not a finite single-precision number", ErrorCode::kMeshNotFinite);
      }
      corner[i] = *value;
    }
    if (corners_ < corner_.size()) corner_[corners_] = corner;
    ++corners_;
  }

  void close_facet(const Sink& sink) {
    if (!in_facet_ || corners_ != 3) {
      fail("a facet needs 3 vertices, here are " + std::to_string(in_facet_ ? corners_ : 0));
    }
    in_facet_ = false;
    sink(corner_, line_);
  }

  const MeshSource& source_;
  std::string_view rest_;
  std::size_t line_ = 1;
  bool in_facet_ = false;
  bool closed_ = true;
  std::size_t corners_ = 0;
  std::array<glm::dvec3, 3> corner_{};
};

}  // namespace

bool is_stl_text(std::string_view bytes) {
  const MeshProgress none;
  LeftOut unused;
  const std::string path;
  const MeshSource source{path, bytes, none, unused};
  StlText text(source);
  const std::string first = text.first_word();
  if (first == "facet") return true;
  if (first != "solid") return false;
  constexpr std::string_view kWords[] = {"facet", "endsolid", "end solid"};
  return std::any_of(std::begin(kWords), std::end(kWords), [&](std::string_view word) {
    const std::string_view rest = text.rest();
    return std::search(rest.begin(), rest.end(), word.begin(), word.end(), [](char c, char w) {
             return (c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c) == w;
           }) != rest.end();
  });
}

void read_stl_text(const MeshSource& source, const StlText::Sink& sink) {
  StlText(source).read(sink);
}

}  // namespace halfspace
