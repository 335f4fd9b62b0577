// SPDX-License-Identifier: Apache-2.0
#include "../io/error.hpp"
#include "command.hpp"
#include "rtl_link.hpp"

namespace halfspace {

void require_rtl(const Config&, const std::string& place) {
  throw Error(ErrorCode::kLevel, place, "this build has no RTL (configure with HALFSPACE_RTL=ON)");
}

std::uint64_t rasterize_rtl(std::span<const Triangle>, const FrameState&, const Config& config,
                            const std::function<void(const CoverageTile&)>&) {
  require_rtl(config, "--level");
  return 0;
}

std::optional<RtlAgreement> compare_with_rtl(std::span<const Triangle>, const FrameState&,
                                             const Config&) {
  return std::nullopt;
}

TraceLog trace_rtl_level(std::span<const Triangle>, const FrameState&, const Config& config) {
  require_rtl(config, "--trace");
  return TraceLog(config, Stalls());
}

int run_cosim(const CosimRequest& request) {
  require_rtl(request.config.load(), "cosim");
  return 1;
}

}  // namespace halfspace
