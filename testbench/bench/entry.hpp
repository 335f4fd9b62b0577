// SPDX-License-Identifier: Apache-2.0
//
// What the bench times: one engine on one workload.
#pragma once

#include <bit>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "bench.hpp"
#include "framebuffer.hpp"
#include "splitmix.hpp"
#include "workload.hpp"

namespace halfspace {

// Covered tiles as they come, summed so that their order does not matter.
struct MaskSum {
  std::uint64_t samples = 0;
  std::uint64_t tiles = 0;
  std::uint64_t digest = 0;  // of places and masks

  // column, row: of the tile, in tiles.
  void add(std::uint32_t column, std::uint32_t row, std::uint64_t mask) {
    samples += static_cast<std::uint64_t>(std::popcount(mask));
    ++tiles;
    digest += splitmix_mixed(mask + kSplitmixStep * (std::uint64_t{row} << 32 | column));
  }
  bool operator==(const MaskSum&) const = default;
};

// What one run over a workload found. What an engine cannot tell is empty.
struct BenchOutput {
  std::uint64_t samples = 0;
  std::optional<MaskSum> masks;
  std::optional<std::uint64_t> clocks;
  std::optional<Image> picture;
  std::optional<std::vector<std::uint8_t>> hits;  // as HitCount::count()
};

// count is called first, once and untimed, so that what an engine does once (buffers, compiled
// shaders) is done; then run, as often as there are repetitions. The workload must outlive both.
struct BenchEntry {
  BenchRow row;
  std::function<void()> run;
  std::function<BenchOutput()> count;
};

// Which of an engine's instruction sets are wanted.
std::vector<std::string> wanted_isas(const BenchOptions& options,
                                     const std::vector<std::string_view>& there_are);

// What a frame has where nothing is drawn.
inline constexpr Rgb kBenchBackground{24, 26, 33};

// What the plain loop over the bounding box covers, and all others must find.
MaskSum scalar_masks(const Workload& work);

// The engines of level coverage and below: scalar, bit, coverage, cycle.
std::vector<BenchEntry> coverage_entries(const Workload& work, const BenchOptions& options);

// Engines of whole frames, work.mesh drawn with depth test and colour: bit.
std::vector<BenchEntry> frame_entries(const Workload& work, const BenchOptions& options);

// The Verilated RTL; nothing where it cannot be built.
std::vector<BenchEntry> rtl_entries(const Workload& work);
bool has_rtl();
// Builds it if need be. Throws Error(kLevel) where it cannot be built.
void build_bench_rtl();

// Mesa's llvmpipe through OSMesa on the same triangles, or the same mesh; nothing when the library
// does not open. One thread, all of its work in the calling one. Only in a build with OSMesa's
// headers.
std::vector<BenchEntry> llvmpipe_coverage_entries(const Workload& work);
std::vector<BenchEntry> llvmpipe_frame_entries(const Workload& work);
// Empty when the library opens, else why not.
std::string llvmpipe_absent();

}  // namespace halfspace
