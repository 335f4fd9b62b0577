// SPDX-License-Identifier: Apache-2.0
//
// value times 0 to 7, modulo 2^UNIT_BITS, as one addition: a written product would cost a
// multiplier block. 3 = 4 - 1, 7 = 8 - 1.
//
// Latency: combinational. Part of hs_shade.
module hs_small_product (
  input  logic [hs_pkg::UNIT_BITS-1:0] value_i,
  input  logic [2:0]                   factor_i,
  output logic [hs_pkg::UNIT_BITS-1:0] product_o
);
  localparam int Unit = hs_pkg::UNIT_BITS;
  logic            less_one;  // -1 in the low part, made up for in the high part
  logic [Unit-1:0] low;
  logic [Unit-1:1] high;
  assign less_one = &factor_i[1:0];
  always_comb begin
    case (factor_i[1:0])
      2'd0: low = '0;
      2'd1: low = value_i;
      2'd2: low = value_i << 1;
      default: low = ~value_i;
    endcase
    case ({factor_i[2], less_one})
      2'b00: high = '0;
      2'b11: high = {value_i[Unit-4:0], 2'b00};
      default: high = {value_i[Unit-3:0], 1'b0};
    endcase
  end
  // The 1 of a two's complement goes into high's empty lowest bit.
  assign product_o = low + {high, less_one};
endmodule
