// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "../config.hpp"
#include "../geometry.hpp"
#include "../rasterizer.hpp"
#include "left_out.hpp"
#include "output_file.hpp"

namespace halfspace {

// What one run did, as written by --stats. Fields and their meaning: docs/02_use/stats.md.
struct RunStats {
  std::string command;
  std::string level;
  GeometryStats geometry;
  RasterStats raster;
  std::uint64_t cases = 0;              // frames rendered: 1, or the TCOV file's cases
  std::uint64_t resnapped = 0;          // TCOV coordinates finer than the configuration's subpixels
  std::uint64_t tiles_in_frame = 0;     // framebuffer tiles that there could be
  std::uint64_t tiles_touched = 0;      // framebuffer tiles that got storage
  std::optional<std::uint64_t> cycles;  // levels cycle and rtl: clocks of all frames
  // Level auto: clocks predicted for all frames, and the interval that holds them.
  struct Prediction {
    double clocks = 0, low = 0, high = 0, confidence = 0;
    std::uint64_t triangles_at_cycle = 0;
    // Some of the windows again on the RTL, compared with level cycle in bits and clocks.
    struct Rtl {
      bool available = false;  // this build has the RTL of the configuration
      std::uint64_t windows = 0;
      std::uint64_t clocks = 0;
      std::uint64_t packets = 0;
      std::string mismatch;  // the first difference; empty: none
    };
    Rtl rtl;
  };
  std::optional<Prediction> predicted;
  LeftOut left_out;             // of the file, not drawn
  std::uint32_t crc = 0;        // CRC-32 of the hit counts of all frames, in order
  double simulate_seconds = 0;  // without loading and writing files
  double wall_seconds = 0;
};

// The most memory this process has had resident so far, bytes; 0 where the system does not say.
std::uint64_t peak_memory_bytes();

nlohmann::ordered_json stats_json(const RunStats& stats, const Config& config);

// Throws Error(kFileWrite).
void write_stats(OutputFile& file, const RunStats& stats, const Config& config);

}  // namespace halfspace
