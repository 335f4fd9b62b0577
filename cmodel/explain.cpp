// SPDX-License-Identifier: Apache-2.0
#include "explain.hpp"

#include <algorithm>
#include <utility>

#include "fixed.hpp"
#include "samples.hpp"

namespace halfspace {
namespace {

using Wide = __int128;

std::int64_t narrow(Wide value) {
  HS_CHECK(value == static_cast<std::int64_t>(value));
  return static_cast<std::int64_t>(value);
}

// The sample's position, S.f px.
struct Position {
  Wide x;
  Wide y;
};
Position position(const SamplePoint& at, const Config& config) {
  const SamplePosition p = sample_positions(config.samples)[static_cast<std::size_t>(at.sample)];
  const int f = config.position_bits();
  const Wide one = Wide{1} << f;
  return {at.x * one + ((Wide{p.x} << f) >> 4), at.y * one + ((Wide{p.y} << f) >> 4)};
}

// Pixels p of 0..size-1 of which some sample coordinate c in [low, high] satisfies
// least <= p + c and p + c < greatest: the half-open range a top-left rule can cover.
// All but size in S.f px.
std::pair<std::int32_t, std::int32_t> pixel_range(Wide least, Wide greatest, Wide low, Wide high,
                                                  int size, int f) {
  const Wide one = Wide{1} << f;
  const Wide first = floor_div(least - high + one - 1, one);
  const Wide last = floor_div(greatest - low + one - 1, one) - 1;
  return {static_cast<std::int32_t>(std::max<Wide>(first, 0)),
          static_cast<std::int32_t>(std::min<Wide>(last, size - 1))};
}

Box box_of(const Triangle& triangle, const FrameState& frame, const Config& config) {
  const int f = config.position_bits();
  const int up = f - config.subpixel_bits;
  const auto& v = triangle.vertex;
  const auto [left, right] = std::minmax({v[0].x, v[1].x, v[2].x});
  const auto [top, bottom] = std::minmax({v[0].y, v[1].y, v[2].y});
  const SampleExtent e = sample_extent(config.samples);
  const auto px = [f](int sixteenths) { return (Wide{sixteenths} << f) >> 4; };
  const auto fine = [up](std::int32_t value) { return Wide{value} * (Wide{1} << up); };
  const auto x = pixel_range(fine(left), fine(right), px(e.low.x), px(e.high.x), frame.width, f);
  const auto y = pixel_range(fine(top), fine(bottom), px(e.low.y), px(e.high.y), frame.height, f);
  return {x.first, y.first, x.second, y.second};
}

EdgeAccount edge_of(Point from, Point to, bool flipped, const Position& p, const Config& config) {
  if (flipped) std::swap(from, to);  // the same line, seen from the other side
  const Wide up = Wide{1} << (config.position_bits() - config.subpixel_bits);
  EdgeAccount edge;
  edge.a = std::int64_t{from.y} - to.y;
  edge.b = std::int64_t{to.x} - from.x;
  edge.raw = narrow(edge.a * (p.x - from.x * up) + edge.b * (p.y - from.y * up));
  // y points down and the inside is where E grows: to the right of a left edge, below a top one.
  if (edge.a > 0) edge.kind = EdgeKind::kLeft;
  if (edge.a == 0 && edge.b > 0) edge.kind = EdgeKind::kTop;
  edge.biased = edge.raw - (edge.kind == EdgeKind::kOther ? 1 : 0);
  return edge;
}

// What the edges say of a sample whose pixel is in the box.
void judge_edges(PieceAccount& piece) {
  unsigned outside = 0;
  unsigned lost = 0;
  for (unsigned i = 0; i < 3; ++i) {
    const EdgeAccount& edge = piece.edge[i];
    if (edge.raw < 0) outside |= 1u << i;
    if (edge.raw == 0) (edge.kind == EdgeKind::kOther ? lost : piece.ties_won) |= 1u << i;
  }
  piece.failed = outside != 0 ? outside : lost;
  piece.fate = outside != 0 ? Fate::kOutsideEdge : lost != 0 ? Fate::kTieLost : Fate::kCovers;
  if (piece.fate != Fate::kCovers) piece.ties_won = 0;
}

PieceAccount judge(const Triangle& triangle, const FrameState& frame, const Config& config,
                   const SamplePoint& at) {
  PieceAccount piece;
  piece.triangle = triangle;
  const auto& v = triangle.vertex;
  piece.doubled_area = narrow((Wide{v[1].x} - v[0].x) * (Wide{v[2].y} - v[0].y) -
                              (Wide{v[2].x} - v[0].x) * (Wide{v[1].y} - v[0].y));
  if (piece.doubled_area == 0) {
    piece.fate = Fate::kZeroArea;
    return piece;
  }
  const bool flipped = piece.doubled_area < 0;
  const Position p = position(at, config);
  for (std::size_t i = 0; i < 3; ++i) {
    piece.edge[i] = edge_of(v[i], v[(i + 1) % 3], flipped, p, config);
  }
  piece.box = box_of(triangle, frame, config);
  const Box& box = piece.box;
  if ((frame.cull == Cull::kFront && flipped) || (frame.cull == Cull::kBack && !flipped)) {
    piece.fate = Fate::kCulled;
  } else if (box.x_first > box.x_last || box.y_first > box.y_last) {
    piece.fate = Fate::kNoSample;
  } else if (at.x < box.x_first || at.x > box.x_last || at.y < box.y_first || at.y > box.y_last) {
    piece.fate = Fate::kOutsideBox;
  } else {
    judge_edges(piece);
  }
  return piece;
}

// The tile that holds the pixel, by the way the stages find it; nothing when they do not come there
// or find it empty.
std::optional<CoverageTile> model_tile(const SetupTriangle& setup, const Config& config,
                                       const SamplePoint& at) {
  Node node = root_node(setup);
  for (int level = 0; level < config.levels() - 1; ++level) {
    const int side = config.node_log2(level + 1);
    const int last = config.grid() - 1;
    const int bit = ((at.y >> side & last) << config.grid_log2) | (at.x >> side & last);
    if ((live_children(node, level, setup, config) >> bit & 1) == 0) return std::nullopt;
    node = child_node(node, level, bit, setup, config);
  }
  return coverage(node, setup, config);
}

int lane_of(const SamplePoint& at, const Config& config) {
  const int last = config.grid() - 1;
  return ((at.y & last) << config.grid_log2) | (at.x & last);
}

bool model_agrees(const PieceAccount& piece, const FrameState& frame, const Config& config,
                  const SamplePoint& at) {
  SetupOutcome outcome = SetupOutcome::kDrawn;
  const auto setup = triangle_setup(piece.triangle, frame, config, &outcome);
  if (!setup) {
    return (outcome == SetupOutcome::kZeroArea && piece.fate == Fate::kZeroArea) ||
           (outcome == SetupOutcome::kCulled && piece.fate == Fate::kCulled) ||
           (outcome == SetupOutcome::kNoSample && piece.fate == Fate::kNoSample);
  }
  if (piece.fate < Fate::kOutsideBox || !(setup->box == piece.box)) return false;
  const auto tile = model_tile(*setup, config, at);
  const bool covered =
      tile && (tile->mask[static_cast<std::size_t>(at.sample)] >> lane_of(at, config) & 1) != 0;
  return covered == (piece.fate == Fate::kCovers);
}

}  // namespace

const char* fate_name(Fate fate) {
  constexpr std::array<const char*, kFates> kNames{"clipped",   "zero_area",   "culled",
                                                   "no_sample", "outside_box", "outside_edge",
                                                   "tie_lost",  "behind",      "covers"};
  return kNames[static_cast<std::size_t>(fate)];
}

PieceAccount explain_triangle(const Triangle& triangle, const FrameState& frame,
                              const Config& config, const SamplePoint& at) {
  HS_CHECK(at.x >= 0 && at.x < frame.width && at.y >= 0 && at.y < frame.height);
  HS_CHECK(at.sample >= 0 && at.sample < config.samples);
  PieceAccount piece = judge(triangle, frame, config, at);
  piece.model_agrees = model_agrees(piece, frame, config, at);
  return piece;
}

Explainer::Explainer(const FrameState& frame, const Config& config, const DepthState& depth,
                     Rgb background, const SamplePoint& at, bool keep_all)
    : frame_(frame),
      config_(config),
      depth_function_(depth.function),
      at_(at),
      keep_all_(keep_all),
      tile_(frame, config, depth, background) {
  HS_CHECK(config.tag_bits == 32);
  stored_.fill(depth.cleared(config));
}

std::uint32_t Explainer::depth() const {
  return stored_[static_cast<std::size_t>(lane_of(at_, config_))];
}

Rgb Explainer::color() const { return tile_.framebuffer().resolve().at(at_.x, at_.y); }

void Explainer::test_depth(const ShadedTriangle& triangle, PieceAccount& piece) {
  const auto setup = triangle_setup(triangle.triangle, frame_, config_);
  const InterpolationSetup planes =
      interpolation_setup(*setup, triangle.triangle, triangle.attributes, 0, config_);
  const int mask = config_.grid() - 1;
  TilePlane plane = tile_plane(planes.depth, planes.origin, at_.x & ~mask, at_.y & ~mask, config_);
  plane.base += sample_delta(planes.depth, at_.sample, config_);
  piece.depth = depth_value(plane.at(at_.x & mask, at_.y & mask), config_);
  const GridMask lane = GridMask{1} << lane_of(at_, config_);
  piece.passed = depth_test(lane, plane, depth_function_, stored_, config_) != 0;
  piece.fate = Fate::kBehind;  // close() lifts the winner
  if (piece.passed) {
    winner_ = static_cast<std::int64_t>(piece.triangle.tag);
  } else {
    piece.behind = winner_;
  }
}

// The whole tile, all samples: what the picture shows of the pixel.
void Explainer::draw(const ShadedTriangle& triangle) {
  const auto setup = triangle_setup(triangle.triangle, frame_, config_);
  if (!setup) return;
  const auto tile = model_tile(*setup, config_, at_);
  if (!tile) return;
  tile_.begin(triangle, *setup);
  tile_.draw_tile(*tile);
}

void Explainer::add(const ShadedTriangle& triangle) {
  const std::uint64_t index = triangle.triangle.tag;
  if (!open_ || index != current_.index) {
    close_current();
    HS_CHECK(index >= next_);
    close(index);
    current_ = {index, Fate::kClipped, {}};
    open_ = true;
  }
  PieceAccount piece = explain_triangle(triangle.triangle, frame_, config_, at_);
  if (!piece.model_agrees && !disagreement_) disagreement_ = index;
  if (piece.fate == Fate::kCovers) test_depth(triangle, piece);
  if (piece.fate > Fate::kOutsideBox) draw(triangle);
  current_.fate = std::max(current_.fate, piece.fate);
  current_.pieces.push_back(piece);
}

// Indices up to `index` that never came: clipped away.
void Explainer::close(std::uint64_t index) {
  for (; next_ < index; ++next_) {
    ++counts_[static_cast<std::size_t>(Fate::kClipped)];
    if (keep_all_) accounts_.push_back({next_, Fate::kClipped, {}});
  }
}

void Explainer::close_current() {
  if (!open_) return;
  open_ = false;
  next_ = current_.index + 1;
  ++counts_[static_cast<std::size_t>(current_.fate)];
  if (keep_all_ || current_.fate >= Fate::kTieLost) accounts_.push_back(std::move(current_));
}

void Explainer::finish(std::uint64_t submitted) {
  close_current();
  close(submitted);
  std::int64_t later = -1;  // the triangle that replaced the one before it
  for (auto account = accounts_.rbegin(); account != accounts_.rend(); ++account) {
    for (auto piece = account->pieces.rbegin(); piece != account->pieces.rend(); ++piece) {
      if (piece->fate != Fate::kBehind || !piece->passed) continue;
      piece->behind = later;
      if (later < 0) {
        piece->fate = Fate::kCovers;
        account->fate = Fate::kCovers;
      }
      later = static_cast<std::int64_t>(account->index);
    }
  }
  if (winner_ < 0) return;
  --counts_[static_cast<std::size_t>(Fate::kBehind)];
  ++counts_[static_cast<std::size_t>(Fate::kCovers)];
}

}  // namespace halfspace
