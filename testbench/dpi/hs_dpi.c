/* SPDX-License-Identifier: Apache-2.0
 *
 * From the argument types of DPI-C (IEEE 1800, annex H) to halfspace.h: what hs_model_pkg.sv
 * imports. A bit vector is an array of 32-bit words, the lowest first (svBitVecVal). C, and C++ for
 * simulators that compile everything as C++. */
#include <halfspace.h>

#include <string.h>

#ifdef __cplusplus
extern "C" {
#endif

void* hs_dpi_create(const char* configuration) {
  hs_model* model = NULL;
  if (configuration != NULL && configuration[0] == '{') {
    hs_create_json(configuration, &model);
  } else {
    hs_create_preset(configuration, &model);
  }
  return model;
}

void hs_dpi_destroy(void* model) { hs_destroy((hs_model*)model); }

const char* hs_dpi_error(void) { return hs_last_error(); }

int hs_dpi_begin_frame(void* model, int width, int height, int cull, double stall_probability,
                       unsigned long long stall_seed) {
  hs_frame frame;
  memset(&frame, 0, sizeof frame);
  frame.struct_size = sizeof frame;
  frame.width = width;
  frame.height = height;
  frame.cull = cull;
  frame.outputs = HS_TILES | HS_CLOCKS;
  frame.stall_probability = stall_probability;
  frame.stall_seed = stall_seed;
  return (int)hs_begin_frame((hs_model*)model, &frame);
}

int hs_dpi_push_triangle(void* model, int x0, int y0, int x1, int y1, int x2, int y2,
                         unsigned int tag) {
  int32_t xy[6];
  xy[0] = x0;
  xy[1] = y0;
  xy[2] = x1;
  xy[3] = y1;
  xy[4] = x2;
  xy[5] = y2;
  return (int)hs_push_triangle((hs_model*)model, xy, tag);
}

int hs_dpi_pull_tile(void* model, int* x, int* y, unsigned int* tag, unsigned long long* clock,
                     uint32_t* mask) {
  hs_tile tile;
  size_t count = 0;
  size_t m;
  hs_status status;
  memset(&tile, 0, sizeof tile);
  status = hs_pull_tiles((hs_model*)model, &tile, 1, &count);
  *x = tile.x;
  *y = tile.y;
  *tag = tile.tag;
  *clock = tile.clock;
  for (m = 0; m < 16; ++m) {
    mask[2 * m] = (uint32_t)tile.mask[m];
    mask[2 * m + 1] = (uint32_t)(tile.mask[m] >> 32);
  }
  return (int)status;
}

int hs_dpi_accepted(void* model, unsigned long long index, unsigned long long* clock) {
  hs_triangle_clocks clocks = {0, 0};
  const hs_status status = hs_read_triangle_clocks((hs_model*)model, index, 1, &clocks);
  *clock = clocks.accepted;
  return (int)status;
}

int hs_dpi_coverage_crc32(void* model, unsigned int* crc) {
  hs_stats stats;
  hs_status status;
  memset(&stats, 0, sizeof stats);
  stats.struct_size = sizeof stats;
  status = hs_get_stats((hs_model*)model, &stats);
  *crc = stats.coverage_crc32;
  return (int)status;
}

#ifdef __cplusplus
}
#endif
