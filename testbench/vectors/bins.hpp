// SPDX-License-Identifier: Apache-2.0
//
// The functional coverage model: what a set of triangles must contain before it may be called a
// test of a rasterizer. Each bin, and why some cannot be hit: docs/04_develop/bins.md.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "config.hpp"
#include "packets.hpp"

namespace halfspace {

struct Bin {
  std::string name;    // "tie.edge.NNE"
  std::string reason;  // why no legal triangle hits it; empty when one does
};

// Some of a model's bins.
class BinSet {
 public:
  explicit BinSet(std::size_t bins = 0) : words_((bins + 63) / 64) {}
  void add(std::size_t bin) { words_[bin / 64] |= std::uint64_t{1} << (bin % 64); }
  bool has(std::size_t bin) const { return (words_[bin / 64] >> (bin % 64) & 1u) != 0; }
  void add(const BinSet& other);
  std::size_t count() const;
  void remove(std::size_t bin) { words_[bin / 64] &= ~(std::uint64_t{1} << (bin % 64)); }
  // Bins of both sets.
  std::size_t count_common(const BinSet& other) const;

 private:
  std::vector<std::uint64_t> words_;
};

// The bins of one configuration.
class BinModel {
 public:
  explicit BinModel(const Config& config);

  const Config& config() const { return config_; }
  const std::vector<Bin>& bins() const { return bins_; }
  std::size_t reachable() const;
  BinSet none() const { return BinSet(bins_.size()); }

  // Adds what triangles, submitted one after the other, hit. Most bins ask that the case decides a
  // covered sample: a fault there can be seen. Shared edges are those of neighbours in the order.
  // Cost: every sample of every leaf tile visited.
  void sample(const FrameState& frame, std::span<const Triangle> triangles, BinSet& hits) const;

  // First bins of the groups; the rest of a group follows in the order of its labels.
  struct Groups {
    std::size_t cull = 0;        // none.cw none.ccw back.cw back.ccw front.cw front.ccw
    std::size_t outside = 0;     // left right top bottom
    std::size_t between = 0;     // x y
    std::size_t degenerate = 0;  // equal_012 equal_01 equal_12 equal_20 row column diagonal oblique
    std::size_t area_one = 0;
    std::size_t edge = 0;        // edge 0..2 x direction 0..15
    std::size_t cut = 0;         // the same
    std::size_t tie_edge = 0;    // direction 0..15
    std::size_t tie_vertex = 0;  // vertex 0..2 x owned, lost
    std::size_t tie_shared = 0;  // direction 0..7
    std::size_t mask = 0;        // per sample: lanes, rows, columns, full
    std::size_t mask_empty = 0;
    std::size_t mask_lacks = 0;   // lanes
    std::size_t pixel_alone = 0;  // samples; none for one sample
    std::size_t pixel_count = 0;  // 1..samples
    std::size_t phase = 0;        // x class x y class
    std::size_t box = 0;          // x_first y_first x_last y_last x 0..grid - 1
    std::size_t box_cut = 0;      // left right top bottom
    std::size_t box_thin = 0;     // one column, one row
    std::size_t frame = 0;     // width_one width_most width_odd height_one height_most height_odd
    std::size_t split = 0;     // level 0.., never
    std::size_t child = 0;     // level x lane
    std::size_t reject = 0;    // the same
    std::size_t dead = 0;      // level
    std::size_t all = 0;       // the level above the leaf
    std::size_t saturate = 0;  // level 0.. x edge
    std::size_t slope = 0;     // a.max a.min b.max b.min
    std::size_t area = 0;      // cw ccw
    std::size_t area_bit = 0;  // first_area_bit .. last_area_bit
    std::size_t vertex = 0;    // vertex x (x.min x.max y.min y.max)
    std::size_t corner = 0;    // nw ne sw se: a vertex there
    std::size_t corners = 0;   // three of them: all but nw, ne, sw, se
  };
  const Groups& groups() const { return groups_; }
  // Sub-pixel phases that are told apart: 0, 1, and around 1/2 and 1.
  const std::vector<int>& phases() const { return phases_; }

 private:
  friend class BinWriter;
  Config config_;
  std::vector<Bin> bins_;
  Groups groups_;
  std::vector<int> phases_;
};

// Twice the area of a triangle, in subpixels squared, as a power of two: the exponents that have a
// bin. From legs of 2 px, which hold a sample, to the greatest area in the legal square.
int first_area_bit(const Config& config);
int last_area_bit(const Config& config);

// Which way an edge's inside lies: sixteen winds, 0 = E (a > 0, b = 0), clockwise as seen (y down):
// even multiples of two are axes, odd ones diagonals, odd numbers the octants between.
int wind_of(EdgeSlope slope);
const char* wind_name(int wind);

}  // namespace halfspace
