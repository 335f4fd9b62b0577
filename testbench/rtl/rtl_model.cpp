// SPDX-License-Identifier: Apache-2.0
//
// One RTL configuration behind RtlRasterizer. Compiled once per configuration with
//   HS_NAME     its name, an identifier
//   HS_PREFIX   Verilator's class
//   HS_HEADER, HS_ROOT_HEADER, HS_CONFIG_HEADER, HS_PKG_HEADER   its headers
//   HS_CONFIG   the C++ Config it must equal
#include <verilated.h>
#include <verilated_fst_c.h>

#include HS_HEADER
#include HS_ROOT_HEADER
#include HS_CONFIG_HEADER
#include HS_PKG_HEADER

#include <array>
#include <cstring>
#include <stdexcept>

#include "bits.hpp"
#include "ports.hpp"
#include "rtl_configs.hpp"
#include "rtl_extra.hpp"
#include "rtl_rasterizer.hpp"

#define HS_JOIN2(a, b) a##b
#define HS_JOIN(a, b) HS_JOIN2(a, b)

namespace halfspace {
namespace {

constexpr Config kConfig = HS_CONFIG;

// Drift between the two languages stops the build here.
using RtlConfig = HS_JOIN(HS_PREFIX, _hs_config_pkg);
using Rtl = HS_JOIN(HS_PREFIX, _hs_pkg);
static_assert(RtlConfig::SUBPIXEL_BITS == kConfig.subpixel_bits);
static_assert(RtlConfig::VIEWPORT_BITS == kConfig.viewport_bits);
static_assert(RtlConfig::GUARD_BITS == kConfig.guard_bits);
static_assert(RtlConfig::EXTENT_BITS == kConfig.extent_bits);
static_assert(RtlConfig::SAMPLES == kConfig.samples);
static_assert(RtlConfig::GRID_LOG2 == kConfig.grid_log2);
static_assert(RtlConfig::SETUP_INTERVAL == kConfig.setup_interval);
static_assert(RtlConfig::TAG_BITS == kConfig.tag_bits);
static_assert(Rtl::SAMPLE_POSITION_BITS == kConfig.sample_position_bits());
static_assert(Rtl::SAMPLE_BITS == kConfig.sample_bits());
static_assert(Rtl::POSITION_BITS == kConfig.position_bits());
static_assert(Rtl::DROPPED_BITS == kConfig.dropped_bits());
static_assert(Rtl::GRID == kConfig.grid());
static_assert(Rtl::LANES == kConfig.lanes());
static_assert(Rtl::LEVELS == kConfig.levels());
static_assert(Rtl::ROOT_LOG2 == kConfig.node_log2(0));
static_assert(Rtl::NARROW_EXTENT == kConfig.narrow_extent());
static_assert(Rtl::EXTENT_LOG2 == kConfig.extent_log2());
static_assert(Rtl::VERTEX_BITS == kConfig.vertex_bits());
static_assert(Rtl::DELTA_BITS == kConfig.delta_bits());
static_assert(Rtl::AREA_BITS == kConfig.area_bits());
static_assert(Rtl::CONSTANT_BITS == kConfig.constant_bits());
static_assert(Rtl::EDGE_FULL_BITS == kConfig.edge_full_bits());
static_assert(Rtl::EDGE_BITS == kConfig.edge_bits());
static_assert(Rtl::NODE_BASE_BITS == kConfig.node_bits(0));
static_assert(Rtl::ROOT_BITS == kConfig.node_bits(kConfig.node_log2(0)));
static_assert(Rtl::LANE_BITS == kConfig.lane_bits());

constexpr int kN = kConfig.viewport_bits;
constexpr int kTag = kConfig.tag_bits;
constexpr int kDelta = kConfig.delta_bits();
constexpr int kRoot = kConfig.node_bits(kConfig.node_log2(0));
constexpr int kCorners = 3 * (Rtl::REACH_BITS + Rtl::INSET_BITS);
constexpr int kTriangleBits = 6 * kConfig.vertex_bits() + kTag;
constexpr int kSetupBits = 6 * kDelta + 3 * kRoot + 4 * kN + 1 + kTag + kCorners;
constexpr int kNodeBits = 2 * kN + 3 * kRoot + 6 * kDelta + 4 * kN + kTag + kCorners;
constexpr int kCoverageBits = 2 * kN + kConfig.samples * kConfig.lanes() + kTag;

class Model final : public RtlRasterizer {
 public:
  Model() : top_(&context_, "rasterizer") {
    context_.fatalOnError(false);
    context_.traceEverOn(true);
    reset(2);
  }
  ~Model() override {
    use_context();
    close_trace();
    top_.final();
  }

  const Config& config() const override { return kConfig; }

  void reset(int clocks) override {
    use_context();
    top_.rst_ni = 0;
    drive(nullptr, false);
    for (int i = 0; i < clocks; ++i) clock();
    top_.rst_ni = 1;
    drive(nullptr, false);
  }

  void set_frame(const FrameState& frame) override {
    BitWriter bits(2 * (kN + 1) + 2);
    bits.put(frame.width, kN + 1);
    bits.put(frame.height, kN + 1);
    bits.put(static_cast<int>(frame.cull), 2);
    set_port(top_.frame_i, bits.words());
  }

