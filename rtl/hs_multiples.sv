// SPDX-License-Identifier: Apache-2.0
//
// value times 0 to GRID - 1, multiple k in bits UNIT_BITS k + UNIT_BITS - 1 .. UNIT_BITS k: one
// addition each at most, where a written product would cost a multiplier block.
//
// Latency: combinational. Part of hs_depth_test.
module hs_multiples (
  input  logic [hs_pkg::UNIT_BITS-1:0]              value_i,
  output logic [hs_pkg::GRID*hs_pkg::UNIT_BITS-1:0] multiples_o
);
  localparam int Unit = hs_pkg::UNIT_BITS;
  logic [Unit-1:0] three;
  assign three = (value_i << 1) + value_i;
  assign multiples_o[0 +: 4*Unit] = {three, value_i << 1, value_i, {Unit{1'b0}}};
  if (hs_pkg::GRID == 8) begin : gen_eight
    logic [Unit-1:0] five, seven;
    assign five  = (value_i << 2) + value_i;
    assign seven = (value_i << 3) - value_i;
    assign multiples_o[4*Unit +: 4*Unit] = {seven, three << 1, five, value_i << 2};
  end
endmodule
