// SPDX-License-Identifier: Apache-2.0
#include "rtl_link.hpp"

#include <stdexcept>

#include "io/error.hpp"
#include "rtl/cosim.hpp"
#include "rtl/rtl_build.hpp"
#include "rtl/rtl_trace.hpp"

namespace halfspace {
namespace {

// An RTL that stops or fails an assertion is a bug, whatever it was asked to do.
template <class Run>
auto guarded(Run run) {
  try {
    return run();
  } catch (const Error&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw Error(ErrorCode::kInternal, "rtl", error.what());
  }
}

}  // namespace

void require_rtl(const Config& config, const std::string& place) {
  rtl_object_file(config, false, place);
}

std::uint64_t rasterize_rtl(std::span<const Triangle> triangles, const FrameState& frame,
                            const Config& config,
                            const std::function<void(const CoverageTile&)>& tile) {
  return guarded([&] {
    RtlRasterizer rtl(config, false, "--level");
    return run_rtl(rtl, triangles, frame, {}, tile).clocks;
  });
}

std::optional<RtlAgreement> compare_with_rtl(std::span<const Triangle> triangles,
                                             const FrameState& frame, const Config& config) {
  if (!rtl_tools_missing().empty()) return std::nullopt;
  RtlRasterizer rtl(config, false, "--level");
  const CosimResult result = cosim(rtl, triangles, frame, config, {});
  return RtlAgreement{result.clocks, result.packets_compared,
                      result.mismatch ? result.mismatch->line() : std::string()};
}

TraceLog trace_rtl_level(std::span<const Triangle> triangles, const FrameState& frame,
                         const Config& config) {
  return guarded([&] {
    RtlRasterizer rtl(config, false, "--trace");
    return trace_rtl(rtl, triangles, frame, {});
  });
}

}  // namespace halfspace
