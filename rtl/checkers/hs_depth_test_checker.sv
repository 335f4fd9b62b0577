// SPDX-License-Identifier: Apache-2.0
//
// hs_depth_test: only lanes that were tested pass, no empty tile comes out, tiles keep their order.
//
// Bound; Verilator only. dropped_i: no lane of the tile in the last register passed.
module hs_depth_test_checker (
  input logic                  clk_i,
  input logic                  rst_ni,
  input logic                  busy_i,
  input logic                  in_valid_i,
  input logic                  in_ready_i,
  input hs_pkg::depth_tile_t   in_i,
  input logic                  out_valid_i,
  input logic                  out_ready_i,
  input hs_pkg::depth_passed_t out_i,
  input logic                  dropped_i
);
  hs_handshake_checker #(.Bits($bits(hs_pkg::depth_tile_t))) u_in (
    .clk_i, .rst_ni, .valid_i(in_valid_i), .ready_i(in_ready_i), .packet_i(in_i));
  hs_handshake_checker #(.Bits($bits(hs_pkg::depth_passed_t))) u_out (
    .clk_i, .rst_ni, .valid_i(out_valid_i), .ready_i(out_ready_i), .packet_i(out_i));

  // Every tile accepted leaves, or ends, in order.
  hs_pkg::depth_tile_t tiles[$];
  hs_pkg::depth_tile_t tile;
  logic                wrong_q;
  always_ff @(posedge clk_i) begin
    wrong_q <= 1'b0;
    if (!rst_ni) begin
      tiles.delete();
    end else begin
      if (!busy_i && tiles.size() != 0) wrong_q <= 1'b1;
      if (dropped_i || (out_valid_i && out_ready_i)) begin
        if (tiles.size() == 0) begin
          wrong_q <= 1'b1;
        end else begin
          tile = tiles.pop_front();
          wrong_q <= tile.slot != out_i.slot || tile.index != out_i.index ||
                     (out_i.passed & ~tile.mask) != '0 || dropped_i != (out_i.passed == '0);
        end
      end
      if (in_valid_i && in_ready_i) tiles.push_back(in_i);
    end
  end
  assert_order : assert property (@(posedge clk_i) disable iff (!rst_ni) !wrong_q)
      else $error("a tile was lost, invented or overtaken, or a lane passed untested");
endmodule

bind hs_depth_test hs_depth_test_checker u_checker (
  .clk_i, .rst_ni, .busy_i(busy_o),
  .in_valid_i(valid_i), .in_ready_i(ready_o), .in_i(tile_i),
  .out_valid_i(valid_o), .out_ready_i(ready_i), .out_i(passed_o),
  .dropped_i(valid_q[4] && !passed4));
