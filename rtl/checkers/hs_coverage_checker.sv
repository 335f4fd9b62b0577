// SPDX-License-Identifier: Apache-2.0
//
// coverage: no empty tile comes out, no sample outside the box is covered, tiles keep their order.
//
// Bound; Verilator only. dropped_i: the tile in the last register has no covered sample.
module hs_coverage_checker (
  input logic                   clk_i,
  input logic                   rst_ni,
  input logic                   busy_i,
  input logic                   in_valid_i,
  input logic                   in_ready_i,
  input hs_pkg::traversal_t     in_i,
  input logic                   out_valid_i,
  input logic                   out_ready_i,
  input hs_pkg::coverage_tile_t out_i,
  input logic                   dropped_i
);
  localparam int N = hs_pkg::N;
  localparam int Grid = hs_pkg::GRID;
  default clocking @(posedge clk_i);
  endclocking

  hs_handshake_checker #(.Bits($bits(hs_pkg::traversal_t))) u_in (
    .clk_i, .rst_ni, .valid_i(in_valid_i), .ready_i(in_ready_i), .packet_i(in_i));
  hs_handshake_checker #(.Bits($bits(hs_pkg::coverage_tile_t))) u_out (
    .clk_i, .rst_ni, .valid_i(out_valid_i), .ready_i(out_ready_i), .packet_i(out_i));

  assert_not_empty : assert property (disable iff (!rst_ni) out_valid_i |-> out_i.mask != '0)
      else $error("empty tile");

  function automatic bit mask_in_box(input hs_pkg::coverage_tile_t tile, input hs_pkg::box_t box);
    mask_in_box = 1'b1;
    for (int m = 0; m < hs_pkg::SAMPLES; m++) begin
      for (int j = 0; j < Grid; j++) begin
        for (int i = 0; i < Grid; i++) begin
          if (tile.mask[m * hs_pkg::LANES + j * Grid + i] &&
              (tile.x + N'(i) < box.x_first || tile.x + N'(i) > box.x_last ||
               tile.y + N'(j) < box.y_first || tile.y + N'(j) > box.y_last)) begin
            mask_in_box = 1'b0;
          end
        end
      end
    end
  endfunction

  // Every tile accepted leaves, or ends, in order.
  hs_pkg::traversal_t tiles[$];
  hs_pkg::traversal_t tile;
  logic               wrong_q;
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
          wrong_q <= tile.tag != out_i.tag || tile.node.x != out_i.x || tile.node.y != out_i.y ||
                     !mask_in_box(out_i, tile.box);
        end
      end
      if (in_valid_i && in_ready_i) tiles.push_back(in_i);
    end
  end
  assert_order : assert property (disable iff (!rst_ni) !wrong_q)
      else $error("a tile was lost, invented, overtaken or covered outside the box");
endmodule

bind hs_coverage hs_coverage_checker u_checker (
  .clk_i, .rst_ni, .busy_i(busy_o),
  .in_valid_i(valid_i), .in_ready_i(ready_o), .in_i(tile_i),
  .out_valid_i(valid_o), .out_ready_i(ready_i), .out_i(coverage_o),
  .dropped_i(valid_q[4] && !covered4));
