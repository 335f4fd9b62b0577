// SPDX-License-Identifier: Apache-2.0
//
// The low bits of value * factor, both signed: the value in four parts, so that no product and no
// sum is wider than a clock allows.
//
// Product: bits of the result, more than three quarters of Value; Value + Factor: all of them.
//
// Latency:   3 cycles, rigid.  Throughput: 1 a cycle.
// Registers: 1 four products | 2 two sums | 3 their sum
module hs_wide_product #(
  parameter int Value = 55,
  parameter int Factor = 34,
  parameter int Product = Value + Factor
) (
  input  logic                      clk_i,
  input  logic signed [Value-1:0]   value_i,
  input  logic signed [Factor-1:0]  factor_i,
  output logic signed [Product-1:0] product_o
);
  localparam int Part = (Value + 3) / 4;
  localparam int Last = Value - 3 * Part;
  localparam int LowBits = 2 * Part + Factor < Product ? 2 * Part + Factor : Product;
  localparam int HighBits = Product - 2 * Part;

  logic signed [Part:0]   part0, part1, part2;
  logic signed [Last-1:0] part3;
  assign part0 = {1'b0, value_i[0 +: Part]};
  assign part1 = {1'b0, value_i[Part +: Part]};
  assign part2 = {1'b0, value_i[2*Part +: Part]};
  assign part3 = value_i[Value-1:3*Part];

  logic signed [Part+Factor-1:0] product0_q, product1_q, product2_q;
  logic signed [Last+Factor-1:0] product3_q;
  logic signed [LowBits-1:0]     low_q;
  logic signed [HighBits-1:0]    high_q;
  logic signed [Product-1:0]     product_q;
  always_ff @(posedge clk_i) begin
    product0_q <= part0 * factor_i;
    product1_q <= part1 * factor_i;
    product2_q <= part2 * factor_i;
    product3_q <= part3 * factor_i;
    low_q      <= {(LowBits-Part)'(product0_q >>> Part) + (LowBits-Part)'(product1_q),
                   product0_q[Part-1:0]};
    high_q     <= {(HighBits-Part)'(product2_q >>> Part) + (HighBits-Part)'(product3_q),
                   product2_q[Part-1:0]};
    product_q  <= {HighBits'(low_q >>> (2 * Part)) + high_q, low_q[2*Part-1:0]};
  end
  assign product_o = product_q;
  logic unused;  // the last part's bits above the product
  assign unused = ^product3_q;
endmodule
