// SPDX-License-Identifier: Apache-2.0
//
// halfspace vectors, in parts: options (vectors_command), making (vectors_make), checking
// (vectors_check).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "camera_options.hpp"
#include "command.hpp"
#include "vectors/vector_set.hpp"

namespace halfspace {

struct VectorsRequest {
  std::string in;                // mesh or TCOV file
  std::string generate;          // shapes, or empty
  std::string from;              // file or manifest of vectors to write again
  std::string goal;              // per cent, or empty
  std::vector<std::string> out;  // files
  std::string bench;             // folder
  std::string format;
  std::string manifest;
  std::string check;
  std::string bins;  // a file whose bins are reported
  std::string stage = "rasterizer";
  std::string size;
  std::string cull = "none";
  int node_level = 0;
  std::uint64_t count = 0;  // triangles; 0: all of a scene, 1000 of a generator
  std::uint64_t seed = 1;
  double stall = 0;
  int max_tiles = 256;
  int case_id = -1;
  std::uint64_t tries = 1000000;  // draws of --goal
  std::uint64_t times = 1;        // hits of each bin that --goal keeps
  bool list_bins = false;
  CameraArguments camera;
  ConfigOptions config;
};

// A set of vectors from a file or a generator. Throws Error.
VectorSet make_vectors(const VectorsRequest& request, const VectorMeta& meta);

// A small set that hits bins (vectors/bins.hpp), and whether it hits as many as asked. Prints the
// report. Throws Error.
struct GoalResult {
  VectorSet set;
  bool reached = false;
};
GoalResult make_goal(const VectorsRequest& request, VectorMeta meta);

// The bins that a file's triangles hit. Exit status: 0 when all reachable ones.
int report_bins_of(const VectorsRequest& request);

// Reads a file or manifest, builds every set again and compares. Exit status.
int check_vector_files(const std::string& path);

}  // namespace halfspace
