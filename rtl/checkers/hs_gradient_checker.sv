// SPDX-License-Identifier: Apache-2.0
//
// hs_gradient: quantities come no closer than its interval.
//
// Bound; Verilator only.
module hs_gradient_checker #(
  parameter int Interval = 1
) (
  input logic clk_i,
  input logic rst_ni,
  input logic valid_i
);
  assert_interval : assert property (
      @(posedge clk_i) disable iff (!rst_ni) valid_i && Interval == 2 |=> !valid_i)
      else $error("a quantity before the last one's second clock");
endmodule

bind hs_gradient hs_gradient_checker #(.Interval(Interval)) u_checker (
  .clk_i, .rst_ni, .valid_i);
