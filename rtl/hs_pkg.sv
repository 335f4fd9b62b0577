// SPDX-License-Identifier: Apache-2.0
//
// Widths derived from hs_config_pkg, and the packets between the stages. Formulas and proofs:
// docs/03_design/config.md. s, n, k, x, q, r, f, g as there.
// Why nothing is an array, and what else not to tidy: docs/04_develop/rtl_subset.md.
//
// Twins: cmodel/config.hpp (widths), cmodel/packets.hpp (packets: same fields, same order, the
// first field in the highest bits), cmodel/samples.hpp (sample positions).
package hs_pkg;
  // --- Widths, in bits, signed unless said ----------------------------------------------------
  localparam int S = `HS_SUBPIXEL_BITS;
  localparam int N = `HS_VIEWPORT_BITS;
  localparam int K = `HS_GUARD_BITS;
  localparam bit HAS_GUARD_BAND /*verilator public*/ = K > 0;

  localparam int SAMPLES /*verilator public*/ = `HS_SAMPLES;
  localparam int SAMPLE_POSITION_BITS /*verilator public*/ =
      SAMPLES == 1 ? 1 : SAMPLES == 2 ? 2 : SAMPLES == 4 ? 3 : 4;                           // r
  localparam int SAMPLE_BITS /*verilator public*/ = SAMPLES == 1 ? 0 : SAMPLE_POSITION_BITS;  // q
  localparam int POSITION_BITS /*verilator public*/ =
      S > SAMPLE_POSITION_BITS ? S : SAMPLE_POSITION_BITS;                                  // f
  localparam int DROPPED_BITS /*verilator public*/ = POSITION_BITS - SAMPLE_BITS;

  localparam int GRID_LOG2 /*verilator public*/ = `HS_GRID_LOG2;  // g
  localparam int GRID /*verilator public*/ = 1 << GRID_LOG2;
  localparam int LANES /*verilator public*/ = GRID * GRID;
  localparam int LEVELS /*verilator public*/ = (N + GRID_LOG2 - 1) / GRID_LOG2;
  localparam int ROOT_LOG2 /*verilator public*/ = GRID_LOG2 * LEVELS;  // log2 of the root's side

  // No edge reaches 2^EXTENT_LOG2 px in x or in y; without a guard band it may be just that.
  localparam int X = `HS_EXTENT_BITS;
  localparam bit NARROW_EXTENT /*verilator public*/ = X > 0 && X <= (HAS_GUARD_BAND ? K : N);
  localparam int EXTENT_LOG2 /*verilator public*/ =
      NARROW_EXTENT ? X : HAS_GUARD_BAND ? K + 1 : N;
  localparam bit EXTENT_REACHED = !NARROW_EXTENT && !HAS_GUARD_BAND;

  localparam int VERTEX_BITS /*verilator public*/ = HAS_GUARD_BAND ? K + S + 1 : N + S + 2;
  localparam int DELTA_BITS /*verilator public*/ = EXTENT_LOG2 + S + (EXTENT_REACHED ? 2 : 1);
  localparam int AREA_BITS /*verilator public*/ =
      2 * EXTENT_LOG2 + 2 * S + (EXTENT_REACHED ? 2 : 1);
  localparam int CONSTANT_BITS /*verilator public*/ =
      (HAS_GUARD_BAND ? K : N) + EXTENT_LOG2 + 2 * S + 2;
  localparam int EDGE_FULL_BITS /*verilator public*/ =
      (HAS_GUARD_BAND ? K + 1 : N) + EXTENT_LOG2 + S + POSITION_BITS + (NARROW_EXTENT ? 2 : 1);
  localparam int EDGE_BITS /*verilator public*/ = EDGE_FULL_BITS - DROPPED_BITS;
  // An edge value at the origin of a node of side 2^z px takes NODE_BASE_BITS + z bits.
  localparam int NODE_BASE_BITS /*verilator public*/ = EXTENT_LOG2 + S + SAMPLE_BITS + 2;
  localparam int ROOT_BITS /*verilator public*/ = NODE_BASE_BITS + ROOT_LOG2;
  localparam int LANE_BITS /*verilator public*/ = EXTENT_LOG2 + S + GRID_LOG2 + 3;

  localparam int REACH_BITS /*verilator public*/ = DELTA_BITS;                // unsigned
  localparam int INSET_BITS /*verilator public*/ = DELTA_BITS + SAMPLE_BITS;  // unsigned
  localparam int TAG_BITS /*verilator public*/ = `HS_TAG_BITS;     // unsigned
  localparam int COVERAGE_BITS /*verilator public*/ = SAMPLES * LANES;

  // Coverage and every second level above it start with a FIFO, the others with a register.
  function automatic bit buffered(input int level);
    buffered = (LEVELS - 1 - level) % 2 == 0;
  endfunction

  // --- Sample positions, 1/16 px from the pixel's top-left corner, sample m in bits 4m+3..4m ----
  localparam logic [63:0] SAMPLE_X =
      SAMPLES == 1 ? 64'h8 : SAMPLES == 2 ? 64'h4C : SAMPLES == 4 ? 64'hA2E6 :
      SAMPLES == 8 ? 64'hFB135D79 : 64'h1EF0_2486_BDA3_C579;
  localparam logic [63:0] SAMPLE_Y =
      SAMPLES == 1 ? 64'h8 : SAMPLES == 2 ? 64'h4C : SAMPLES == 4 ? 64'hEA62 :
      SAMPLES == 8 ? 64'h1F7D_39B5 : 64'h0F48_C21E_3BD6_7A59;
  // Least and greatest coordinate of any sample; the same in x and in y for every count.
  localparam int SAMPLE_LOW /*verilator public*/ =
      SAMPLES == 1 ? 8 : SAMPLES == 2 ? 4 : SAMPLES == 4 ? 2 : SAMPLES == 8 ? 1 : 0;
  localparam int SAMPLE_HIGH /*verilator public*/ =
      SAMPLES == 1 ? 8 : SAMPLES == 2 ? 12 : SAMPLES == 4 ? 14 : 15;

  // --- Packets --------------------------------------------------------------------------------
  localparam logic [1:0] CULL_NONE = 2'd0;
  localparam logic [1:0] CULL_BACK = 2'd1;
  localparam logic [1:0] CULL_FRONT = 2'd2;

  // State that holds for a whole frame: stable while busy_o is high.
  typedef struct packed {
    logic [N:0] width;   // px, 1..2^n
    logic [N:0] height;  // px, 1..2^n
    logic [1:0] cull;    // CULL_*
  } frame_state_t;

  typedef struct packed {
    logic signed [VERTEX_BITS-1:0] x;  // S.s px
    logic signed [VERTEX_BITS-1:0] y;
  } point_t;

  typedef struct packed {
    point_t              vertex0;
    point_t              vertex1;
    point_t              vertex2;
    logic [TAG_BITS-1:0] tag;
  } triangle_t;

  // Pixels first..last, both included; never empty.
  typedef struct packed {
    logic [N-1:0] x_first;
    logic [N-1:0] y_first;
    logic [N-1:0] x_last;
    logic [N-1:0] y_last;
  } box_t;

  typedef struct packed {
    logic signed [DELTA_BITS-1:0] a;  // S.s px
    logic signed [DELTA_BITS-1:0] b;
  } edge_slope_t;

  // RTL only, once per edge so that no level computes it: where a child's furthest-inside sample
  // lies. The corner of half_plane_grid.md is 2^q c reach - inset for children of side c px.
  typedef struct packed {
    logic [REACH_BITS-1:0] reach;  // max(a, 0) + max(b, 0)
    logic [INSET_BITS-1:0] inset;  // 2^q reach - (a, b) . (that sample's offset in its pixel)
  } corner_t;

  typedef struct packed {
    edge_slope_t                 slope0;
    edge_slope_t                 slope1;
    edge_slope_t                 slope2;
    logic signed [ROOT_BITS-1:0] e0;  // S.(s+q) px^2 at the root's origin, biased, saturated
    logic signed [ROOT_BITS-1:0] e1;
    logic signed [ROOT_BITS-1:0] e2;
    box_t                        box;
    logic                        flipped;
    logic [TAG_BITS-1:0]         tag;
    corner_t                     corner0;
    corner_t                     corner1;
    corner_t                     corner2;
  } setup_triangle_t;

  // e at a node of side 2^z px fits NODE_BASE_BITS + z; the bits above repeat its sign.
  typedef struct packed {
    logic [N-1:0]                x;  // px, a multiple of the node's side
    logic [N-1:0]                y;
    logic signed [ROOT_BITS-1:0] e0;
    logic signed [ROOT_BITS-1:0] e1;
    logic signed [ROOT_BITS-1:0] e2;
  } node_t;

  // What travels down the pyramid: a node and what it needs of its triangle.
  typedef struct packed {
    node_t               node;
    edge_slope_t         slope0;
    edge_slope_t         slope1;
    edge_slope_t         slope2;
    box_t                box;
    logic [TAG_BITS-1:0] tag;
    corner_t             corner0;
    corner_t             corner1;
    corner_t             corner2;
  } traversal_t;

  localparam int TRAVERSAL_BITS /*verilator public*/ =
      6 * N + 3 * ROOT_BITS + 6 * DELTA_BITS + TAG_BITS + 3 * (REACH_BITS + INSET_BITS);

  // One tile of one triangle; sample m's lanes in bits LANES m + LANES - 1 .. LANES m of mask.
  typedef struct packed {
    logic [N-1:0]             x;
    logic [N-1:0]             y;
    logic [COVERAGE_BITS-1:0] mask;
    logic [TAG_BITS-1:0]      tag;
  } coverage_tile_t;

  // One edge's deltas and the partial products of its constant: y is split at VERTEX_LOW_BITS.
  localparam int VERTEX_LOW_BITS = VERTEX_BITS / 2;
  localparam int VERTEX_HIGH_BITS = VERTEX_BITS - VERTEX_LOW_BITS;
  typedef struct packed {
    logic signed [DELTA_BITS-1:0]                   a;
    logic signed [DELTA_BITS-1:0]                   b;
    logic signed [VERTEX_BITS+VERTEX_HIGH_BITS-1:0] ij_high;  // x_i * high part of y_j
    logic signed [VERTEX_BITS+VERTEX_LOW_BITS-1:0]  ij_low;   // x_i * low part of y_j
    logic signed [VERTEX_BITS+VERTEX_HIGH_BITS-1:0] ji_high;  // x_j * high part of y_i
    logic signed [VERTEX_BITS+VERTEX_LOW_BITS-1:0]  ji_low;   // x_j * low part of y_i
  } edge_product_t;

  // --- Back end: free values, until the configuration has fields for them -------------------------
`ifndef HS_GRADIENT_BITS
`define HS_GRADIENT_BITS 16
`endif
  localparam int GRADIENT_BITS = `HS_GRADIENT_BITS;  // F
`ifndef HS_DEPTH_BITS
`define HS_DEPTH_BITS 24
`endif
  localparam int DEPTH_BITS = `HS_DEPTH_BITS;  // d
`ifndef HS_RECIPROCAL_BITS
`define HS_RECIPROCAL_BITS 16
`endif
  localparam int RECIPROCAL_BITS = `HS_RECIPROCAL_BITS;  // R
  localparam int SLOTS_LOG2 = 9;  // tiles of a window
  localparam int INDEX_BITS = 7;  // triangles in the back end at a time

  // --- Back end: widths ---------------------------------------------------------------------------
  localparam int UNIT_BITS = 32;  // a value at a sample, in units, modulo 2^32
  // The value at pixel (0, 0), S.(F+f) units; and what of a slope, S.F units / px, later sums use.
  localparam int PLANE_BITS = UNIT_BITS + GRADIENT_BITS + POSITION_BITS;
  localparam int PLANE_SLOPE_BITS = UNIT_BITS + GRADIENT_BITS + (SAMPLES == 1 ? 0 : 4);
  // From a vertex to the centre of pixel (0, 0), S.f px.
  localparam int CENTRE_BITS = (HAS_GUARD_BAND ? K : N) + POSITION_BITS + 2;
  localparam int AREA_RECIPROCAL_BITS = 32;
  localparam int LENGTH_BITS = 6;  // a doubled area has 1..62 bits
  localparam int TILE_BITS = N > GRID_LOG2 ? N - GRID_LOG2 : 1;  // a tile's column or row
  localparam int CORNER_PLANE_BITS = PLANE_BITS + 2 * PLANE_SLOPE_BITS;
  localparam int TILE_PLANE_BITS = 3 * UNIT_BITS;

  // --- Back end: packets --------------------------------------------------------------------------
  // One quantity of one triangle, and what its plane takes of the triangle.
  typedef struct packed {
    logic signed [UNIT_BITS-1:0]     value0;  // units, at each vertex; less than 2^31 apart
    logic signed [UNIT_BITS-1:0]     value1;
    logic signed [UNIT_BITS-1:0]     value2;
    logic [1:0]                      first;   // 0..2: the vertex that the plane starts at
    edge_slope_t                     slope0;
    edge_slope_t                     slope2;
    logic signed [CENTRE_BITS-1:0]   x;       // from that vertex to the centre of pixel (0, 0)
    logic signed [CENTRE_BITS-1:0]   y;
    logic [LENGTH_BITS-1:0]          length;  // of the doubled area, bits
    logic [AREA_RECIPROCAL_BITS-1:0] reciprocal;
  } gradient_t;
  localparam int GRADIENT_BASE_BITS =  // without the reciprocal
      3 * UNIT_BITS + 2 + 4 * DELTA_BITS + 2 * CENTRE_BITS + LENGTH_BITS;

  typedef struct packed {
    logic [PLANE_BITS-1:0]       at_pixel0;  // S.(F+f) units
    logic [PLANE_SLOPE_BITS-1:0] dx;         // S.F units / px
    logic [PLANE_SLOPE_BITS-1:0] dy;
  } corner_plane_t;

  // What a triangle's planes take of its setup, and its depths.
  typedef struct packed {
    logic [AREA_BITS-2:0]        area;    // doubled, above 0
    edge_slope_t                 slope0;  // oriented
    edge_slope_t                 slope2;
    point_t                      vertex0;
    point_t                      vertex1;
    point_t                      vertex2;
    logic signed [UNIT_BITS-1:0] depth0;  // units
    logic signed [UNIT_BITS-1:0] depth1;
    logic signed [UNIT_BITS-1:0] depth2;
    logic [INDEX_BITS-1:0]       index;
  } depth_setup_t;

  // What all planes of a triangle share.
  typedef struct packed {
    logic [AREA_RECIPROCAL_BITS-1:0] reciprocal;
    logic [LENGTH_BITS-1:0]          length;
    logic [1:0]                      first;
    logic signed [CENTRE_BITS-1:0]   x;
    logic signed [CENTRE_BITS-1:0]   y;
    logic [INDEX_BITS-1:0]           index;
  } triangle_area_t;

  typedef struct packed {
    corner_plane_t         plane;
    logic [INDEX_BITS-1:0] index;
  } triangle_depth_t;

  // One quantity over one tile, units, modulo 2^32: base + dx i + dy j in lane (i, j).
  typedef struct packed {
    logic [UNIT_BITS-1:0] base;
    logic [UNIT_BITS-1:0] dx;
    logic [UNIT_BITS-1:0] dy;
  } tile_plane_t;

  // How depths begin and are compared: stable for a whole frame.
  typedef struct packed {
    logic                  less;     // a lane passes whose depth is less than the stored one
    logic                  equal;
    logic                  greater;
    logic [DEPTH_BITS-1:0] clear;    // of a tile that nothing was tested in yet
  } depth_state_t;

  typedef struct packed {
    tile_plane_t           plane;
    logic [LANES-1:0]      mask;   // lanes to test; their values are in -2^30..2^31 - 2^30 units
    logic [SLOTS_LOG2-1:0] slot;
    logic                  fresh;  // the first tile of this slot
    logic [INDEX_BITS-1:0] index;  // of its triangle
  } depth_tile_t;

  typedef struct packed {
    logic [LANES-1:0]      passed;  // not empty
    logic [SLOTS_LOG2-1:0] slot;
    logic [INDEX_BITS-1:0] index;
  } depth_passed_t;

  // What colours a tile; plane 0, in the lowest bits, is 1/w, then red, green, blue.
  typedef struct packed {
    logic [LANES-1:0]             passed;  // not empty
    logic [SLOTS_LOG2-1:0]        slot;
    logic [3*8-1:0]               level;   // red in the lowest bits
    logic [4*TILE_PLANE_BITS-1:0] planes;
  } shade_tile_t;
endpackage
