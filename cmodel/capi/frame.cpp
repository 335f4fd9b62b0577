// SPDX-License-Identifier: Apache-2.0
#include "frame.hpp"

#include <algorithm>

#include "boundary.hpp"

namespace halfspace::capi {
namespace {

constexpr std::uint32_t kAllOutputs = HS_TILES | HS_FRAGMENTS | HS_PICTURE | HS_CLOCKS | HS_COUNTS;

FrameState checked(const hs_frame& request, const Config& config) {
  const int max = config.max_size();
  if (request.width < 1 || request.height < 1 || request.width > max || request.height > max) {
    throw Refusal(HS_ERROR_RANGE, "frame of " + std::to_string(request.width) + " x " +
                                      std::to_string(request.height) + " px: each is 1.." +
                                      std::to_string(max) + " in this configuration");
  }
  require(request.cull >= HS_CULL_NONE && request.cull <= HS_CULL_FRONT, HS_ERROR_RANGE,
          "cull is not one of HS_CULL_*");
  require(request.depth_function >= HS_DEPTH_LESS && request.depth_function <= HS_DEPTH_NOT_EQUAL,
          HS_ERROR_RANGE, "depth_function is not one of HS_DEPTH_*");
  require((request.flags & ~std::uint32_t{HS_DEPTH_CLEAR | HS_SCISSOR}) == 0, HS_ERROR_RANGE,
          "flags has an unknown bit");
  require((request.outputs & ~kAllOutputs) == 0, HS_ERROR_RANGE, "outputs has an unknown bit");
  require(request.reserved == 0, HS_ERROR_ARGUMENT, "frame->reserved is not 0");
  require(request.stall_probability >= 0 && request.stall_probability < 1, HS_ERROR_RANGE,
          "stall_probability is not in 0 <= p < 1");
  return {request.width, request.height, static_cast<Cull>(request.cull)};
}

DepthState depth_state(const hs_frame& request, const Config& config) {
  const auto function = static_cast<DepthFunction>(request.depth_function);
  if ((request.flags & HS_DEPTH_CLEAR) == 0) return {function};
  if (request.depth_clear > config.depth_max()) {
    throw Refusal(HS_ERROR_RANGE, "depth_clear = " + std::to_string(request.depth_clear) +
                                      " is out of range (0.." + std::to_string(config.depth_max()) +
                                      ")");
  }
  return {function, request.depth_clear};
}

std::optional<Box> scissor_box(const hs_frame& request) {
  if ((request.flags & HS_SCISSOR) == 0) return {};
  const auto& [x, y, width, height] = request.scissor;
  require(x >= 0 && y >= 0 && width >= 1 && height >= 1 && width <= request.width - x &&
              height <= request.height - y,
          HS_ERROR_RANGE, "scissor is not in the frame");
  return Box{x, y, x + width - 1, y + height - 1};
}

hs_fragment to_c(const Fragment& fragment) {
  hs_fragment out{};
  out.x = fragment.x;
  out.y = fragment.y;
  out.tag = fragment.tag;
  out.covered = fragment.covered;
  out.passed = fragment.passed;
  std::copy(fragment.color.begin(), fragment.color.end(), out.color);
  std::copy(fragment.depth.begin(), fragment.depth.end(), out.depth);
  return out;
}

}  // namespace

// What the cycle engine tells; triangles[0] has number `number`. Setup packets cost time, so they
// are made only where something is done with them.
template <bool kSetup>
struct Frame::Listener {
  static constexpr bool kWantsSetup = kSetup;
  static constexpr bool kWantsNodes = false;

  Frame& frame;
  std::span<const ShadedTriangle> triangles;
  std::size_t seen = 0;

