// SPDX-License-Identifier: Apache-2.0
//
// hs_depth_setup: a triangle has an area, and its plane comes out as long after as it should.
//
// Bound; Verilator only.
module hs_depth_setup_checker #(
  parameter int Latency = 49
) (
  input logic                 clk_i,
  input logic                 rst_ni,
  input logic                 valid_i,
  input hs_pkg::depth_setup_t triangle_i,
  input logic                 valid_o
);
  logic [Latency-1:0] entered_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) entered_q <= '0;
    else entered_q <= {entered_q[Latency-2:0], valid_i};
  end
  assert_area : assert property (
      @(posedge clk_i) disable iff (!rst_ni) valid_i |-> triangle_i.area != '0)
      else $error("a triangle without an area");
  assert_latency : assert property (
      @(posedge clk_i) disable iff (!rst_ni) valid_o == entered_q[Latency-1])
      else $error("a plane that is not due, or none that is");
endmodule

bind hs_depth_setup hs_depth_setup_checker #(.Latency(47 + Interval)) u_checker (
  .clk_i, .rst_ni, .valid_i, .triangle_i, .valid_o);
