// SPDX-License-Identifier: Apache-2.0
#include "frame_engine.hpp"

#include <algorithm>
#include <atomic>
#include <limits>

#include "../fixed.hpp"
#include "frame_piece.hpp"

namespace halfspace {
namespace {

// Triangles prepared together, and the records after which their tiles are drawn: what is known of
// them stays in the second-level cache.
constexpr std::size_t kPieceTriangles = 2048;
constexpr std::size_t kPieceRecords = 4096;
// Pieces per thread between two meetings of the threads.
constexpr std::size_t kPiecesPerThread = 4;
// Vertices a thread projects at a time.
constexpr std::size_t kVertexRange = 4096;
// Kernels write whole vectors of records.
constexpr std::size_t kVertexSlack = 16;

const simd::FrameKernels& find_kernels(std::string_view isa) {
  const auto kernels = simd::frame_kernels();
  if (isa.empty()) return kernels.front();
  for (const simd::FrameKernels& kernel : kernels) {
    if (kernel.isa == isa) return kernel;
  }
  HS_CHECK(false && "no such instruction set");
}

FrameConstants frame_constants(const FrameState& frame, const Config& config,
                               const FrameOptions& options) {
  HS_CHECK(validate(config).empty());
  HS_CHECK(options.threads >= 1 && (options.threads == 1 || options.run));
  FrameConstants out;
  out.config = config;
  out.frame = frame;
  out.depth_function = options.depth_function;
  out.f = config.position_bits();
  out.gradient_bits = config.gradient_bits;
  out.samples = config.samples;
  out.colors = std::min(config.attributes, 3);
  out.far = (std::uint32_t{1} << config.depth_bits) - 1;
  return out;
}

}  // namespace

class FrameEngine::Work {
 public:
  Work(const FrameState& frame, const Config& config, const FrameOptions& options)
      : options_(options),
        constants_(frame_constants(frame, config, options)),
        project_(project_constants(frame, config)),
        kernels_(find_kernels(options.isa)),
        store_(frame, config, options.background),
        passed_(static_cast<std::size_t>(options.threads)) {
    const std::size_t threads = passed_.size();
    for (std::size_t i = 0; i < (threads == 1 ? 1 : threads * kPiecesPerThread); ++i) {
      pieces_.emplace_back(frame, config, kernels_);
      plain_.emplace_back(frame, config);
    }
    geometry_.resize(pieces_.size());
    counts_.resize(threads);
    clear();
  }

  void clear() {
    store_.clear();
    stats_ = {};
    geometry_sum_ = {};
    hits_.clear();
    if (options_.count_hits) {
      hits_.assign(pieces_.size(), HitPlane(constants_.frame.width, constants_.frame.height));
    }
  }

  void draw(std::span<const ShadedTriangle> triangles) {
    check(triangles);
    constants_.packed = true;
    const int colors = constants_.colors;
    draw_pieces(triangles.size(), [&](std::size_t piece, std::size_t first, std::size_t count) {
      for (const ShadedTriangle& triangle : triangles.subspan(first, count)) {
        pieces_[piece].assembly().append(triangle, colors);
      }
    });
  }

  void draw(const VertexSource& source, std::span<const TriangleIndices> triangles) {
    constants_.packed = false;
    if (records_.size() < source.size() + kVertexSlack) {
      records_.resize(source.size() + kVertexSlack);
    }
    projected_ = 0;
    if (options_.threads > 1) project_all(source);
    draw_pieces(triangles.size(), [&](std::size_t piece, std::size_t first, std::size_t count) {
      const auto some = triangles.subspan(first, count);
      const std::size_t end = kernels_.highest(some.front().data(), 3 * count) + std::size_t{1};
      HS_CHECK(end <= source.size());
      if (options_.threads == 1) project_to(source, end);
      assemble(source, records_, some, constants_.colors, plain_[piece], pieces_[piece].assembly(),
               geometry_[piece]);
    });
    for (std::size_t i = 0; i < pieces_.size(); ++i) add_geometry(i);
  }

