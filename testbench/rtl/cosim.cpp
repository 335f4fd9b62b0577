// SPDX-License-Identifier: Apache-2.0
#include "cosim.hpp"

#include <fmt/format.h>

#include <chrono>
#include <stdexcept>

#include "expectation.hpp"
#include "scoreboard.hpp"
#include "triangle_source.hpp"

namespace halfspace {
namespace {

using WallClock = std::chrono::steady_clock;

double seconds_since(WallClock::time_point start) {
  return std::chrono::duration<double>(WallClock::now() - start).count();
}

std::vector<Triangle> tagged(std::span<const Triangle> triangles) {
  std::vector<Triangle> out(triangles.begin(), triangles.end());
  for (std::size_t i = 0; i < out.size(); ++i) out[i].tag = static_cast<std::uint32_t>(i);
  return out;
}

// After a difference: on to the end of the waves asked for, comparing no more.
void wave_on(RtlRasterizer& rtl, TriangleSource& source, const CosimOptions& options, bool tracing,
             std::uint64_t clock) {
  if (!tracing || options.trace_to == UINT64_MAX) return;
  try {
    for (; clock < options.trace_to; ++clock) {
      if (rtl.fires(kLinkAccept)) source.accepted(clock);
      rtl.clock();
      rtl.drive(source.at(clock + 1), options.stalls.ready(clock + 1));
    }
  } catch (const std::runtime_error&) {  // an assertion: the waves end there
  }
}

}  // namespace

std::string Mismatch::line() const {
  return fmt::format(
      "mismatch: stage={} packet={} clock={} triangle={} tile=({},{}) field={} model={} rtl={}",
      stage, packet, clock, triangle, x, y, field, model, rtl);
}

CosimResult cosim(RtlRasterizer& rtl, std::span<const Triangle> triangles, const FrameState& frame,
                  const Config& config, const CosimOptions& options) {
  CosimResult result;
  const std::vector<Triangle> stream = tagged(triangles);
  Expectation expected(stream, frame, config, options.stalls);
  rtl.reset(2);
  rtl.set_frame(frame);
  TriangleSource source(stream, options.stalls, config.tag_bits);
  Scoreboard scoreboard(rtl, expected, config, result);
  const WallClock::time_point start = WallClock::now();
  std::uint64_t clock = 0;
  bool tracing = false;
  for (; !scoreboard.finished(); ++clock) {
    if (!options.trace.empty() && clock == options.trace_from) {
      rtl.open_trace(options.trace);
      tracing = true;
    }
    rtl.drive(source.at(clock), options.stalls.ready(clock));
    if (!scoreboard.check(clock)) {
      wave_on(rtl, source, options, tracing, clock);
      break;
    }
    if (rtl.fires(kLinkAccept)) {
      source.accepted(clock);
      if (options.progress) options.progress(source.count());
    }
    try {
      rtl.clock();
    } catch (const std::runtime_error& error) {
      result.mismatch =
          Mismatch{"assertion", 0, clock, source.count(), 0, 0, "rtl", "no failure", error.what()};
      break;
    }
    if (tracing && clock == options.trace_to) {
      rtl.close_trace();
      tracing = false;
    }
  }
  result.clocks = clock;
  // Nothing may come after the last packet either.
  for (int i = 0; i < 64 && !result.mismatch; ++i, ++clock) {
    rtl.drive(nullptr, true);
    if (scoreboard.check(clock)) rtl.clock();
  }
  if (!result.mismatch && rtl.busy()) {
    result.mismatch =
        Mismatch{"rasterizer", 0, clock, source.count(), 0, 0, "busy_o", "empty", "busy"};
  }
  rtl.close_trace();
  result.stats = expected.stats();
  result.model_seconds = expected.seconds();
  result.rtl_seconds = seconds_since(start) - result.model_seconds;
  return result;
}

RtlRun run_rtl(RtlRasterizer& rtl, std::span<const Triangle> triangles, const FrameState& frame,
               const Stalls& stalls, const std::function<void(const CoverageTile&)>& tile) {
  rtl.reset(2);
  rtl.set_frame(frame);
  const Config& config = rtl.config();
  TriangleSource source(triangles, stalls, config.tag_bits);
  const WallClock::time_point start = WallClock::now();
  RtlRun run;
  std::uint64_t moved = 0;
  for (std::uint64_t clock = 0;; ++clock) {
    rtl.drive(source.at(clock), stalls.ready(clock));
    if (rtl.fires(kLinkTile)) {
      tile(rtl.coverage());
      run.clocks = clock + 1;
      moved = clock;
    }
    if (rtl.fires(kLinkAccept)) {
      source.accepted(clock);
      run.clocks = clock + 1;
      moved = clock;
    }
    rtl.clock();
    if (source.done() && !rtl.busy()) break;
    if (clock - moved > 100000) throw std::runtime_error("the RTL does not move any more");
  }
  run.seconds = seconds_since(start);
  return run;
}

CosimResult cosim_with_resets(RtlRasterizer& rtl, std::span<const Triangle> triangles,
                              const FrameState& frame, const Config& config,
                              const CosimOptions& options, int resets) {
  for (int i = 0; i < resets; ++i) {
    rtl.reset(1 + i % 3);
    rtl.set_frame(frame);
    TriangleSource source(triangles, options.stalls, config.tag_bits);
    // Somewhere in the middle of things, a different place each time.
    const std::uint64_t strike = 7 + 23 * static_cast<std::uint64_t>(i);
    for (std::uint64_t clock = 0; clock < strike; ++clock) {
      rtl.drive(source.at(clock), options.stalls.ready(clock));
      if (rtl.fires(kLinkAccept)) source.accepted(clock);
      rtl.clock();
    }
  }
  return cosim(rtl, triangles, frame, config, options);
}

}  // namespace halfspace
