// SPDX-License-Identifier: Apache-2.0
//
// tile_traversal: children come out in order, each of a node that went in, touching the box, with
// its node's edge values moved and clamped; as many as the masks have bits.
//
// Bound to every level; Verilator only. dropped_i: the node in register 3 has no live child.
// live_i: a node with the live children of mask_i enters register 4.
// last_i: the child handed to register 5 is its node's last.
module hs_tile_traversal_checker #(
  parameter int ChildLog2 = hs_pkg::GRID_LOG2,
  parameter int Children = hs_pkg::LANES
) (
  input logic               clk_i,
  input logic               rst_ni,
  input logic               busy_i,
  input logic               in_valid_i,
  input logic               in_ready_i,
  input hs_pkg::traversal_t in_i,
  input logic               out_valid_i,
  input logic               out_ready_i,
  input hs_pkg::traversal_t out_i,
  input logic               dropped_i,
  input logic               live_i,
  input logic [Children-1:0] mask_i,
  input logic               last_i
);
  localparam int N = hs_pkg::N;
  localparam int NodeLog2 = ChildLog2 + hs_pkg::GRID_LOG2;
  localparam int Root = hs_pkg::ROOT_BITS;
  default clocking @(posedge clk_i);
  endclocking

  hs_handshake_checker #(.Bits($bits(hs_pkg::traversal_t))) u_in (
    .clk_i, .rst_ni, .valid_i(in_valid_i), .ready_i(in_ready_i), .packet_i(in_i));
  hs_handshake_checker #(.Bits($bits(hs_pkg::traversal_t))) u_out (
    .clk_i, .rst_ni, .valid_i(out_valid_i), .ready_i(out_ready_i), .packet_i(out_i));

  // The bits of e above a node's width repeat its sign.
  function automatic bit fits(input logic signed [Root-1:0] e, input int log2);
    logic signed [Root-1:0] high;
    high = e >>> (hs_pkg::NODE_BASE_BITS + log2 - 1);
    fits = high == '0 || high == '1;
  endfunction
  function automatic bit node_fits(input hs_pkg::node_t node, input int log2);
    node_fits = fits(node.e0, log2) && fits(node.e1, log2) && fits(node.e2, log2);
  endfunction
  assert_in_fits : assert property (
      disable iff (!rst_ni) in_valid_i |-> node_fits(in_i.node, NodeLog2))
      else $error("e of a node does not fit");
  assert_out_fits : assert property (
      disable iff (!rst_ni) out_valid_i |-> node_fits(out_i.node, ChildLog2))
      else $error("e of a child does not fit");

  // A cell of 2^log2 px overlaps the box along one axis, and starts at a multiple of its side.
  function automatic bit overlaps(input logic [N-1:0] origin, input logic [N-1:0] first,
                                  input logic [N-1:0] last, input int log2);
    overlaps = (origin >> log2) >= (first >> log2) && (origin >> log2) <= (last >> log2) &&
               (origin >> log2) << log2 == origin;
  endfunction
  function automatic bit touches_box(input hs_pkg::traversal_t packet, input int log2);
    touches_box = overlaps(packet.node.x, packet.box.x_first, packet.box.x_last, log2) &&
                  overlaps(packet.node.y, packet.box.y_first, packet.box.y_last, log2);
  endfunction
  assert_in_box : assert property (
      disable iff (!rst_ni) in_valid_i |-> touches_box(in_i, NodeLog2))
      else $error("node outside the box");
  assert_out_box : assert property (
      disable iff (!rst_ni) out_valid_i |-> touches_box(out_i, ChildLog2))
      else $error("child outside the box");

  // The nodes inside, oldest first; those before the one that a child belongs to were dropped.
  hs_pkg::traversal_t nodes[$];
  int                 drops, pops;  // nodes dropped; nodes passed over without a child
  int                 owed;         // live children that have not come out yet
  logic               fresh, wrong_q;
  logic [N-1:0]       x, y;  // of the last child
  always_ff @(posedge clk_i) begin
    wrong_q <= 1'b0;
    if (!rst_ni) begin
      nodes.delete();
      drops = 0;
      pops  = 0;
      owed  = 0;
      fresh = 1'b1;
    end else begin
      if (!busy_i && (nodes.size() != drops - pops || owed != 0)) wrong_q <= 1'b1;
      if (dropped_i) drops = drops + 1;
      if (out_valid_i && out_ready_i) begin
        owed = owed - 1;
        while (fresh && nodes.size() > 0 && !parent(nodes[0], out_i)) begin
          void'(nodes.pop_front());
          pops = pops + 1;
        end
        if (nodes.size() == 0 || !parent(nodes[0], out_i) || pops > drops) wrong_q <= 1'b1;
        else if (!fresh && {out_i.node.y, out_i.node.x} <= {y, x}) wrong_q <= 1'b1;
        else if (!moved(nodes[0], out_i)) wrong_q <= 1'b1;
        x = out_i.node.x;
        y = out_i.node.y;
        fresh = last5;
        if (last5) void'(nodes.pop_front());
      end
      if (owed < 0) wrong_q <= 1'b1;
      if (live_i) owed = owed + $countones(mask_i);
      if (in_valid_i && in_ready_i) nodes.push_back(in_i);
    end
  end

  function automatic bit parent(input hs_pkg::traversal_t node, input hs_pkg::traversal_t child);
    parent = node.tag == child.tag && node.box == child.box && node.slope0 == child.slope0 &&
             node.slope1 == child.slope1 && node.slope2 == child.slope2 &&
             node.node.x >> NodeLog2 == child.node.x >> NodeLog2 &&
             node.node.y >> NodeLog2 == child.node.y >> NodeLog2;
  endfunction

  // The child's edge values are its node's, moved to its origin and clamped to its width.
  function automatic bit moved(input hs_pkg::traversal_t node, input hs_pkg::traversal_t child);
    longint i, j;
    i = longint'(child.node.x) - longint'(node.node.x);
    j = longint'(child.node.y) - longint'(node.node.y);
    moved = longint'(child.node.e0) == at(longint'(node.node.e0), node.slope0, i, j) &&
            longint'(child.node.e1) == at(longint'(node.node.e1), node.slope1, i, j) &&
            longint'(child.node.e2) == at(longint'(node.node.e2), node.slope2, i, j);
  endfunction
  function automatic longint at(input longint e, input hs_pkg::edge_slope_t slope,
                                input longint i, input longint j);
    longint top;
    top = (64'd1 << (hs_pkg::NODE_BASE_BITS + ChildLog2 - 1)) - 1;
    at = e + ((longint'(slope.a) * i + longint'(slope.b) * j) <<< hs_pkg::SAMPLE_BITS);
    if (at > top) at = top;
  endfunction

  // Whether register 5 holds a node's last child.
  logic last5;
  always_ff @(posedge clk_i) begin
    if (!out_valid_i || out_ready_i) last5 <= last_i;
  end

  assert_order : assert property (disable iff (!rst_ni) !wrong_q)
      else $error("a child was lost, invented, overtaken or moved wrongly");
endmodule

bind hs_tile_traversal hs_tile_traversal_checker #(
  .ChildLog2(ChildLog2), .Children(Side * Side)
) u_checker (
  .clk_i, .rst_ni, .busy_i(busy_o),
  .in_valid_i(valid_i), .in_ready_i(ready_o), .in_i(node_i),
  .out_valid_i(valid_o), .out_ready_i(ready_i), .out_i(node_o),
  .dropped_i(valid_q[3] && !live3), .live_i(load[4]), .mask_i(mask3_q), .last_i(last4));
