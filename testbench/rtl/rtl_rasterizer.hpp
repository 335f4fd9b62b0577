// SPDX-License-Identifier: Apache-2.0
//
// The Verilated rasterizer of any legal configuration: packets in and out, one clock at a time.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "config.hpp"
#include "io/error.hpp"
#include "link.hpp"
#include "packets.hpp"
#include "rtl_object.h"
#include "vectors/layout.hpp"

namespace halfspace {

// A width or count that the RTL was elaborated with is not the model's.
class RtlDrift : public Error {
 public:
  RtlDrift(const std::string& name, std::int64_t model, std::int64_t rtl);
  // "stage=configuration field=NAME model=VALUE rtl=VALUE"
  const std::string& line() const { return line_; }

 private:
  std::string line_;
};

class RtlRasterizer {
 public:
  // Builds the RTL if need be (rtl_build.hpp, whose errors it throws; place is for them). waves:
  // open_trace() works. Throws RtlDrift.
  RtlRasterizer(const Config& config, bool waves, const std::string& place);
  ~RtlRasterizer();
  RtlRasterizer(const RtlRasterizer&) = delete;
  RtlRasterizer& operator=(const RtlRasterizer&) = delete;

  const Config& config() const { return config_; }

  // Holds reset for `clocks` clocks; everything inside is lost, the clock count starts again.
  void reset(int clocks);
  // Stable while busy().
  void set_frame(const FrameState& frame);

  // Inputs of the coming clock edge: a triangle (null: none) and whether a tile can be taken.
  void drive(const Triangle* triangle, bool ready);

  // After drive(): whether a packet changes hands at the coming edge, and which: the values of
  // link_layout(link).
  bool fires(Link link) const { return (fires_ >> index_of(link, config_) & 1) != 0; }
  Values packet(Link link) const;
  CoverageTile coverage() const;  // the packet of kLinkTile

  // The edge. Throws std::runtime_error when an assertion in the RTL fired.
  void clock();
  bool busy() const { return object_->busy(rtl_) != 0; }

  // Waves from now on into an FST file, until close or destruction.
  void open_trace(const std::string& path) { object_->open_waves(rtl_, path.c_str()); }
  void close_trace() { object_->close_waves(rtl_); }

 private:
  Config config_;
  Layout frame_layout_;
  Layout triangle_layout_;
  std::vector<Layout> layouts_;  // by index_of(link)
  const hs_rtl_object* object_;
  hs_rtl* rtl_ = nullptr;
  std::uint64_t fires_ = 0;
};

}  // namespace halfspace
