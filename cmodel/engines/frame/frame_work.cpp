// SPDX-License-Identifier: Apache-2.0
#include "frame_work.hpp"

#include <algorithm>
#include <utility>

#include "../../fixed.hpp"
#include "../common/isas.hpp"

namespace halfspace {
namespace {

// Triangles prepared together, and the records after which their tiles are drawn: what is known of
// them stays in the second-level cache.
constexpr std::size_t kPieceTriangles = 4096;
constexpr std::size_t kPieceRecords = 24576;
// Records that are sorted, at most, of the piece of one thread and of each of several threads'.
constexpr std::size_t kSortedAlone = 1 << 16;
constexpr std::size_t kSortedShared = 1 << 15;
// Tiles that are drawn together where they are not sorted, and a run's more: what is kept of them
// between depth and colour does not grow with the triangles.
constexpr std::size_t kSliceTiles = 1 << 11;
// Tiles to finish that are worth a second thread, which takes some 30 us to start.
constexpr std::size_t kSharedTiles = 1 << 13;
// Kernels write whole vectors of records.
constexpr std::size_t kVertexSlack = 16;

FrameConstants frame_constants(const FrameState& frame, const Config& config,
                               const FrameOptions& options) {
  HS_CHECK(validate(config).empty());
  HS_CHECK(options.threads >= 1 && (options.threads == 1 || options.run));
  FrameConstants out;
  out.config = config;
  out.frame = frame;
  out.depth_function = options.depth.function;
  out.clear = options.depth.cleared(config);
  HS_CHECK(out.clear <= config.depth_max());
  if (options.scissor) {
    HS_CHECK(inside(*options.scissor, frame));
    out.scissored = true;
    out.scissor = *options.scissor;
  }
  out.f = config.position_bits();
  out.gradient_bits = config.gradient_bits;
  out.samples = config.samples;
  out.colors = std::min(config.attributes, 3);
  return out;
}

// Rows of tiles that a thread draws at a time: a triangle in two rows is then mostly one thread's,
// and there are enough bands for everyone.
FrameBuckets::Grid frame_grid(const FrameStore& store, int threads) {
  const std::uint32_t share = store.rows() / (8 * static_cast<std::uint32_t>(threads));
  const std::uint32_t band = threads == 1 ? store.rows() : std::clamp(share, 1u, 4u);
  return {store.columns(), store.rows(), band, threads == 1 ? kSortedAlone : kSortedShared};
}

}  // namespace

FrameEngine::Work::Work(const FrameState& frame, const Config& config, const FrameOptions& options)
    : options_(options),
      constants_(frame_constants(frame, config, options)),
      project_(project_constants(frame, config)),
      kernels_(simd::find_isa(simd::frame_kernels(), options.isa)),
      store_(frame, config, options.background, constants_.clear),
      grid_(frame_grid(store_, options.threads)),
      passed_(static_cast<std::size_t>(options.threads)),
      counts_(passed_.size()),
      scratch_(passed_.size(), FrameBuckets::Scratch(store_.tiles_total())) {
  const std::size_t threads = passed_.size();
  for (std::size_t i = 0; i < (threads == 1 ? 1 : 2 * threads * kPiecesPerThread); ++i) {
    pieces_.emplace_back(frame, config, kernels_);
    plain_.emplace_back(frame, config);
  }
  geometry_.resize(pieces_.size());
  clear();
}

void FrameEngine::Work::clear() {
  store_.clear();
  if (std::exchange(drawing_, false)) {
    for (FrameBuckets::Scratch& scratch : scratch_) std::fill(scratch.begin(), scratch.end(), 0u);
    for (PassedTiles& passed : passed_) std::fill(passed.slot.begin(), passed.slot.end(), 0u);
  }
  add_counts();  // of a draw that threw
  add_geometry();
  stats_ = {};
  geometry_sum_ = {};
  hits_.clear();
  if (options_.count_hits) {
    hits_.assign(passed_.size(), HitPlane(constants_.frame.width, constants_.frame.height));
  }
}

void FrameEngine::Work::check(std::span<const ShadedTriangle> triangles) const {
  const Config& config = constants_.config;
  for (const ShadedTriangle& triangle : triangles) {
    for (const VertexAttributes& vertex : triangle.attributes) {
      HS_CHECK(vertex.depth >= kDepthLeast && vertex.depth <= kDepthMost);
      if (constants_.colors == 0) continue;
      HS_CHECK(vertex.inverse_w >= 1 && vertex.inverse_w >> config.inverse_w_bits == 0);
      for (std::size_t n = 0; n < static_cast<std::size_t>(constants_.colors); ++n) {
        HS_CHECK(vertex.value[n] >= kValueLeast && vertex.value[n] <= kValueMost);
      }
    }
  }
}

void FrameEngine::Work::draw(std::span<const ShadedTriangle> triangles) {
  check(triangles);
  constants_.packed = true;
  Feed feed;
  feed.triangles = triangles.size();
  feed.assemble = [&](std::size_t piece, std::size_t first, std::size_t count) {
    for (const ShadedTriangle& triangle : triangles.subspan(first, count)) {
      pieces_[piece].assembly().append(triangle, constants_.colors);
    }
  };
  run(feed);
}

void FrameEngine::Work::draw(const VertexSource& source,
                             std::span<const TriangleIndices> triangles) {
  HS_CHECK(source.size() < Assembly::kExtra);
  constants_.packed = false;
  if (records_.size() < source.size() + kVertexSlack) {
    records_.resize(source.size() + kVertexSlack);
  }
  Feed feed;
  feed.triangles = triangles.size();
  feed.source = &source;
  feed.vertices = [&](std::size_t first, std::size_t count) {
    const std::size_t end = std::size_t{1} + kernels_.highest(triangles[first].data(), 3 * count);
    HS_CHECK(end <= source.size());
    return end;
  };
  feed.assemble = [&](std::size_t piece, std::size_t first, std::size_t count) {
    halfspace::assemble(source, records_, triangles.subspan(first, count), constants_.colors,
                        plain_[piece], pieces_[piece].assembly(), geometry_[piece]);
  };
  run(feed);
  add_geometry();
}

void FrameEngine::Work::run(const Feed& feed) {
  drawing_ = true;
  options_.threads == 1 ? draw_alone(feed) : draw_shared(feed);
  drawing_ = false;
  add_counts();
}

void FrameEngine::Work::assemble(const Feed& feed, std::size_t piece, std::size_t first,
                                 std::size_t count) {
  pieces_[piece].assembly().clear();
  feed.assemble(piece, first, count);
  pieces_[piece].start();
}

void FrameEngine::Work::tell(FramePiece& piece) const {
  const Assembly& assembly = piece.assembly();
  if (options_.on_triangles) options_.on_triangles({assembly.triangle.data(), assembly.count});
}

void FrameEngine::Work::draw_tiles(const FramePiece& piece, std::uint32_t band,
                                   std::size_t thread) {
  PassedTiles& passed = passed_[thread];
  FrameCounts& counts = counts_[thread];
  passed.count = 0;
  if (passed.slot.size() < piece.triangle_count()) passed.slot.resize(2 * piece.triangle_count());
  if (piece.buckets().filled()) {
    kernels_.buckets(constants_, piece.buckets().range(band), store_, passed, counts);
    if (passed.count > 0) kernels_.shade(constants_, piece.triangles(), store_, passed);
    return;
  }
  for (simd::RecordOrder rest = piece.order(band); rest.count > 0; passed.count = 0) {
    const simd::RecordOrder slice = piece.take(rest, kSliceTiles);
    kernels_.depth(constants_, piece.tiles(), slice, store_, passed, counts);
    if (passed.count > 0) kernels_.shade(constants_, piece.triangles(), store_, passed);
  }
}

// Vertices are projected when they are needed: most meshes use them about in their order, and then
// their records are still in the cache.
void FrameEngine::Work::draw_alone(const Feed& feed) {
  FramePiece& piece = pieces_.front();
  std::size_t projected = 0;
  for (std::size_t first = 0; first < feed.triangles; first += kPieceTriangles) {
    const std::size_t count = std::min(kPieceTriangles, feed.triangles - first);
    const std::size_t needed = feed.source == nullptr ? 0 : feed.vertices(first, count);
    if (needed > projected) {
      kernels_.project(project_, *feed.source, projected, needed - projected, records_.data());
      projected = needed;
    }
    assemble(feed, 0, first, count);
    tell(piece);
    while (!piece.finished()) {
      piece.cover(constants_, records_, kPieceRecords, grid_, scratch_[0]);
      draw_tiles(piece, 0, 0);
      if (options_.count_hits) hits_[0].add(piece.chunk());
    }
  }
}

std::vector<std::uint8_t> FrameEngine::Work::hits() const {
  HS_CHECK(options_.count_hits);
  HitPlane sum = hits_.front();
  for (std::size_t i = 1; i < hits_.size(); ++i) sum.add(hits_[i]);
  return sum.count();
}

PictureView FrameEngine::Work::picture() {
  store_.make_picture();
  if (options_.threads > 1 && store_.tiles_unfinished() >= kSharedTiles) {
    finish_shared();
  } else {
    for (std::uint32_t row = 0; row < store_.rows(); ++row) store_.finish_row(row);
  }
  return store_.picture();
}

// The kernels' counts; those of setup run on from the engines' first triangle.
void FrameEngine::Work::add_counts() {
  for (FrameCounts& counts : counts_) {
    stats_.tiles_covered += counts.tiles;
    stats_.samples_covered += counts.samples;
    stats_.fragments += counts.fragments;
    stats_.fragments_shaded += counts.shaded;
    counts = {};
  }
  RasterStats now;
  for (const FramePiece& piece : pieces_) count_triangles(piece.counts(), now);
  stats_.triangles += now.triangles - setup_.triangles;
  stats_.triangles_zero_area += now.triangles_zero_area - setup_.triangles_zero_area;
  stats_.triangles_culled += now.triangles_culled - setup_.triangles_culled;
  stats_.triangles_no_sample += now.triangles_no_sample - setup_.triangles_no_sample;
  setup_ = now;
}

void FrameEngine::Work::add_geometry() {
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    geometry_sum_ += plain_[i].stats();
    geometry_sum_ += geometry_[i];
    geometry_[i] = {};
    plain_[i] = GeometryStage(constants_.frame, constants_.config);
  }
}

}  // namespace halfspace