  void drive(const Triangle* triangle, bool ready) override {
    top_.valid_i = triangle != nullptr;
    top_.ready_i = ready;
    if (triangle != nullptr) {
      BitWriter bits(kTriangleBits);
      for (const Point p : triangle->vertex) {
        bits.put(p.x, kConfig.vertex_bits());
        bits.put(p.y, kConfig.vertex_bits());
      }
      bits.put(triangle->tag, kTag);
      set_port(top_.triangle_i, bits.words());
    }
    top_.clk_i = 0;
    top_.eval();
    dump();
  }

  bool fires(int link) const override {
    if (link == kLinkAccept) return top_.valid_i && top_.ready_o;
    if (link == link_output(kConfig)) return top_.valid_o && top_.ready_i;
    const int level = link - 1;
    return (root().hs_rasterizer__DOT__link_valid >> level & 1) != 0 &&
           (root().hs_rasterizer__DOT__link_ready >> level & 1) != 0;
  }

  SetupTriangle setup() const override {
    const auto& port = root().hs_rasterizer__DOT__setup;
    const std::vector<std::uint32_t> words = port_words(port);
    BitReader bits(words.data(), kSetupBits);
    SetupTriangle out;
    for (EdgeSlope& slope : out.slope) {
      slope.a = static_cast<std::int32_t>(bits.signed_bits(kDelta));
      slope.b = static_cast<std::int32_t>(bits.signed_bits(kDelta));
    }
    for (std::int64_t& e : out.e) e = bits.signed_bits(kRoot);
    out.box.x_first = static_cast<std::int32_t>(bits.unsigned_bits(kN));
    out.box.y_first = static_cast<std::int32_t>(bits.unsigned_bits(kN));
    out.box.x_last = static_cast<std::int32_t>(bits.unsigned_bits(kN));
    out.box.y_last = static_cast<std::int32_t>(bits.unsigned_bits(kN));
    out.flipped = bits.unsigned_bits(1) != 0;
    out.tag = static_cast<std::uint32_t>(bits.unsigned_bits(kTag));
    return out;
  }

  Node node(int level) const override {
    const std::vector<std::uint32_t> words = link_words(level);
    BitReader bits(words.data(), kNodeBits);
    Node out;
    out.x = static_cast<std::int32_t>(bits.unsigned_bits(kN));
    out.y = static_cast<std::int32_t>(bits.unsigned_bits(kN));
    for (std::int64_t& e : out.e) e = bits.signed_bits(kRoot);
    return out;
  }

  std::uint32_t node_tag(int level) const override {
    const std::vector<std::uint32_t> words = link_words(level);
    BitReader bits(words.data(), kNodeBits);
    bits.skip(kNodeBits - kCorners - kTag);
    return static_cast<std::uint32_t>(bits.unsigned_bits(kTag));
  }

  CoverageTile coverage() const override {
    const std::vector<std::uint32_t> words = port_words(top_.coverage_o);
    BitReader bits(words.data(), kCoverageBits);
    CoverageTile out;
    out.x = static_cast<std::int32_t>(bits.unsigned_bits(kN));
    out.y = static_cast<std::int32_t>(bits.unsigned_bits(kN));
    for (int m = kConfig.samples - 1; m >= 0; --m) {
      out.mask[static_cast<std::size_t>(m)] = bits.unsigned_bits(kConfig.lanes());
    }
    out.tag = static_cast<std::uint32_t>(bits.unsigned_bits(kTag));
    return out;
  }

  void clock() override {
    top_.clk_i = 1;
    top_.eval();
    context_.timeInc(1);
    dump();
    context_.timeInc(1);
    if (context_.gotError() || context_.gotFinish()) {
      throw std::runtime_error("an assertion in the RTL failed");
    }
  }

  bool busy() const override { return top_.busy_o != 0; }

  void open_trace(const std::string& path) override {
    use_context();
    trace_ = std::make_unique<VerilatedFstC>();
    top_.trace(trace_.get(), 99);
    trace_->open(path.c_str());
  }
  void close_trace() override {
    if (trace_) trace_->close();
    trace_.reset();
  }

 private:
  // Verilator finds the context through a thread-wide pointer, which another model's end leaves
  // dangling: with two models alive the second destructor would wait for ever.
  void use_context() { Verilated::threadContextp(&context_); }

  const HS_JOIN(HS_PREFIX, ___024root) & root() const { return *top_.rootp; }

  // The node that waits at level `level`, cut out of the concatenation of all of them.
  std::vector<std::uint32_t> link_words(int level) const {
    const auto& port = root().hs_rasterizer__DOT__link_node;
    const std::vector<std::uint32_t> all = port_words(port);
    std::vector<std::uint32_t> out(static_cast<std::size_t>((kNodeBits + 31) / 32) + 1);
    const int first = level * kNodeBits;
    for (int done = 0; done < kNodeBits; done += 32) {
      const int bits = std::min(32, kNodeBits - done);
      BitReader reader(all.data(), first + done + bits);
      out[static_cast<std::size_t>(done / 32)] =
          static_cast<std::uint32_t>(reader.unsigned_bits(bits));
    }
    return out;
  }

  void dump() {
    if (trace_) trace_->dump(context_.time());
  }

  VerilatedContext context_;
  mutable HS_PREFIX top_;
  std::unique_ptr<VerilatedFstC> trace_;
};

}  // namespace

std::unique_ptr<RtlRasterizer> HS_JOIN(make_rtl_, HS_NAME)() { return std::make_unique<Model>(); }

}  // namespace halfspace
