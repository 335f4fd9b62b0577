// SPDX-License-Identifier: Apache-2.0
//
// Three snapped vertices in, three biased edge functions and a sample box out, or nothing: a
// triangle of no area, one that is culled and one whose box is empty end in the last register.
//
// Twin:       cmodel/triangle_setup.hpp, halfspace::triangle_setup()
// Latency:    6 cycles (SETUP_INTERVAL 3: 8).  Throughput: 1 triangle per SETUP_INTERVAL cycles.
// Handshake:  valid/ready; setup_o is stable while valid_o waits. Timing: docs/03_design/timing.md
// Registers:  1 vertices | 2 deltas, partial products | 3 differences, extents | 4 C, box
//             | 5 area, C at the root's origin, clamped box | 6 the packet
module hs_triangle_setup (
  input  logic                    clk_i,
  input  logic                    rst_ni,  // synchronous, active low
  input  hs_pkg::frame_state_t    frame_i,  // stable while busy_o
  output logic                    busy_o,

  input  logic                    valid_i,
  output logic                    ready_o,
  input  hs_pkg::triangle_t       triangle_i,

  output logic                    valid_o,
  input  logic                    ready_i,
  output hs_pkg::setup_triangle_t setup_o
);
  // --- Handshake ------------------------------------------------------------------------------
  logic       beat, last_beat;  // register 1 hands over a product, the last one
  logic       dropped6_q;       // what register 6 holds ends here
  logic [6:2] ready;
  logic [6:1] valid_q, load;  // load[n]: a packet enters register n
  always_comb begin
    ready[6] = !valid_q[6] || dropped6_q || ready_i;
    ready[5] = !valid_q[5] || ready[6];
    ready[4] = !valid_q[4] || ready[5];
    ready[3] = !valid_q[3] || ready[4];
    ready[2] = !valid_q[2] || ready[3];
  end
  assign load[6:3] = valid_q[5:2] & ready[6:3];
  assign load[2]   = beat && last_beat;
  assign load[1]   = valid_i && ready_o;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= '0;
    else valid_q <= load | (valid_q & ~{ready, ready_o});
  end

  assign ready_o = !valid_q[1] || (beat && last_beat);
  assign valid_o = valid_q[6] && !dropped6_q;
  assign busy_o  = |valid_q;

  // --- Register 1: the vertices, rotated by one for each beat -----------------------------------
  hs_pkg::triangle_t triangle1_q;
  if (hs_config_pkg::SETUP_INTERVAL == 1) begin : gen_beat
    assign beat      = valid_q[1] && ready[2];
    assign last_beat = 1'b1;
  end else begin : gen_beats
    logic [1:0] beat_q;
    assign beat      = valid_q[1] && (beat_q != 2'd0 || ready[2]);
    assign last_beat = beat_q == 2'd2;
    always_ff @(posedge clk_i) begin
      if (!rst_ni) beat_q <= 2'd0;
      else if (beat) beat_q <= last_beat ? 2'd0 : beat_q + 2'd1;
    end
  end

  always_ff @(posedge clk_i) begin
    if (load[1]) begin
      triangle1_q <= triangle_i;
    end else if (beat) begin
      triangle1_q.vertex0 <= triangle1_q.vertex1;
      triangle1_q.vertex1 <= triangle1_q.vertex2;
      triangle1_q.vertex2 <= triangle1_q.vertex0;
    end
  end

  // --- Register 2: products; with shared multipliers they shift in, edge 0 first -----------------
  hs_pkg::edge_product_t product_d0, product_d1, product_d2, product0_q, product1_q, product2_q;
  hs_pkg::point_t        vertex0_d, vertex1_d, vertex2_d, vertex0_q, vertex1_q, vertex2_q;
  logic [hs_pkg::TAG_BITS-1:0] tag2_q, tag3_q, tag4_q, tag5_q, tag6_q;

  hs_setup_product u_product0 (
    .i_i(triangle1_q.vertex0), .j_i(triangle1_q.vertex1), .product_o(product_d0));
  if (hs_config_pkg::SETUP_INTERVAL == 1) begin : gen_products
    hs_setup_product u_product1 (
      .i_i(triangle1_q.vertex1), .j_i(triangle1_q.vertex2), .product_o(product_d1));
    hs_setup_product u_product2 (
      .i_i(triangle1_q.vertex2), .j_i(triangle1_q.vertex0), .product_o(product_d2));
    assign vertex0_d = triangle1_q.vertex0;
    assign vertex1_d = triangle1_q.vertex1;
    assign vertex2_d = triangle1_q.vertex2;
  end else begin : gen_shared
    assign product_d1 = product2_q;
    assign product_d2 = product_d0;
    assign vertex0_d  = triangle1_q.vertex1;  // rotated twice when the last beat goes
    assign vertex1_d  = triangle1_q.vertex2;
    assign vertex2_d  = triangle1_q.vertex0;
  end

  always_ff @(posedge clk_i) begin
    if (beat) begin
      product0_q <= hs_config_pkg::SETUP_INTERVAL == 1 ? product_d0 : product1_q;
      product1_q <= product_d1;
      product2_q <= product_d2;
      vertex0_q  <= vertex0_d;
      vertex1_q  <= vertex1_d;
      vertex2_q  <= vertex2_d;
      tag2_q     <= triangle1_q.tag;
    end
    if (load[3]) tag3_q <= tag2_q;
    if (load[4]) tag4_q <= tag3_q;
    if (load[5]) tag5_q <= tag4_q;
    if (load[6]) tag6_q <= tag5_q;
  end

  // --- Registers 3 to 6: three edges and two axes ------------------------------------------------
  logic                                flipped5;
  logic signed [hs_pkg::AREA_BITS-1:0] constant0, constant1, constant2, area5_q;
  logic                                empty_x, empty_y;

  hs_setup_edge u_edge0 (
    .clk_i, .load_i(load[6:3]), .product_i(product0_q), .constant_o(constant0),
    .flip_i(flipped5), .slope_o(setup_o.slope0), .e_o(setup_o.e0), .corner_o(setup_o.corner0));
  hs_setup_edge u_edge1 (
    .clk_i, .load_i(load[6:3]), .product_i(product1_q), .constant_o(constant1),
    .flip_i(flipped5), .slope_o(setup_o.slope1), .e_o(setup_o.e1), .corner_o(setup_o.corner1));
  hs_setup_edge u_edge2 (
    .clk_i, .load_i(load[6:3]), .product_i(product2_q), .constant_o(constant2),
    .flip_i(flipped5), .slope_o(setup_o.slope2), .e_o(setup_o.e2), .corner_o(setup_o.corner2));

  // a < 0 when y grows along the edge, b < 0 when x falls.
  localparam int Sign = hs_pkg::DELTA_BITS - 1;
  logic [2:0] x_falls, y_grows, y_falls;
  assign x_falls = {product2_q.b[Sign], product1_q.b[Sign], product0_q.b[Sign]};
  assign y_grows = {product2_q.a[Sign], product1_q.a[Sign], product0_q.a[Sign]};
  assign y_falls = ~y_grows;

  hs_setup_box u_box_x (
    .clk_i, .load_i(load[6:3]), .v0_i(vertex0_q.x), .v1_i(vertex1_q.x), .v2_i(vertex2_q.x),
    .falls_i(x_falls), .size_i(frame_i.width), .empty_o(empty_x),
    .first_o(setup_o.box.x_first), .last_o(setup_o.box.x_last));
  hs_setup_box u_box_y (
    .clk_i, .load_i(load[6:3]), .v0_i(vertex0_q.y), .v1_i(vertex1_q.y), .v2_i(vertex2_q.y),
    .falls_i(y_falls), .size_i(frame_i.height), .empty_o(empty_y),
    .first_o(setup_o.box.y_first), .last_o(setup_o.box.y_last));

  // The area needs no multiplier: it is C0 + C1 + C2, of which only the bits it may have are added.
  logic culled, flipped6_q;
  assign flipped5 = area5_q[hs_pkg::AREA_BITS-1];
  always_comb begin
    case (frame_i.cull)
      hs_pkg::CULL_NONE: culled = 1'b0;
      hs_pkg::CULL_BACK: culled = !flipped5;
      hs_pkg::CULL_FRONT: culled = flipped5;
      default: culled = 1'b0;
    endcase
  end

  always_ff @(posedge clk_i) begin
    if (load[5]) area5_q <= (constant0 + constant1) + constant2;
    if (load[6]) begin
      flipped6_q <= flipped5;
      dropped6_q <= area5_q == '0 || culled || empty_x || empty_y;
    end
  end
  assign setup_o.flipped = flipped6_q;
  assign setup_o.tag     = tag6_q;
endmodule
