// SPDX-License-Identifier: Apache-2.0
//
// Which of a row of cells, each 2^UnitLog2 px wide, overlap the sample box: one axis of it.
//
// The cells start at origin_i and together span a node, which overlaps the box: where the node's
// index differs from that of first (last), the box starts before (ends after) all the cells.
//
// Latency: combinational. Part of hs_tile_traversal and hs_coverage.
module hs_box_range #(
  parameter int UnitLog2 = 0,
  parameter int Cells = hs_pkg::GRID
) (
  input  logic [hs_pkg::N-1:0] origin_i,  // px, a multiple of Cells * 2^UnitLog2
  input  logic [hs_pkg::N-1:0] first_i,   // px, included
  input  logic [hs_pkg::N-1:0] last_i,    // px, included
  output logic [Cells-1:0]     covered_o
);
  localparam int Bits = $clog2(Cells);
  logic            starts_here, ends_here;
  logic [Bits-1:0] first, last;
  assign starts_here = (first_i >> (UnitLog2 + Bits)) == (origin_i >> (UnitLog2 + Bits));
  assign ends_here   = (last_i >> (UnitLog2 + Bits)) == (origin_i >> (UnitLog2 + Bits));
  assign first       = first_i[UnitLog2 +: Bits];
  assign last        = last_i[UnitLog2 +: Bits];
  // Cells from the first on, and cells up to the last.
  logic [Cells-1:0] from_first, to_last;
  assign from_first = starts_here ? {Cells{1'b1}} << first : '1;
  assign to_last    = ends_here ? ~({Cells{1'b1}} << 1 << last) : '1;
  assign covered_o  = from_first & to_last;
endmodule