  void accepted(std::uint64_t clock) {
    ++seen;
    ++frame.triangles_;
    if (frame.keeps(HS_CLOCKS)) frame.clocks_.push_back({clock, HS_NEVER});
  }
  void setup(std::uint64_t clock, const SetupTriangle& packet) {
    if (frame.keeps(HS_CLOCKS)) frame.clocks_.back().setup = clock;
    if (frame.rasterizer_) frame.rasterizer_->begin(triangles[seen - 1], packet);
  }
  void node(int, std::uint64_t, const Node&) {}
  void tile(std::uint64_t clock, const CoverageTile& packet) { frame.take(clock, packet); }
};

Frame::Frame(const hs_frame& request, const Config& config)
    : request_(request),
      config_(config),
      state_(checked(request, config)),
      outputs_(request.outputs == 0 ? std::uint32_t{HS_TILES} : request.outputs),
      engine_(state_, config, Stalls(request.stall_probability, request.stall_seed)) {
  const DepthState depth = depth_state(request, config);
  const std::optional<Box> scissor = scissor_box(request);
  if (!keeps(HS_FRAGMENTS | HS_PICTURE)) {
    hits_.emplace(state_.width, state_.height);
    return;
  }
  const auto& b = request.background;
  rasterizer_ = std::make_unique<Rasterizer>(state_, config, depth, Rgb{b[0], b[1], b[2]}, scissor);
  if (keeps(HS_FRAGMENTS)) {
    rasterizer_->on_fragment(
        [this](const Fragment& fragment) { fragments_.push_back(to_c(fragment)); });
  }
}

void check_extent(const Triangle& triangle, const Config& config) {
  if (within_extent(triangle, config)) return;
  throw Refusal(HS_ERROR_RANGE, "an edge is longer than extent_bits = " +
                                    std::to_string(config.extent_bits) + " allows");
}

void Frame::draw(std::span<const ShadedTriangle> triangles) {
  std::vector<Triangle> positions;
  positions.reserve(triangles.size());
  for (const ShadedTriangle& triangle : triangles) positions.push_back(triangle.triangle);
  const std::span<const Triangle> all(positions);
  if (rasterizer_ || keeps(HS_CLOCKS)) {
    engine_.draw(all, Listener<true>{*this, triangles});
  } else {
    engine_.draw(all, Listener<false>{*this, triangles});
  }
}

void Frame::draw_clip(const std::array<ClipVertex, 3>& triangle, std::uint32_t tag) {
  pieces_.clear();
  GeometryStage geometry(state_,
                         config_);  // its counts are those of a triangle that may be refused
  geometry.process(triangle, tag, pieces_);
  if (config_.extent_bits != 0) {
    if (geometry.stats().beyond_sides != 0) {
      throw Refusal(HS_ERROR_RANGE, "the triangle is cut at a side: extent_bits allows none");
    }
    for (const ShadedTriangle& piece : pieces_) check_extent(piece.triangle, config_);
  }
  draw(pieces_);
  count_in(geometry.stats());
}

void Frame::count_in(const GeometryStats& stats) {
  counted_.triangles_in += stats.triangles_in;
  counted_.dropped_not_finite += stats.dropped_not_finite;
  counted_.outside += stats.outside;
  counted_.clipped += stats.clipped;
}

void Frame::take(std::uint64_t clock, const CoverageTile& tile) {
  if (rasterizer_) {
    rasterizer_->draw_tile(tile);
  } else {
    hits_->add(tile, config_);
  }
  if (!keeps(HS_TILES)) return;
  hs_tile out{};
  out.x = tile.x;
  out.y = tile.y;
  out.tag = tile.tag;
  out.samples = static_cast<std::uint32_t>(config_.samples);
  out.clock = clock;
  out.triangle = triangles_ - 1;
  std::copy(tile.mask.begin(), tile.mask.end(), out.mask);
  tiles_.push_back(out);
}

const std::vector<std::uint8_t>& Frame::hits() const {
  return rasterizer_ ? rasterizer_->hit_count().count() : hits_->count();
}

hs_stats Frame::stats() const {
  const RasterStats& raster = engine_.stats();
  hs_stats out{};
  out.triangles_in = counted_.triangles_in;
  out.triangles_not_finite = counted_.dropped_not_finite;
  out.triangles_outside = counted_.outside;
  out.triangles_clipped = counted_.clipped;
  out.triangles = raster.triangles;
  out.triangles_zero_area = raster.triangles_zero_area;
  out.triangles_culled = raster.triangles_culled;
  out.triangles_no_sample = raster.triangles_no_sample;
  out.tiles_visited = raster.tiles_visited;
  out.tiles_covered = raster.tiles_covered;
  out.samples_tested = raster.samples_tested;
  out.samples_covered = raster.samples_covered;
  out.fragments = raster.fragments;
  out.fragments_shaded = rasterizer_ ? rasterizer_->stats().fragments_shaded : 0;
  out.cycles = engine_.clocks();
  return out;
}

}  // namespace halfspace::capi
