// SPDX-License-Identifier: Apache-2.0
//
// Between the frame engine and its kernels, one set of which is compiled per instruction set.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "frame_geometry.hpp"
#include "frame_records.hpp"
#include "frame_store.hpp"

namespace halfspace::simd {

// Which records a kernel takes: `count` from `first` on, or those that `record` lists.
struct RecordOrder {
  const std::uint32_t* record = nullptr;
  std::size_t count = 0;
  std::size_t first = 0;  // without a list

  std::size_t at(std::size_t k) const { return record == nullptr ? first + k : record[k]; }
};

// Depth planes of `count` triangles.
using PlaneKernel = void (*)(const FrameConstants& constants, const FrameTriangle* triangles,
                             std::size_t count, FramePlane* out);

// The greatest of `count` indices, 0 for none.
using HighestKernel = std::uint32_t (*)(const std::uint32_t* index, std::size_t count);

// Depth test of records, in order, against the store. Appends the tiles where a lane passed.
using DepthKernel = void (*)(const FrameConstants& constants, const FrameTiles& tiles,
                             const RecordOrder& order, FrameStore& store, PassedTiles& passed,
                             FrameCounts& counts);

// The same for one sample and tiles that are sorted: all records of a tile, then the next tile. Of
// the lanes that passed in a tile only the last of each pixel stay in `passed`.
using BinKernel = void (*)(const FrameConstants& constants, const BinRange& buckets,
                           FrameStore& store, PassedTiles& passed, FrameCounts& counts);

// Colours of the passed lanes, in order, into the store. `triangles` as PassedTile::triangle.
using ShadeKernel = void (*)(const FrameConstants& constants, const FrameTriangle* triangles,
                             FrameStore& store, PassedTiles& passed);

// Vertices in clip space, projected; `count` of them from `first` on, to out[first] and on. Writes
// whole vectors: up to kVertexSlack records beyond the last.
using ProjectKernel = void (*)(const ProjectConstants& constants, const VertexSource& source,
                               std::size_t first, std::size_t count, VertexRecord* out);

// Parts of the colour kernel, for tests: the planes of `count` triangles, and `count` divisions.
using ShadePlaneKernel = void (*)(const FrameConstants& constants, const FrameTriangle* triangles,
                                  std::size_t count, ShadePlanes* out);
struct Division {
  std::int32_t attribute = 0;    // units
  std::int32_t inverse_w = 0;    // units
  std::uint32_t reciprocal = 0;  // out: of the normalised 1/w
  std::uint32_t value = 0;       // out: perspective()
};
using DivideKernel = void (*)(const FrameConstants& constants, Division* divisions,
                              std::size_t count);

struct FrameKernels {
  std::string_view isa;  // as CoverageKernels
  HighestKernel highest;
  ProjectKernel project;
  PlaneKernel planes;
  DepthKernel depth;
  BinKernel buckets;  // null: there is none
  ShadeKernel shade;
  ShadePlaneKernel shade_planes;
  DivideKernel divide;
};

// The readable ones, for any machine: simd/frame_scalar.cpp.
void project_scalar(const ProjectConstants& constants, const VertexSource& source,
                    std::size_t first, std::size_t count, VertexRecord* out);
std::uint32_t highest_scalar(const std::uint32_t* index, std::size_t count);
void planes_scalar(const FrameConstants& constants, const FrameTriangle* triangles,
                   std::size_t count, FramePlane* out);
void depth_scalar(const FrameConstants& constants, const FrameTiles& tiles,
                  const RecordOrder& order, FrameStore& store, PassedTiles& passed,
                  FrameCounts& counts);
void shade_scalar(const FrameConstants& constants, const FrameTriangle* triangles,
                  FrameStore& store, PassedTiles& passed);

void shade_planes_scalar(const FrameConstants& constants, const FrameTriangle* triangles,
                         std::size_t count, ShadePlanes* out);
void divide_scalar(const FrameConstants& constants, Division* divisions, std::size_t count);

// Kernels this machine can run, the best first; never empty.
std::span<const FrameKernels> frame_kernels();

}  // namespace halfspace::simd
