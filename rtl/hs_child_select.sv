// SPDX-License-Identifier: Apache-2.0
//
// The lowest set bit of a grid's mask, as a column and a row, and the mask without it.
//
// Latency: combinational. Part of hs_tile_traversal.
module hs_child_select #(
  parameter int Side = hs_pkg::GRID
) (
  input  logic [Side*Side-1:0]    mask_i,
  output logic [$clog2(Side)-1:0] column_o,  // both 0 for an empty mask
  output logic [$clog2(Side)-1:0] row_o,
  output logic [Side*Side-1:0]    rest_o
);
  localparam int Bits = $clog2(Side);
  logic [Side-1:0] row_any, row_first, row, column_first;

  for (genvar j = 0; j < Side; j++) begin : gen_any
    assign row_any[j] = |mask_i[j*Side +: Side];
  end
  assign row_first    = row_any & (~row_any + 1'b1);
  assign column_first = row & (~row + 1'b1);

  always_comb begin
    row   = '0;
    row_o = '0;
    for (int j = 0; j < Side; j++) begin
      if (row_first[j]) begin
        row   = row | mask_i[j*Side +: Side];
        row_o = row_o | Bits'(j);
      end
    end
  end

  always_comb begin
    column_o = '0;
    for (int i = 0; i < Side; i++) begin
      if (column_first[i]) column_o = column_o | Bits'(i);
    end
  end

  for (genvar j = 0; j < Side; j++) begin : gen_rest
    assign rest_o[j*Side +: Side] =
        mask_i[j*Side +: Side] & ~(row_first[j] ? column_first : {Side{1'b0}});
  end
endmodule
