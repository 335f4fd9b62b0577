// SPDX-License-Identifier: Apache-2.0
//
// Why one sample of one frame is what it is: every triangle that was submitted, with the one reason
// that decided it. Values come from the definition in 128-bit arithmetic, not from the stages; the
// stages' own verdict is computed beside it and must agree.
// Page: docs/02_use/explain.md; the rule: docs/03_design/exactness.md.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "config.hpp"
#include "depth.hpp"
#include "packets.hpp"
#include "rasterizer.hpp"

namespace halfspace {

// What became of a triangle at the sample: the first of these that holds, so the list is closed and
// every triangle is in it once. In the order of the pipeline; a later one came further.
enum class Fate : std::uint8_t {
  kClipped,      // the geometry stage left nothing of it
  kZeroArea,     // no area after snapping
  kCulled,       // faces the way that is dropped
  kNoSample,     // no pixel of the frame may hold a sample of it
  kOutsideBox,   // the pixel is not in the box of pixels that may
  kOutsideEdge,  // E < 0 before the bias, on at least one edge
  kTieLost,      // E = 0 on an edge that is neither top nor left, E >= 0 on the others
  kBehind,       // covers the sample and lost the depth test, at once or to a later triangle
  kCovers,       // covers the sample and is what it shows
};
inline constexpr int kFates = 9;

// "clipped", "zero_area", ...: the names of the JSON.
const char* fate_name(Fate fate);

enum class EdgeKind : std::uint8_t { kTop, kLeft, kOther };

// One edge at the sample, oriented: inside positive.
struct EdgeAccount {
  std::int64_t a = 0;       // S.s px
  std::int64_t b = 0;       // S.s px
  std::int64_t raw = 0;     // E, exact, S.(s+f) px^2; 0 is a tie
  std::int64_t biased = 0;  // what the hardware takes the sign of: raw, less 1 if kOther
  EdgeKind kind = EdgeKind::kOther;
};

// One triangle that entered triangle_setup.
struct PieceAccount {
  Triangle triangle;
  Fate fate = Fate::kClipped;
  std::int64_t doubled_area = 0;    // S.2s px^2, as submitted; negative: flipped by setup
  Box box;                          // when the fate is kOutsideBox or later
  std::array<EdgeAccount, 3> edge;  // when the doubled area is not zero
  unsigned failed = 0;              // kOutsideEdge, kTieLost: bit i, edge i decided
  unsigned ties_won = 0;     // kBehind, kCovers: bit i, E = 0 on edge i, which is top or left
  std::uint32_t depth = 0;   // kBehind, kCovers: U0.depth_bits at the sample
  bool passed = false;       // kBehind, kCovers: the depth test, when it was drawn
  std::int64_t behind = -1;  // kBehind: the triangle that it lost to
  bool model_agrees = true;  // triangle_setup, tile_traversal and coverage say the same
};

// One triangle as submitted: the pieces that clipping left of it (one when it was not cut) and the
// fate of the one that came furthest.
struct TriangleAccount {
  std::uint64_t index = 0;
  Fate fate = Fate::kClipped;
  std::vector<PieceAccount> pieces;
};

// The sample asked about.
struct SamplePoint {
  int x = 0;  // pixel, in the frame
  int y = 0;
  int sample = 0;  // 0..samples - 1
};

// The verdict on one triangle, without depth: the fate is never kClipped or kBehind.
//
//   triangle, frame, config  as triangle_setup(); the sample's pixel must be in the frame (checked)
//
// Exact. Cost: one descent of the pyramid.
PieceAccount explain_triangle(const Triangle& triangle, const FrameState& frame,
                              const Config& config, const SamplePoint& at);

// The accounts of a whole frame, made triangle by triangle in the order of submission.
class Explainer {
 public:
  // keep_all: keep an account of every triangle; else only of those from kTieLost on, the rest
  // is counted. config.tag_bits must be 32, so that tags are indices (checked).
  Explainer(const FrameState& frame, const Config& config, const DepthState& depth, Rgb background,
            const SamplePoint& at, bool keep_all);

  // The next triangle out of the geometry stage; its tag is the index of the submitted triangle and
  // never falls. Indices that are skipped were clipped away.
  void add(const ShadedTriangle& triangle);
  // After the last: how many were submitted.
  void finish(std::uint64_t submitted);

  // After finish().
  const std::vector<TriangleAccount>& accounts() const { return accounts_; }
  const std::array<std::uint64_t, kFates>& counts() const { return counts_; }  // by fate
  std::int64_t winner() const { return winner_; }  // -1: the background shows
  std::uint32_t depth() const;                     // of the sample, U0.depth_bits
  Rgb color() const;  // of the pixel as written to the picture: the average of its samples
  // The submitted triangle on which the stages disagree with the definition; nothing when none.
  std::optional<std::uint64_t> disagreement() const { return disagreement_; }

 private:
  void test_depth(const ShadedTriangle& triangle, PieceAccount& piece);
  void draw(const ShadedTriangle& triangle);
  void close(std::uint64_t index);
  void close_current();

  FrameState frame_;
  Config config_;
  DepthFunction depth_function_;
  SamplePoint at_;
  bool keep_all_;
  Rasterizer tile_;  // draws the one tile that holds the pixel
  DepthTile stored_{};
  std::vector<TriangleAccount> accounts_;
  std::array<std::uint64_t, kFates> counts_{};
  TriangleAccount current_;
  bool open_ = false;
  std::uint64_t next_ = 0;  // index of the next triangle not yet accounted for
  std::int64_t winner_ = -1;
  std::optional<std::uint64_t> disagreement_;
};

}  // namespace halfspace
