// SPDX-License-Identifier: Apache-2.0
//
// hs_tile_plane: its handshakes, and as many tiles leave as came.
//
// Bound; Verilator only.
module hs_tile_plane_checker #(
  parameter int InBits = 1,
  parameter int OutBits = 1
) (
  input logic               clk_i,
  input logic               rst_ni,
  input logic               busy_i,
  input logic               in_valid_i,
  input logic               in_ready_i,
  input logic [InBits-1:0]  in_i,
  input logic               out_valid_i,
  input logic               out_ready_i,
  input logic [OutBits-1:0] out_i
);
  hs_handshake_checker #(.Bits(InBits)) u_in (
    .clk_i, .rst_ni, .valid_i(in_valid_i), .ready_i(in_ready_i), .packet_i(in_i));
  hs_handshake_checker #(.Bits(OutBits)) u_out (
    .clk_i, .rst_ni, .valid_i(out_valid_i), .ready_i(out_ready_i), .packet_i(out_i));

  int inside_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) inside_q <= 0;
    else inside_q <= inside_q + int'(in_valid_i && in_ready_i) - int'(out_valid_i && out_ready_i);
  end
  assert_count : assert property (
      @(posedge clk_i) disable iff (!rst_ni) busy_i == (inside_q != 0))
      else $error("a tile was lost or invented");
endmodule

bind hs_tile_plane hs_tile_plane_checker #(.InBits(InBits), .OutBits(OutBits)) u_checker (
  .clk_i, .rst_ni, .busy_i(busy_o),
  .in_valid_i(valid_i), .in_ready_i(ready_o), .in_i(tile_i),
  .out_valid_i(valid_o), .out_ready_i(ready_i), .out_i(plane_o));
