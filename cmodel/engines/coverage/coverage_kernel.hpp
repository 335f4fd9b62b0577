// SPDX-License-Identifier: Apache-2.0
//
// Between the engine and the kernels, one of which is compiled per instruction set.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "../../config.hpp"
#include "../../packets.hpp"
#include "coverage_chunk.hpp"

namespace halfspace::simd {

// A Config and a FrameState as the kernels want them; both whole for the scalar kernel. Vertices
// are taken to f = position_bits() fraction bits first; every length below is in 2^-f px, so one
// sample is not special.
struct KernelFrame {
  Config config;
  FrameState state;
  int up = 0;  // f - subpixel_bits
  int f = 8;
  int samples = 1;
  std::int32_t width = 0;  // px
  std::int32_t height = 0;
  Cull cull = Cull::kNone;
  std::int32_t window_extent = 0;   // a larger bounding box takes the double path
  std::int32_t coordinate_min = 0;  // of a legal vertex
  std::int32_t coordinate_max = 0;
  std::array<std::int32_t, kMaxSamples> u{};  // sample positions in a pixel
  std::array<std::int32_t, kMaxSamples> v{};
  std::int32_t u_low = 0, u_high = 0, v_low = 0, v_high = 0;  // their extremes
};

// What setup did with the triangles; added to.
struct KernelCounts {
  std::uint64_t triangles = 0;
  std::uint64_t zero_area = 0;
  std::uint64_t culled = 0;
  std::uint64_t no_sample = 0;
};

// Covers triangles from the first on until the buffer holds `enough` records or none are left.
//
//   first   index of the first triangle, written to buffer.triangle
//   return  triangles consumed
using CoverKernel = std::size_t (*)(const KernelFrame& frame, std::span<const Triangle> triangles,
                                    std::uint32_t first, std::size_t enough, RecordBuffer& buffer,
                                    KernelCounts& counts);

// Tile by tile through CoverageWalk: the readable one, for any machine.
std::size_t cover_scalar(const KernelFrame& frame, std::span<const Triangle> triangles,
                         std::uint32_t first, std::size_t enough, RecordBuffer& buffer,
                         KernelCounts& counts);

struct CoverageKernels {
  std::string_view isa;  // avx3_dl (AVX-512 with VBMI), avx3, avx2, sse4, ssse3, neon, scalar
  CoverKernel cover;
};

// Kernels this machine can run, the best first; never empty.
std::span<const CoverageKernels> coverage_kernels();

}  // namespace halfspace::simd
