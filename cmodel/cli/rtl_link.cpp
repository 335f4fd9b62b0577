// SPDX-License-Identifier: Apache-2.0
#include "rtl_link.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>

#include "../io/error.hpp"
#include "cosim.hpp"
#include "rtl_trace.hpp"

namespace halfspace {
namespace {

std::unique_ptr<RtlRasterizer> open_rtl(const Config& config, const std::string& place) {
  if (std::unique_ptr<RtlRasterizer> rtl = make_rtl_rasterizer(config)) return rtl;
  throw Error(ErrorCode::kLevel, place,
              fmt::format("no RTL of this configuration in this build (there are {})",
                          fmt::join(rtl_configurations(), ", ")));
}

}  // namespace

void require_rtl(const Config& config, const std::string& place) { open_rtl(config, place); }

std::uint64_t rasterize_rtl(std::span<const Triangle> triangles, const FrameState& frame,
                            const Config& config,
                            const std::function<void(const CoverageTile&)>& tile) {
  try {
    return run_rtl(*open_rtl(config, "--level"), triangles, frame, {}, tile).clocks;
  } catch (const std::runtime_error& error) {
    throw Error(ErrorCode::kInternal, "rtl", error.what());
  }
}

std::optional<RtlAgreement> compare_with_rtl(std::span<const Triangle> triangles,
                                             const FrameState& frame, const Config& config) {
  const std::unique_ptr<RtlRasterizer> rtl = make_rtl_rasterizer(config);
  if (!rtl) return std::nullopt;
  const CosimResult result = cosim(*rtl, triangles, frame, config, {});
  return RtlAgreement{result.clocks, result.packets_compared,
                      result.mismatch ? result.mismatch->line() : std::string()};
}

TraceLog trace_rtl_level(std::span<const Triangle> triangles, const FrameState& frame,
                         const Config& config) {
  try {
    return trace_rtl(*open_rtl(config, "--trace"), triangles, frame, {});
  } catch (const Error&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw Error(ErrorCode::kInternal, "rtl", error.what());
  }
}

}  // namespace halfspace
