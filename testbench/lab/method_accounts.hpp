// SPDX-License-Identifier: Apache-2.0
//
// What a method of the gallery made of every triangle at one pixel, beside what the exact rule says
// of it, and where they differ which kind of mistake it is. Page: docs/02_use/explain.md.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "methods/method.hpp"
#include "oracle/oracle.hpp"

namespace halfspace::lab {

// What became of a triangle at the pixel's centre: the first of these that holds, so the list is
// closed and every triangle is in it once. Two triangles are beside each other when their interiors
// have no point in common: then the exact rule gives a sample to one of them at most.
enum class MethodFate : std::uint8_t {
  kClipped,   // nothing of it is left before the method, and no hit
  kOutside,   // no hit, and it owns nothing here
  kTieLost,   // the same, with the centre on its edge: the rule gives it to the other side
  kFalseHit,  // a hit without owning it, and no triangle beside it hits by right
  kDouble,  // a hit without owning it where one beside it hits by right; or more hits than it owns
  kMissed,  // owns it, fewer hits, and one beside it hits instead
  kGap,     // owns it, fewer hits, and none beside it hits instead: a hole
  kBehind,  // as many hits as it owns; another triangle's depth shows
  kCovers   // as many hits as it owns; shows, or the method has no depth
};
inline constexpr int kMethodFates = 9;

// "clipped", "outside", ...: the names of the JSON.
const char* fate_name(MethodFate fate);
// kFalseHit to kGap.
bool is_mistake(MethodFate fate);

enum class RuleEdge : std::uint8_t { kTop, kLeft, kOther };

// One edge at the pixel's centre, oriented: inside positive.
struct ExactEdge {
  double value = 0;  // px^2, exact and then rounded: of the right sign
  RuleEdge kind = RuleEdge::kOther;
};

// What the exact rule says of a piece.
enum class Verdict : std::uint8_t { kNoArea, kOutside, kTieLost, kTieWon, kInside };

// A triangle, or a piece of a clipped one, in the window.
struct PieceDecision {
  oracle::Corners vertex{};  // px, as the exact rule takes them
  Verdict verdict = Verdict::kNoArea;
  bool owns_unsnapped = false;        // by its vertices before they were snapped
  std::array<ExactEdge, 3> edge{};    // from vertex i to (i + 1) mod 3; when there is an area
  methods::OwnEdges own;              // the same edges as the method has them
  std::optional<std::uint32_t> hits;  // by this piece, where the method draws pieces
};

// A segment, for methods that draw lines.
struct SegmentDecision {
  methods::Segment segment;
  std::uint32_t hits = 0;
  std::uint32_t owns = 0;
};

struct MethodAccount {
  std::uint64_t triangle = 0;  // index as submitted
  MethodFate fate = MethodFate::kClipped;
  std::uint32_t hits = 0;
  std::uint32_t owns = 0;  // by the exact rule: 0 or 1; lines: 0 to 3
  bool shows = false;
  std::uint32_t facets = 0;               // what clipping left of it
  std::vector<PieceDecision> pieces;      // of them, those near the pixel; all when all are kept
  std::vector<SegmentDecision> segments;  // lines only
};

struct MethodPixel {
  int truth_bits =
      -1;  // what the exact rule's vertices are snapped to, 2^-bits px; -1: they are not
  std::uint64_t triangles = 0;
  std::array<std::uint64_t, kMethodFates> counts{};  // by fate
  std::vector<MethodAccount> accounts;
  std::uint32_t hits = 0;
  std::uint32_t owns = 0;
  std::int64_t winner = -1;  // whose depth and colour show; -1: nobody's, or the method has none
  double depth = 1;          // of the winner
  methods::Color color{};    // of the winner
};

// Draws the whole drawing onto the canvas, which must be fresh and hold the pixel (checked), and
// accounts for pixel (x, y).
//
//   triangles  how many triangles the drawing was made of by drawing_of()
//   keep_all   an account of every triangle; else of those that hit it, own it or lost a tie
//
// The exact rule: the top-left rule of docs/03_design/exactness.md by the oracle's predicates,
// lines as the suites judge them; on vertices snapped as Method::subpixel_bits says. The picture
// may be unfinished (Canvas::exhausted()).
MethodPixel method_pixel(const methods::Method& method, const methods::Drawing& drawing,
                         std::uint64_t triangles, methods::Canvas& canvas, int x, int y,
                         bool keep_all);

}  // namespace halfspace::lab