  const FrameStore& store() const { return store_; }
  const RasterStats& stats() const { return stats_; }
  const GeometryStats& geometry() const { return geometry_sum_; }
  std::vector<std::uint8_t> hits() const {
    HS_CHECK(options_.count_hits);
    HitPlane sum = hits_.front();
    for (std::size_t i = 1; i < hits_.size(); ++i) sum.add(hits_[i]);
    return sum.count();
  }

 private:
  void check(std::span<const ShadedTriangle> triangles) const {
    const Config& config = constants_.config;
    for (const ShadedTriangle& triangle : triangles) {
      for (const VertexAttributes& vertex : triangle.attributes) {
        HS_CHECK(vertex.depth >> (config.depth_bits + kDepthFractionBits) == 0);
        if (constants_.colors == 0) continue;
        HS_CHECK(vertex.inverse_w >= 1 && vertex.inverse_w >> config.inverse_w_bits == 0);
        for (std::size_t n = 0; n < static_cast<std::size_t>(constants_.colors); ++n) {
          HS_CHECK(vertex.value[n] <= 255u << kAttributeFractionBits);
        }
      }
    }
  }

  void project_all(const VertexSource& source) {
    std::atomic<std::size_t> next = 0;
    options_.run(options_.threads, [&](int) {
      for (;;) {
        const std::size_t first = next.fetch_add(kVertexRange);
        if (first >= source.size()) return;
        kernels_.project(project_, source, first, std::min(kVertexRange, source.size() - first),
                         records_.data());
      }
    });
  }

  // Vertices are projected when they are needed: most meshes use them about in their order, and
  // then their records are still in the cache.
  void project_to(const VertexSource& source, std::size_t end) {
    if (end <= projected_) return;
    kernels_.project(project_, source, projected_, end - projected_, records_.data());
    projected_ = end;
  }

  // Calls assemble(piece, first, count) for each piece of `triangles`, and draws what comes of it.
  template <class Assemble>
  void draw_pieces(std::size_t triangles, const Assemble& assemble) {
    const std::size_t round = pieces_.size() * kPieceTriangles;
    for (std::size_t first = 0; first < triangles; first += round) {
      const std::size_t count = std::min(round, triangles - first);
      if (options_.threads == 1) {
        draw_here(first, count, assemble);
      } else {
        draw_round(first, count, assemble);
      }
    }
    for (const FrameCounts& counts : counts_) add_counts(counts);
    counts_.assign(counts_.size(), {});
    add_setup_counts();
  }

  template <class Assemble>
  void draw_here(std::size_t first, std::size_t count, const Assemble& assemble) {
    FramePiece& piece = pieces_.front();
    piece.assembly().clear();
    assemble(0, first, count);
    tell(piece);
    piece.start();
    while (!piece.finished()) {
      piece.cover(constants_, records_, kPieceRecords, 1);
      draw_tiles(0, 0);
      if (options_.count_hits) hits_[0].add(piece.chunk());
    }
  }

  // Pieces in any order, then their tiles, each row of tiles by one thread, in order.
  template <class Assemble>
  void draw_round(std::size_t first, std::size_t count, const Assemble& assemble) {
    const std::size_t used = (count + kPieceTriangles - 1) / kPieceTriangles;
    std::atomic<std::size_t> next = 0;
    options_.run(options_.threads, [&](int) {
      for (std::size_t i = next++; i < used; i = next++) {
        const std::size_t from = i * kPieceTriangles;
        pieces_[i].assembly().clear();
        assemble(i, first + from, std::min(kPieceTriangles, count - from));
        pieces_[i].start();
        pieces_[i].cover(constants_, records_, std::numeric_limits<std::size_t>::max(),
                         options_.threads);
        if (options_.count_hits) hits_[i].add(pieces_[i].chunk());
      }
    });
    for (std::size_t i = 0; i < used; ++i) tell(pieces_[i]);
    options_.run(options_.threads, [&](int owner) {
      for (std::size_t i = 0; i < used; ++i) draw_tiles(i, owner);
    });
  }

