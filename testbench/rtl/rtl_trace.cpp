// SPDX-License-Identifier: Apache-2.0
#include "rtl_trace.hpp"

#include <stdexcept>

#include "vectors/packets_of.hpp"

namespace halfspace {

void record_handshakes(const RtlRasterizer& rtl, std::uint64_t clock, TraceLog& log) {
  if (rtl.fires(kLinkAccept)) log.accepted(clock);
  if (rtl.fires(kLinkSetup)) {
    log.setup(clock, setup_of(rtl.packet(kLinkSetup)).tag);
  }
  for (int level = 1; level < log.config().levels(); ++level) {
    if (!rtl.fires(link_into(level))) continue;
    const NodeOfTriangle packet = node_of(rtl.packet(link_into(level)));
    log.node(level, clock, packet.setup.tag, packet.node);
  }
  if (rtl.fires(kLinkTile)) {
    const CoverageTile tile = rtl.coverage();
    log.tile(clock, tile.tag, tile);
  }
}

TraceLog trace_rtl(RtlRasterizer& rtl, std::span<const Triangle> triangles, const FrameState& frame,
                   const Stalls& stalls) {
  TraceLog log(rtl.config(), stalls);
  rtl.reset(2);
  rtl.set_frame(frame);
  const std::uint64_t tags = (std::uint64_t{1} << rtl.config().tag_bits) - 1;
  std::uint64_t next = 0;
  std::uint64_t offer = stalls.gap(0);
  std::uint64_t still = 0;  // clocks without a handshake
  for (std::uint64_t clock = 0; next < triangles.size() || rtl.busy(); ++clock) {
    const bool offered = next < triangles.size() && clock >= offer;
    Triangle triangle;
    if (offered) {
      triangle = triangles[next];
      triangle.tag = static_cast<std::uint32_t>(next & tags);
    }
    rtl.drive(offered ? &triangle : nullptr, stalls.ready(clock));
    record_handshakes(rtl, clock, log);
    if (rtl.fires(kLinkAccept)) offer = clock + 1 + stalls.gap(++next);
    still = rtl.fires(kLinkAccept) || rtl.fires(kLinkTile) ? 0 : still + 1;
    if (still > 100000) throw std::runtime_error("the RTL does not move any more");
    rtl.clock();
  }
  return log;
}

}  // namespace halfspace
