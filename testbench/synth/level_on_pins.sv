// SPDX-License-Identifier: Apache-2.0
//
// One testing level of the pyramid between shift registers, so that it has few pins and every path
// of it starts and ends in a register: what a place-and-route tool needs to say a clock.
//
// Used by area.py only.
module level_on_pins (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic bit_i,
  input  logic valid_i,
  input  logic ready_i,
  output logic bit_o,
  output logic valid_o,
  output logic ready_o,
  output logic busy_o
);
  localparam int Bits = hs_pkg::TRAVERSAL_BITS;
  logic [Bits-1:0]    in_q, out_q;
  logic               valid_q, ready_q, valid, ready, busy;
  hs_pkg::traversal_t child;

  hs_tile_traversal #(.Level(1)) u_level (
    .clk_i, .rst_ni, .busy_o(busy),
    .valid_i(valid_q), .ready_o(ready), .node_i(in_q),
    .valid_o(valid), .ready_i(ready_q), .node_o(child));

  always_ff @(posedge clk_i) begin
    in_q    <= {in_q[Bits-2:0], bit_i};
    valid_q <= valid_i;
    ready_q <= ready_i;
    out_q   <= valid && ready_q ? child : {out_q[Bits-2:0], 1'b0};
    valid_o <= valid;
    ready_o <= ready;
    busy_o  <= busy;
  end
  assign bit_o = out_q[Bits-1];
endmodule