  void tell(FramePiece& piece) const {
    const Assembly& assembly = piece.assembly();
    if (options_.on_triangles) options_.on_triangles({assembly.triangle.data(), assembly.count});
  }

  void draw_tiles(std::size_t at, int owner) {
    const FramePiece& piece = pieces_[at];
    PassedTiles& passed = passed_[static_cast<std::size_t>(owner)];
    passed.count = 0;
    kernels_.depth(constants_, piece.tiles(), piece.order(owner), store_, passed,
                   counts_[static_cast<std::size_t>(owner)]);
    kernels_.shade(constants_, piece.triangles(), store_, passed);
  }

  void add_counts(const FrameCounts& counts) {
    stats_.tiles_covered += counts.tiles;
    stats_.samples_covered += counts.samples;
    stats_.fragments += counts.fragments;
    stats_.fragments_shaded += counts.shaded;
  }

  // The engines count from their first triangle on; so do these sums.
  void add_setup_counts() {
    RasterStats now;
    for (const FramePiece& piece : pieces_) count_triangles(piece.counts(), now);
    stats_.triangles += now.triangles - setup_.triangles;
    stats_.triangles_zero_area += now.triangles_zero_area - setup_.triangles_zero_area;
    stats_.triangles_culled += now.triangles_culled - setup_.triangles_culled;
    stats_.triangles_no_sample += now.triangles_no_sample - setup_.triangles_no_sample;
    setup_ = now;
  }

  // The same for the plain stages.
  void add_geometry(std::size_t i) {
    const GeometryStats& plain = plain_[i].stats();
    GeometryStats& fast = geometry_[i];
    geometry_sum_.triangles_in += fast.triangles_in + plain.triangles_in;
    geometry_sum_.dropped_not_finite += fast.dropped_not_finite + plain.dropped_not_finite;
    geometry_sum_.outside += fast.outside + plain.outside;
    geometry_sum_.clipped += fast.clipped + plain.clipped;
    geometry_sum_.triangles_out += fast.triangles_out + plain.triangles_out;
    fast = {};
    plain_[i] = GeometryStage(constants_.frame, constants_.config);
  }

  FrameOptions options_;
  FrameConstants constants_;
  ProjectConstants project_;
  const simd::FrameKernels& kernels_;
  FrameStore store_;
  RasterStats stats_;
  RasterStats setup_;  // already in stats_, of the engines' own counts
  GeometryStats geometry_sum_;
  std::vector<VertexRecord> records_;
  std::size_t projected_ = 0;  // records of the draw that are done
  std::vector<FramePiece> pieces_;
  std::vector<GeometryStage> plain_;     // one per piece
  std::vector<GeometryStats> geometry_;  // of what plain_ did not see
  std::vector<HitPlane> hits_;           // one per piece
  std::vector<PassedTiles> passed_;      // one per thread
  std::vector<FrameCounts> counts_;
};

FrameEngine::FrameEngine(const FrameState& frame, const Config& config, const FrameOptions& options)
    : work_(std::make_unique<Work>(frame, config, options)) {}
FrameEngine::~FrameEngine() = default;

void FrameEngine::clear() { work_->clear(); }
void FrameEngine::draw(std::span<const ShadedTriangle> triangles) { work_->draw(triangles); }

void FrameEngine::draw(std::span<const ClipVertex> vertices,
                       std::span<const TriangleIndices> triangles) {
  VertexSource source;
  source.clip = vertices;
  work_->draw(source, triangles);
}

void FrameEngine::draw(const MeshView& mesh, const glm::dmat4& matrix) {
  HS_CHECK(mesh.positions.size() == mesh.colors.size());
  work_->draw(VertexSource{{}, mesh.positions, mesh.colors, matrix}, mesh.triangles);
}

const FrameStore& FrameEngine::framebuffer() const { return work_->store(); }
const RasterStats& FrameEngine::stats() const { return work_->stats(); }
const GeometryStats& FrameEngine::geometry() const { return work_->geometry(); }
std::vector<std::uint8_t> FrameEngine::hits() const { return work_->hits(); }

}  // namespace halfspace
