// SPDX-License-Identifier: Apache-2.0
//
// The C++ model for a SystemVerilog bench, over DPI-C: triangles in, tiles with their clocks out.
// Needs hs_dpi.c and libhalfspace. Not for synthesis. Page: docs/02_use/dpi.md.
//
// Functions that return int return an hs_status of halfspace.h: 0 done, 1 nothing waits, else
// refused; model_error() then says why. A model is a chandle; free it with model_destroy().
package hs_model_pkg;
  localparam int STATUS_OK = 0;
  localparam int STATUS_EMPTY = 1;

  // As HS_CULL_* and hs_pkg::CULL_*.
  localparam int CULL_NONE = 0;
  localparam int CULL_BACK = 1;
  localparam int CULL_FRONT = 2;

  // Masks of a tile: sample m's lanes in bits 64 m + lanes - 1 .. 64 m.
  localparam int MASK_BITS = 1024;

  import "DPI-C" function string hs_version();
  import "DPI-C" function int unsigned hs_api_version();

  // A preset's name, or a configuration in JSON when it begins with a brace. Null when refused.
  import "DPI-C" function chandle hs_dpi_create(input string configuration);
  import "DPI-C" function void hs_dpi_destroy(input chandle model);
  import "DPI-C" function string hs_dpi_error();

  // Starts an empty frame at clock 0. The clocks assume the stall pattern of this probability and
  // seed; 0: none.
  import "DPI-C" function int hs_dpi_begin_frame(
      input chandle model, input int width, input int height, input int cull,
      input real stall_probability, input longint unsigned stall_seed);

  // Vertices in 2^-subpixel_bits px.
  import "DPI-C" function int hs_dpi_push_triangle(
      input chandle model, input int x0, input int y0, input int x1, input int y1, input int x2,
      input int y2, input int unsigned tag);

  // The next tile in the order of the hardware; clock is the edge at which it is handed over.
  import "DPI-C" function int hs_dpi_pull_tile(
      input chandle model, output int x, output int y, output int unsigned tag,
      output longint unsigned clock, output bit [MASK_BITS-1:0] mask);

  // The clock at which triangle `index` (0: the first) is accepted.
  import "DPI-C" function int hs_dpi_accepted(
      input chandle model, input longint unsigned index, output longint unsigned clock);

  // CRC-32 of the frame's hit counts, as the program's statistics have it.
  import "DPI-C" function int hs_dpi_coverage_crc32(
      input chandle model, output int unsigned crc);

  // The stall pattern itself, for the bench to follow: clocks to wait before triangle `index`, and
  // whether a tile is taken at a clock.
  import "DPI-C" function int unsigned hs_stall_gap(
      input real probability, input longint unsigned seed, input longint unsigned index);
  import "DPI-C" function int hs_stall_ready(
      input real probability, input longint unsigned seed, input longint unsigned clock);
endpackage
