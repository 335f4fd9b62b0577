// SPDX-License-Identifier: Apache-2.0
//
// One edge over one sample's grid of a leaf tile.
//
// Latency: registers 2 (more than one sample only) and 3 of hs_coverage, which owns the handshake:
//          load_i[n] fills register n. Part of hs_coverage.
module hs_sample_grid #(
  parameter int Sample = 0
) (
  input  logic                                clk_i,
  input  logic [3:2]                          load_i,
  input  logic signed [hs_pkg::NODE_BASE_BITS+hs_pkg::GRID_LOG2-1:0] e_i,
  input  hs_pkg::edge_slope_t                 slope_early_i,  // with e_i
  input  hs_pkg::edge_slope_t                 slope_i,        // at register 3's input
  output logic [hs_pkg::LANES-1:0]            covered_o
);
  localparam int Lane = hs_pkg::LANE_BITS;
  localparam int Q = hs_pkg::SAMPLE_BITS;
  logic signed [Lane-1:0] base;

  if (hs_pkg::SAMPLES == 1) begin : gen_centre
    assign base = Lane'(e_i);
    logic unused;
    assign unused = ^{load_i[2], slope_early_i};
  end else begin : gen_offset
    // A u + B v, u and v the sample's offset in its pixel: constants, so sums of shifted slopes.
    localparam logic [63:0] FromX = hs_pkg::SAMPLE_X >> (4 * Sample + 4 - Q);
    localparam logic [63:0] FromY = hs_pkg::SAMPLE_Y >> (4 * Sample + 4 - Q);
    localparam int U = {{(32-Q){1'b0}}, FromX[Q-1:0]};
    localparam int V = {{(32-Q){1'b0}}, FromY[Q-1:0]};
    logic signed [Lane+Q-1:0] a, b, across, down, offset, e;
    logic signed [Lane-1:0]   base2_q;
    assign a      = (Lane+Q)'(signed'(slope_early_i.a));
    assign b      = (Lane+Q)'(signed'(slope_early_i.b));
    hs_constant_product #(.Bits(Lane + Q), .Factor(U)) u_across (.value_i(a), .product_o(across));
    hs_constant_product #(.Bits(Lane + Q), .Factor(V)) u_down (.value_i(b), .product_o(down));
    assign offset = across + down;
    assign e      = (Lane+Q)'(e_i) + offset;
    always_ff @(posedge clk_i) begin
      if (load_i[2]) base2_q <= e[Lane+Q-1:Q];
    end
    assign base = base2_q;
    logic unused;
    assign unused = ^e[Q-1:0];
  end

  logic signed [hs_pkg::DELTA_BITS:0] unused_ab;
  hs_half_plane_grid u_grid (
    .clk_i, .load_i(load_i[3]), .base_i(base), .slope_i(slope_i),
    .ab_o(unused_ab), .covered_o(covered_o));
endmodule
