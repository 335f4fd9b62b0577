// SPDX-License-Identifier: Apache-2.0
//
// triangle_setup: its packets are in range and in order, none is lost or invented.
//
// Bound; Verilator only. dropped_i: the triangle in the last register ends there.
module hs_triangle_setup_checker (
  input logic                    clk_i,
  input logic                    rst_ni,
  input hs_pkg::frame_state_t    frame_i,
  input logic                    busy_i,
  input logic                    in_valid_i,
  input logic                    in_ready_i,
  input hs_pkg::triangle_t       triangle_i,
  input logic                    out_valid_i,
  input logic                    out_ready_i,
  input hs_pkg::setup_triangle_t setup_i,
  input logic                    dropped_i
);
  default clocking @(posedge clk_i);
  endclocking

  hs_handshake_checker #(.Bits($bits(hs_pkg::triangle_t))) u_in (
    .clk_i, .rst_ni, .valid_i(in_valid_i), .ready_i(in_ready_i), .packet_i(triangle_i));
  hs_handshake_checker #(.Bits($bits(hs_pkg::setup_triangle_t))) u_out (
    .clk_i, .rst_ni, .valid_i(out_valid_i), .ready_i(out_ready_i), .packet_i(setup_i));

  // Vertices must be in range: k bits of pixels, or the closed viewport without a guard band.
  function automatic bit legal(input logic signed [hs_pkg::VERTEX_BITS-1:0] v);
    if (hs_pkg::HAS_GUARD_BAND) begin
      legal = v != {1'b1, {(hs_pkg::VERTEX_BITS-1){1'b0}}};
    end else begin
      legal = v >= 0 && v <= hs_pkg::VERTEX_BITS'(1) <<< (hs_pkg::VERTEX_BITS - 2);
    end
  endfunction
  function automatic bit legal_point(input hs_pkg::point_t p);
    legal_point = legal(p.x) && legal(p.y);
  endfunction

  property vertices_in_range;
    disable iff (!rst_ni) in_valid_i |-> legal_point(triangle_i.vertex0) &&
        legal_point(triangle_i.vertex1) && legal_point(triangle_i.vertex2);
  endproperty
  assert_vertices : assert property (vertices_in_range) else $error("vertex out of range");

  // No edge is longer than the widths after setup allow.
  function automatic bit short_edge(input hs_pkg::point_t from, input hs_pkg::point_t to);
    short_edge = short_span(from.x, to.x) && short_span(from.y, to.y);
  endfunction
  function automatic bit short_span(input logic signed [hs_pkg::VERTEX_BITS-1:0] from,
                                    input logic signed [hs_pkg::VERTEX_BITS-1:0] to);
    longint span;
    span = longint'(to) - longint'(from);
    if (span < 0) span = -span;
    short_span = hs_pkg::X == 0 || span < 64'd1 << (hs_pkg::X + hs_pkg::S);
  endfunction
  property edges_in_range;
    disable iff (!rst_ni) in_valid_i |-> short_edge(triangle_i.vertex0, triangle_i.vertex1) &&
        short_edge(triangle_i.vertex1, triangle_i.vertex2) &&
        short_edge(triangle_i.vertex2, triangle_i.vertex0);
  endproperty
  assert_edges : assert property (edges_in_range) else $error("edge longer than the fitted range");

  property frame_stable;
    disable iff (!rst_ni) busy_i |=> $stable(frame_i) || !$past(rst_ni);
  endproperty
  assert_frame : assert property (frame_stable) else $error("frame state changed while busy");

  property box_inside_frame;
    disable iff (!rst_ni) out_valid_i |->
        setup_i.box.x_first <= setup_i.box.x_last && setup_i.box.y_first <= setup_i.box.y_last &&
        {1'b0, setup_i.box.x_last} < frame_i.width && {1'b0, setup_i.box.y_last} < frame_i.height;
  endproperty
  assert_box : assert property (box_inside_frame) else $error("box empty or outside the frame");

  // What the pyramid relies on: each edge faces inwards, reach and inset belong to the slope.
  function automatic bit consistent(input hs_pkg::edge_slope_t slope,
                                    input hs_pkg::corner_t corner);
    logic signed [hs_pkg::DELTA_BITS-1:0] a, b;
    longint                               reach, inset;
    a = slope.a;
    b = slope.b;
    reach = (a > 0 ? longint'(a) : 0) + (b > 0 ? longint'(b) : 0);
    inset = (reach <<< hs_pkg::SAMPLE_BITS) - extreme(longint'(a)) - extreme(longint'(b));
    consistent = longint'({1'b0, corner.reach}) == reach &&
                 longint'({1'b0, corner.inset}) == inset && (a != 0 || b != 0);
  endfunction
  function automatic longint extreme(input longint slope);
    longint high, low;
    high = hs_pkg::SAMPLES == 1 ? 0 : longint'(hs_pkg::SAMPLE_HIGH) >>> (4 - hs_pkg::SAMPLE_BITS);
    low = hs_pkg::SAMPLES == 1 ? 0 : longint'(hs_pkg::SAMPLE_LOW) >>> (4 - hs_pkg::SAMPLE_BITS);
    extreme = slope > 0 ? slope * high : slope * low;
  endfunction
  property corners;
    disable iff (!rst_ni) out_valid_i |-> consistent(setup_i.slope0, setup_i.corner0) &&
        consistent(setup_i.slope1, setup_i.corner1) && consistent(setup_i.slope2, setup_i.corner2);
  endproperty
  assert_corners : assert property (corners) else $error("corner does not belong to the slope");

  // Every triangle accepted leaves, or ends, in order: a queue of the tags inside.
  logic [hs_pkg::TAG_BITS-1:0] tags[$];
  logic                        ends, leaves, wrong_q;
  logic [hs_pkg::TAG_BITS-1:0] tag;
  assign ends   = dropped_i;
  assign leaves = out_valid_i && out_ready_i;
  always_ff @(posedge clk_i) begin
    wrong_q <= 1'b0;
    if (!rst_ni) begin
      tags.delete();
    end else begin
      if (!busy_i && tags.size() != 0) wrong_q <= 1'b1;
      if (ends || leaves) begin
        if (tags.size() == 0) begin
          wrong_q <= 1'b1;
        end else begin
          tag = tags.pop_front();
          wrong_q <= tag != setup_i.tag;
        end
      end
      if (in_valid_i && in_ready_i) tags.push_back(triangle_i.tag);
    end
  end
  assert_order : assert property (disable iff (!rst_ni) !wrong_q)
      else $error("a triangle was lost, invented or overtaken");
endmodule

bind hs_triangle_setup hs_triangle_setup_checker u_checker (
  .clk_i, .rst_ni, .frame_i, .busy_i(busy_o),
  .in_valid_i(valid_i), .in_ready_i(ready_o), .triangle_i,
  .out_valid_i(valid_o), .out_ready_i(ready_i), .setup_i(setup_o),
  .dropped_i(valid_q[6] && dropped6_q));
