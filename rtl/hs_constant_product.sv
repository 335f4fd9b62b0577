// SPDX-License-Identifier: Apache-2.0
//
// value * Factor for a small constant, as at most three shifted additions: a written product would
// cost a multiplier block.
//
// Latency: combinational. Part of hs_coverage.
module hs_constant_product #(
  parameter int Bits = 8,
  parameter int Factor = 1  // 0..15
) (
  input  logic signed [Bits-1:0] value_i,
  output logic signed [Bits-1:0] product_o
);
  logic signed [Bits-1:0] low, high;
  assign low  = (Factor & 1) == 0 ? '0 : value_i;
  assign high = (Factor >> 1 & 1) == 0 ? '0 : value_i <<< 1;
  if (Factor == 7 || Factor >= 13) begin : gen_from_above
    // 7 = 8 - 1, 13 = 16 - 3, 14 = 16 - 2, 15 = 16 - 1.
    localparam int Above = Factor == 7 ? 3 : 4;
    localparam int Below = (1 << Above) - Factor;
    logic signed [Bits-1:0] below;
    assign below     = Below == 3 ? (value_i <<< 1) + value_i : value_i <<< (Below - 1);
    assign product_o = (value_i <<< Above) - below;
    logic unused;
    assign unused = ^{low, high};
  end else begin : gen_from_below
    logic signed [Bits-1:0] four, eight;
    assign four      = (Factor >> 2 & 1) == 0 ? '0 : value_i <<< 2;
    assign eight     = (Factor >> 3 & 1) == 0 ? '0 : value_i <<< 3;
    assign product_o = (low + high) + (four + eight);
  end
endmodule
