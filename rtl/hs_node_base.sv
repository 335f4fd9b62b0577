// SPDX-License-Identifier: Apache-2.0
//
// Where half_plane_grid starts for a node whose children have side c px: one edge's value at the
// furthest-inside sample of child (0, 0), in units of a child's step.
//
// base = (e + 2^q c reach - inset) >> (log2 c + q), docs/03_design/half_plane_grid.md.
//
// Latency: combinational. Part of hs_tile_traversal.
module hs_node_base #(
  parameter int ChildLog2 = hs_pkg::GRID_LOG2
) (
  input  logic signed [hs_pkg::NODE_BASE_BITS+ChildLog2+hs_pkg::GRID_LOG2-1:0] e_i,
  input  hs_pkg::corner_t                     corner_i,
  output logic signed [hs_pkg::LANE_BITS-1:0] base_o
);
  localparam int Lane = hs_pkg::LANE_BITS;
  localparam int Shift = ChildLog2 + hs_pkg::SAMPLE_BITS;

  // 1 bit more than a node's e, which is Lane + Shift bits.
  logic signed [Lane+Shift-1:0] e, start;
  assign e      = (Lane+Shift)'(e_i);
  assign start  = e - (Lane+Shift)'(corner_i.inset);
  assign base_o = start[Lane+Shift-1:Shift] + Lane'(corner_i.reach);
  logic unused;
  assign unused = ^start[Shift-1:0];
endmodule
