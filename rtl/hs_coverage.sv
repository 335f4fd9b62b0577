// SPDX-License-Identifier: Apache-2.0
//
// The last grid: a leaf tile in, one bit per pixel and sample out. A tile without a covered sample
// ends in the last register.
//
// Twin:       cmodel/coverage.hpp, halfspace::coverage()
// Latency:    3 cycles (more than one sample: 4).  Throughput: 1 tile per cycle.
// Handshake:  valid/ready; ready_o is a register. Timing: docs/03_design/timing.md
// Registers:  1 tile, two-entry FIFO | 2 samples' edge values (absent for one sample)
//             | 3 grids' start | 4 mask
module hs_coverage (
  input  logic                   clk_i,
  input  logic                   rst_ni,  // synchronous, active low
  output logic                   busy_o,

  input  logic                   valid_i,
  output logic                   ready_o,
  input  hs_pkg::traversal_t     tile_i,

  output logic                   valid_o,
  input  logic                   ready_i,
  output hs_pkg::coverage_tile_t coverage_o
);
  localparam int Grid = hs_pkg::GRID;
  localparam int Lanes = hs_pkg::LANES;
  localparam int Samples = hs_pkg::SAMPLES;
  localparam int LeafBits = hs_pkg::NODE_BASE_BITS + hs_pkg::GRID_LOG2;

  // --- Handshake ------------------------------------------------------------------------------
  logic       covered4;  // register 4 holds a covered sample
  logic       valid1, valid2, ready2, ready3, ready4;
  logic [4:3] valid_q;
  logic [4:2] load;
  assign ready4 = !valid_q[4] || !covered4 || ready_i;
  assign ready3 = !valid_q[3] || ready4;
  assign load   = {valid_q[3] && ready4, valid2 && ready3, valid1 && ready2};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= '0;
    else valid_q <= load[4:3] | (valid_q & ~{ready4, ready3});
  end
  assign valid_o = valid_q[4] && covered4;
  assign busy_o  = valid1 || valid2 || (|valid_q);

  // --- Registers 1 to 3: the tile and the pixels of the box --------------------------------------
  hs_pkg::traversal_t tile1, tile2;
  logic               unused_tile2;  // its e is in the grids by now, its corners end here
  assign unused_tile2 = ^tile2;
  logic [Grid-1:0]    column_d, row_d, column3_q, row3_q;
  logic [hs_pkg::N-1:0]        x3_q, y3_q;
  logic [hs_pkg::TAG_BITS-1:0] tag3_q;

  hs_fifo #(.Bits(hs_pkg::TRAVERSAL_BITS)) u_fifo (
    .clk_i, .rst_ni, .valid_i, .ready_o, .data_i(tile_i),
    .valid_o(valid1), .ready_i(ready2), .data_o(tile1));

  if (Samples == 1) begin : gen_direct
    assign valid2 = valid1;
    assign ready2 = ready3;
    assign tile2    = tile1;
    logic unused;
    assign unused = load[2];
  end else begin : gen_register2
    logic               valid2_q;
    hs_pkg::traversal_t tile2_q;
    assign valid2 = valid2_q;
    assign ready2 = !valid2_q || ready3;
    assign tile2    = tile2_q;
    always_ff @(posedge clk_i) begin
      if (!rst_ni) valid2_q <= 1'b0;
      else if (ready2) valid2_q <= valid1;
    end
    always_ff @(posedge clk_i) begin
      if (load[2]) tile2_q <= tile1;
    end
  end

  hs_box_range u_columns (
    .origin_i(tile2.node.x), .first_i(tile2.box.x_first), .last_i(tile2.box.x_last),
    .covered_o(column_d));
  hs_box_range u_rows (
    .origin_i(tile2.node.y), .first_i(tile2.box.y_first), .last_i(tile2.box.y_last),
    .covered_o(row_d));

  always_ff @(posedge clk_i) begin
    if (load[3]) begin
      column3_q <= column_d;
      row3_q    <= row_d;
      x3_q      <= tile2.node.x;
      y3_q      <= tile2.node.y;
      tag3_q    <= tile2.tag;
    end
  end

  // --- Registers 2 to 4: a grid per sample and edge ----------------------------------------------
  logic [Lanes-1:0] box_mask;
  for (genvar j = 0; j < Grid; j++) begin : gen_box
    assign box_mask[j*Grid +: Grid] = row3_q[j] ? column3_q : '0;
  end

  logic [Samples*Lanes-1:0] mask;
  hs_pkg::coverage_tile_t   coverage4_q;
  for (genvar m = 0; m < Samples; m++) begin : gen_sample
    logic [Lanes-1:0] covered0, covered1, covered2;
    hs_sample_grid #(.Sample(m)) u_edge0 (
      .clk_i, .load_i(load[3:2]), .e_i(tile1.node.e0[LeafBits-1:0]), .slope_early_i(tile1.slope0),
      .slope_i(tile2.slope0), .covered_o(covered0));
    hs_sample_grid #(.Sample(m)) u_edge1 (
      .clk_i, .load_i(load[3:2]), .e_i(tile1.node.e1[LeafBits-1:0]), .slope_early_i(tile1.slope1),
      .slope_i(tile2.slope1), .covered_o(covered1));
    hs_sample_grid #(.Sample(m)) u_edge2 (
      .clk_i, .load_i(load[3:2]), .e_i(tile1.node.e2[LeafBits-1:0]), .slope_early_i(tile1.slope2),
      .slope_i(tile2.slope2), .covered_o(covered2));
    assign mask[m*Lanes +: Lanes] = covered0 & covered1 & covered2 & box_mask;
  end

  always_ff @(posedge clk_i) begin
    if (load[4]) begin
      coverage4_q.x    <= x3_q;
      coverage4_q.y    <= y3_q;
      coverage4_q.mask <= mask;
      coverage4_q.tag  <= tag3_q;
    end
  end
  assign covered4   = |coverage4_q.mask;
  assign coverage_o = coverage4_q;
endmodule
