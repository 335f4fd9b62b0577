// SPDX-License-Identifier: Apache-2.0
//
// Verilator's class behind rtl_object.h. Compiled with the C++ that Verilator makes of rtl/, prefix
// Vrtl, once a configuration; HS_WAVES: with its FST writer. It knows signals by their names and no
// field of a packet.
#include "rtl_object.h"

#include <verilated.h>
#if HS_WAVES
#include <verilated_fst_c.h>
#endif

#include <algorithm>
#include <memory>
#include <vector>

#include "Vrtl.h"
#include "Vrtl___024root.h"
#include "Vrtl_hs_config_pkg.h"
#include "Vrtl_hs_pkg.h"
#include "ports.hpp"

struct hs_rtl {
  hs_rtl() : top(&context, "rasterizer") {
    context.fatalOnError(false);
    context.traceEverOn(HS_WAVES);
  }

  VerilatedContext context;
  mutable Vrtl top;
#if HS_WAVES
  std::unique_ptr<VerilatedFstC> waves;
#endif
};

namespace {

using Config = Vrtl_hs_config_pkg;
using Package = Vrtl_hs_pkg;

constexpr hs_rtl_constant constant(const char* name, std::int64_t value) { return {name, value}; }

#define HS_CONSTANT(package, name) constant(#name, package::name)
constexpr hs_rtl_constant kConstants[] = {HS_CONSTANT(Config, SUBPIXEL_BITS),
                                          HS_CONSTANT(Config, VIEWPORT_BITS),
                                          HS_CONSTANT(Config, GUARD_BITS),
                                          HS_CONSTANT(Config, EXTENT_BITS),
                                          HS_CONSTANT(Config, SAMPLES),
                                          HS_CONSTANT(Config, GRID_LOG2),
                                          HS_CONSTANT(Config, SETUP_INTERVAL),
                                          HS_CONSTANT(Config, TAG_BITS),
                                          HS_CONSTANT(Package, SAMPLE_POSITION_BITS),
                                          HS_CONSTANT(Package, SAMPLE_BITS),
                                          HS_CONSTANT(Package, POSITION_BITS),
                                          HS_CONSTANT(Package, DROPPED_BITS),
                                          HS_CONSTANT(Package, GRID),
                                          HS_CONSTANT(Package, LANES),
                                          HS_CONSTANT(Package, LEVELS),
                                          HS_CONSTANT(Package, ROOT_LOG2),
                                          HS_CONSTANT(Package, NARROW_EXTENT),
                                          HS_CONSTANT(Package, EXTENT_LOG2),
                                          HS_CONSTANT(Package, VERTEX_BITS),
                                          HS_CONSTANT(Package, DELTA_BITS),
                                          HS_CONSTANT(Package, AREA_BITS),
                                          HS_CONSTANT(Package, CONSTANT_BITS),
                                          HS_CONSTANT(Package, EDGE_FULL_BITS),
                                          HS_CONSTANT(Package, EDGE_BITS),
                                          HS_CONSTANT(Package, NODE_BASE_BITS),
                                          HS_CONSTANT(Package, ROOT_BITS),
                                          HS_CONSTANT(Package, LANE_BITS),
                                          HS_CONSTANT(Package, REACH_BITS),
                                          HS_CONSTANT(Package, INSET_BITS),
                                          HS_CONSTANT(Package, TRAVERSAL_BITS),
                                          {nullptr, 0}};
#undef HS_CONSTANT

// Verilator finds the context through a thread-wide pointer, which another rasterizer's end leaves
// dangling: with two alive the second destructor would wait for ever.
void use(hs_rtl* rtl) { Verilated::threadContextp(&rtl->context); }

void dump([[maybe_unused]] hs_rtl* rtl) {
#if HS_WAVES
  if (rtl->waves) rtl->waves->dump(rtl->context.time());
#endif
}

void set_frame(hs_rtl* rtl, const std::uint32_t* words) {
  halfspace::set_port(rtl->top.frame_i, words);
}

void drive(hs_rtl* rtl, const std::uint32_t* triangle, int ready) {
  Vrtl& top = rtl->top;
  top.valid_i = triangle != nullptr;
  top.ready_i = ready != 0;
  if (triangle != nullptr) halfspace::set_port(top.triangle_i, triangle);
  top.clk_i = 0;
  top.eval();
  dump(rtl);
}

int clock(hs_rtl* rtl) {
  rtl->top.clk_i = 1;
  rtl->top.eval();
  rtl->context.timeInc(1);
  dump(rtl);
  rtl->context.timeInc(1);
  return rtl->context.gotError() || rtl->context.gotFinish();
}

void reset(hs_rtl* rtl, int clocks) {
  use(rtl);
  rtl->top.rst_ni = 0;
  drive(rtl, nullptr, 0);
  for (int i = 0; i < clocks; ++i) clock(rtl);
  rtl->top.rst_ni = 1;
  drive(rtl, nullptr, 0);
}

std::uint64_t fires(const hs_rtl* rtl) {
  const Vrtl& top = rtl->top;
  const Vrtl___024root& root = *top.rootp;
  const std::uint64_t between =
      root.hs_rasterizer__DOT__link_valid & root.hs_rasterizer__DOT__link_ready;
  return static_cast<std::uint64_t>(top.valid_i && top.ready_o) | between << 1 |
         static_cast<std::uint64_t>(top.valid_o && top.ready_i) << (Package::LEVELS + 1);
}

// Bits first .. first + bits - 1 of a long port.
void slice(const std::vector<std::uint32_t>& from, int first, int bits, std::uint32_t* words) {
  for (int done = 0; done < bits; done += 32) {
    const auto at = static_cast<std::size_t>((first + done) / 32);
    const int shift = (first + done) % 32;
    std::uint64_t both = from[at];
    if (at + 1 < from.size()) both |= std::uint64_t{from[at + 1]} << 32;
    const int left = bits - done;
    const std::uint64_t mask = left >= 32 ? 0xFFFFFFFFu : (std::uint64_t{1} << left) - 1;
    words[done / 32] = static_cast<std::uint32_t>(both >> shift & mask);
  }
}

void read(const hs_rtl* rtl, int link, std::uint32_t* words, int count) {
  const Vrtl___024root& root = *rtl->top.rootp;
  std::fill_n(words, count, 0u);
  if (link > 1 && link <= Package::LEVELS) {
    const std::vector<std::uint32_t> all =
        halfspace::port_words(root.hs_rasterizer__DOT__link_node);
    slice(all, (link - 1) * Package::TRAVERSAL_BITS, Package::TRAVERSAL_BITS, words);
    return;
  }
  const std::vector<std::uint32_t> packet =
      link == 1 ? halfspace::port_words(root.hs_rasterizer__DOT__setup)
                : halfspace::port_words(rtl->top.coverage_o);
  std::copy_n(packet.begin(), std::min<std::size_t>(packet.size(), static_cast<std::size_t>(count)),
              words);
}

int busy(const hs_rtl* rtl) { return rtl->top.busy_o; }

void open_waves(hs_rtl* rtl, [[maybe_unused]] const char* path) {
  use(rtl);
#if HS_WAVES
  rtl->waves = std::make_unique<VerilatedFstC>();
  rtl->top.trace(rtl->waves.get(), 99);
  rtl->waves->open(path);
#endif
}

void close_waves([[maybe_unused]] hs_rtl* rtl) {
#if HS_WAVES
  if (rtl->waves) rtl->waves->close();
  rtl->waves.reset();
#endif
}

hs_rtl* create() {
  hs_rtl* rtl = new hs_rtl;
  reset(rtl, 2);
  return rtl;
}

void destroy(hs_rtl* rtl) {
  use(rtl);
  close_waves(rtl);
  rtl->top.final();
  delete rtl;
}

constexpr hs_rtl_object kObject{HS_RTL_OBJECT_VERSION,
                                kConstants,
                                HS_WAVES,
                                create,
                                destroy,
                                reset,
                                set_frame,
                                drive,
                                fires,
                                read,
                                clock,
                                busy,
                                open_waves,
                                close_waves};

}  // namespace

extern "C" __attribute__((visibility("default"))) const hs_rtl_object* halfspace_rtl_object() {
  return &kObject;
}
