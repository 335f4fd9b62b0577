// SPDX-License-Identifier: Apache-2.0
//
// One testing level of the pyramid: tests the children of a node at once and hands the live ones
// down, lowest bit first. A node without a live child ends here.
//
// Level: 0 is the root; the last testing level is LEVELS - 2.
//
// Twin:       cmodel/tile_traversal.hpp, halfspace::tile_traversal()
// Latency:    5 cycles to the first child.  Throughput: 1 child per cycle, and no bubble between
//             nodes; a node without a live child costs a cycle only while nothing is handed down.
// Handshake:  valid/ready; ready_o is a register where register 1 is a FIFO.
//             Timing: docs/03_design/timing.md
// Registers:  1 node, at every second level a two-entry FIFO | 2 grids' start
//             | 3 mask of live children | 4 child in hand, rest of the mask | 5 step to the child
module hs_tile_traversal #(
  parameter int Level = 0
) (
  input  logic               clk_i,
  input  logic               rst_ni,  // synchronous, active low
  output logic               busy_o,

  input  logic               valid_i,
  output logic               ready_o,
  input  hs_pkg::traversal_t node_i,

  output logic               valid_o,
  input  logic               ready_i,
  output hs_pkg::traversal_t node_o
);
  localparam int ChildLog2 = hs_pkg::ROOT_LOG2 - hs_pkg::GRID_LOG2 * (Level + 1);
  localparam int NodeBits = hs_pkg::NODE_BASE_BITS + ChildLog2 + hs_pkg::GRID_LOG2;
  // The root spans the viewport, which may need fewer lanes than a grid has.
  localparam int SideLog2 = Level == 0 ? hs_pkg::N - ChildLog2 : hs_pkg::GRID_LOG2;
  localparam int Side = 1 << SideLog2;

  // --- Handshake ------------------------------------------------------------------------------
  logic       live3, last4;  // register 3 holds a live child; register 4 holds the last one
  logic       valid1;
  logic [5:2] valid_q, ready, load;
  always_comb begin
    ready[5] = !valid_q[5] || ready_i;
    ready[4] = !valid_q[4] || (last4 && ready[5]);
    ready[3] = !valid_q[3] || !live3 || ready[4];
    ready[2] = !valid_q[2] || ready[3];
  end
  assign load[5] = valid_q[4] && ready[5];
  assign load[4] = valid_q[3] && live3 && ready[4];
  assign load[3] = valid_q[2] && ready[3];
  assign load[2] = valid1 && ready[2];

  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= '0;
    else valid_q <= load | (valid_q & ~ready);
  end
  assign valid_o = valid_q[5];
  assign busy_o  = valid1 || (|valid_q);

  // --- Register 1: the node -------------------------------------------------------------------
  hs_pkg::traversal_t node1, node2_q, node3_q, node4_q, node5_q;
  if (hs_pkg::buffered(Level)) begin : gen_fifo
    hs_fifo #(.Bits(hs_pkg::TRAVERSAL_BITS)) u_fifo (
      .clk_i, .rst_ni, .valid_i, .ready_o, .data_i(node_i),
      .valid_o(valid1), .ready_i(ready[2]), .data_o(node1));
  end else begin : gen_register
    logic               valid1_q;
    hs_pkg::traversal_t node1_q;
    assign ready_o = !valid1_q || ready[2];
    assign valid1  = valid1_q;
    assign node1   = node1_q;
    always_ff @(posedge clk_i) begin
      if (!rst_ni) valid1_q <= 1'b0;
      else if (ready_o) valid1_q <= valid_i;
    end
    always_ff @(posedge clk_i) begin
      if (ready_o && valid_i) node1_q <= node_i;
    end
  end

  always_ff @(posedge clk_i) begin
    if (load[2]) node2_q <= node1;
    if (load[3]) node3_q <= node2_q;
    if (load[4]) node4_q <= node3_q;
  end

  // --- Register 2: the grids' start, and the children the box touches, by column and by row -----
  logic signed [hs_pkg::LANE_BITS-1:0] base0, base1, base2;
  logic signed [hs_pkg::DELTA_BITS:0]  ab2_0, ab2_1, ab2_2;
  logic [Side*Side-1:0]                covered0, covered1, covered2;
  logic [Side-1:0]                     column_d, row_d, column2_q, row2_q;

  hs_node_base #(.ChildLog2(ChildLog2)) u_base0 (
    .e_i(node1.node.e0[NodeBits-1:0]), .corner_i(node1.corner0), .base_o(base0));
  hs_node_base #(.ChildLog2(ChildLog2)) u_base1 (
    .e_i(node1.node.e1[NodeBits-1:0]), .corner_i(node1.corner1), .base_o(base1));
  hs_node_base #(.ChildLog2(ChildLog2)) u_base2 (
    .e_i(node1.node.e2[NodeBits-1:0]), .corner_i(node1.corner2), .base_o(base2));

  hs_half_plane_grid #(.Side(Side)) u_grid0 (
    .clk_i, .load_i(load[2]), .base_i(base0), .slope_i(node1.slope0),
    .ab_o(ab2_0), .covered_o(covered0));
  hs_half_plane_grid #(.Side(Side)) u_grid1 (
    .clk_i, .load_i(load[2]), .base_i(base1), .slope_i(node1.slope1),
    .ab_o(ab2_1), .covered_o(covered1));
  hs_half_plane_grid #(.Side(Side)) u_grid2 (
    .clk_i, .load_i(load[2]), .base_i(base2), .slope_i(node1.slope2),
    .ab_o(ab2_2), .covered_o(covered2));

  hs_box_range #(.UnitLog2(ChildLog2), .Cells(Side)) u_columns (
    .origin_i(node1.node.x), .first_i(node1.box.x_first), .last_i(node1.box.x_last),
    .covered_o(column_d));
  hs_box_range #(.UnitLog2(ChildLog2), .Cells(Side)) u_rows (
    .origin_i(node1.node.y), .first_i(node1.box.y_first), .last_i(node1.box.y_last),
    .covered_o(row_d));

  always_ff @(posedge clk_i) begin
    if (load[2]) begin
      column2_q <= column_d;
      row2_q    <= row_d;
    end
  end

  // --- Register 3: the mask --------------------------------------------------------------------
  logic [Side*Side-1:0] box_mask, mask3_q;
  logic signed [hs_pkg::DELTA_BITS:0] ab3_0_q, ab3_1_q, ab3_2_q;
  for (genvar j = 0; j < Side; j++) begin : gen_box
    assign box_mask[j*Side +: Side] = row2_q[j] ? column2_q : '0;
  end
  assign live3 = |mask3_q;

  always_ff @(posedge clk_i) begin
    if (load[3]) begin
      mask3_q  <= covered0 & covered1 & covered2 & box_mask;
      ab3_0_q <= ab2_0;
      ab3_1_q <= ab2_1;
      ab3_2_q <= ab2_2;
    end
  end

  // --- Register 4: the child in hand, selected a cycle ahead -------------------------------------
  logic                 new_node;  // the next child comes from register 3
  logic [Side*Side-1:0] choice, rest, rest4_q;
  logic [SideLog2-1:0]  column, row, column4_q, row4_q;
  logic signed [hs_pkg::DELTA_BITS:0] ab4_0_q, ab4_1_q, ab4_2_q;
  assign last4    = rest4_q == '0;
  assign new_node = !valid_q[4] || last4;
  assign choice   = new_node ? mask3_q : rest4_q;

  hs_child_select #(.Side(Side)) u_select (
    .mask_i(choice), .column_o(column), .row_o(row), .rest_o(rest));

  always_ff @(posedge clk_i) begin
    if (load[4] || load[5]) begin
      rest4_q   <= rest;
      column4_q <= column;
      row4_q    <= row;
    end
    if (load[4]) begin
      ab4_0_q <= ab3_0_q;
      ab4_1_q <= ab3_1_q;
      ab4_2_q <= ab3_2_q;
    end
  end

  // --- Register 5: the step; the addition to e follows it ----------------------------------------
  logic signed [hs_pkg::ROOT_BITS-1:0] e0, e1, e2;
  hs_child_step #(.Side(Side), .ChildLog2(ChildLog2)) u_step0 (
    .clk_i, .load_i(load[5]), .column_i(column4_q), .row_i(row4_q), .slope_i(node4_q.slope0),
    .ab_i(ab4_0_q), .e_i(node4_q.node.e0[NodeBits-1:0]), .e_o(e0));
  hs_child_step #(.Side(Side), .ChildLog2(ChildLog2)) u_step1 (
    .clk_i, .load_i(load[5]), .column_i(column4_q), .row_i(row4_q), .slope_i(node4_q.slope1),
    .ab_i(ab4_1_q), .e_i(node4_q.node.e1[NodeBits-1:0]), .e_o(e1));
  hs_child_step #(.Side(Side), .ChildLog2(ChildLog2)) u_step2 (
    .clk_i, .load_i(load[5]), .column_i(column4_q), .row_i(row4_q), .slope_i(node4_q.slope2),
    .ab_i(ab4_2_q), .e_i(node4_q.node.e2[NodeBits-1:0]), .e_o(e2));

  always_ff @(posedge clk_i) begin
    if (load[5]) begin
      node5_q        <= node4_q;
      node5_q.node.x <= node4_q.node.x | (hs_pkg::N'(column4_q) << ChildLog2);
      node5_q.node.y <= node4_q.node.y | (hs_pkg::N'(row4_q) << ChildLog2);
    end
  end

  always_comb begin
    node_o         = node5_q;
    node_o.node.e0 = e0;
    node_o.node.e1 = e1;
    node_o.node.e2 = e2;
  end
endmodule
