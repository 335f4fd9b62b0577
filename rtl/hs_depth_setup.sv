// SPDX-License-Identifier: Apache-2.0
//
// The reciprocal of a triangle's doubled area, and the plane of its depth.
//
// Interval: clocks from one triangle to the next, as in hs_gradient.
//
// Twin:       cmodel/interpolation.hpp, halfspace::area_reciprocal(), halfspace::interpolation_setup()
// Latency:    35 cycles to area_o, then 13 (Interval 2: 14) to plane_o; rigid.
// Throughput: 1 triangle per Interval cycles.
// Registers:  1 the triangle | 2 the area's leading zeros, the plane's start
//             | 3 its top 32 bits, the way to pixel (0, 0) | 4 to 35 their reciprocal; all else is
//             in a memory | hs_gradient
module hs_depth_setup #(
  parameter int Interval = 2  // 1 or 2
) (
  input  logic                       clk_i,
  input  logic                       rst_ni,  // synchronous, active low
  input  logic                       valid_i,
  input  hs_pkg::depth_setup_t       triangle_i,

  output logic                       area_valid_o,
  output hs_pkg::triangle_area_t     area_o,
  output logic                       valid_o,
  output hs_pkg::triangle_depth_t    plane_o
);
  localparam int Area = hs_pkg::AREA_BITS - 1;
  localparam int Reciprocal = hs_pkg::AREA_RECIPROCAL_BITS;
  localparam int Length = hs_pkg::LENGTH_BITS;
  localparam int Vertex = hs_pkg::VERTEX_BITS;
  localparam int Centre = hs_pkg::CENTRE_BITS;
  localparam int Latency = 3 + Reciprocal;

  logic [Latency-1:0] valid_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= '0;
    else valid_q <= {valid_q[Latency-2:0], valid_i};
  end

  // --- Registers 1 to 3 -----------------------------------------------------------------------
  hs_pkg::depth_setup_t triangle1_q, triangle2_q, triangle3_q;
  logic                 unused_triangle;  // area and vertices are used up by register 3
  assign unused_triangle = ^{triangle2_q, triangle3_q};

  logic [Length-1:0] length, length2_q, length3_q;
  always_comb begin
    length = '0;
    for (int k = 0; k < Area; k++) begin
      if (triangle1_q.area[k]) length = Length'(k + 1);
    end
  end

  // The topmost vertex, of two the one to the left.
  logic signed [Vertex-1:0] x0, y0, x1, y1, x2, y2;
  logic                     before10, before20, before21;
  logic [1:0]               first2_q, first3_q;
  assign x0 = triangle1_q.vertex0.x;
  assign y0 = triangle1_q.vertex0.y;
  assign x1 = triangle1_q.vertex1.x;
  assign y1 = triangle1_q.vertex1.y;
  assign x2 = triangle1_q.vertex2.x;
  assign y2 = triangle1_q.vertex2.y;
  assign before10 = y1 < y0 || (y1 == y0 && x1 < x0);
  assign before20 = y2 < y0 || (y2 == y0 && x2 < x0);
  assign before21 = y2 < y1 || (y2 == y1 && x2 < x1);

  hs_pkg::point_t            start;
  logic signed [Vertex-1:0]  start_x, start_y;
  logic signed [Centre-1:0]  x3_q, y3_q;
  localparam logic signed [Centre-1:0] Half = Centre'(1) <<< (hs_pkg::POSITION_BITS - 1);
  localparam int Up = hs_pkg::POSITION_BITS - hs_pkg::S;
  assign start   = first2_q == 2'd0 ? triangle2_q.vertex0 :
                   first2_q == 2'd1 ? triangle2_q.vertex1 : triangle2_q.vertex2;
  assign start_x = start.x;
  assign start_y = start.y;

  // The top 32 bits of the area, zeros below a narrower one.
  localparam int Wide = Area > Reciprocal ? Area : Reciprocal;
  logic [Wide-1:0]       shifted;
  logic [Reciprocal-1:0] mantissa3_q;
  assign shifted = (Wide'(triangle2_q.area) << (Wide - Area)) << (Length'(Area) - length2_q);

  always_ff @(posedge clk_i) begin
    triangle1_q <= triangle_i;
    triangle2_q <= triangle1_q;
    length2_q   <= length;
    first2_q    <= (before10 ? before21 : before20) ? 2'd2 : {1'b0, before10};
    triangle3_q <= triangle2_q;
    length3_q   <= length2_q;
    first3_q    <= first2_q;
    x3_q        <= Half - (Centre'(start_x) <<< Up);
    y3_q        <= Half - (Centre'(start_y) <<< Up);
    mantissa3_q <= shifted[Wide-1 -: Reciprocal];
  end
  logic unused;  // the area below its top 32 bits, the place of the reciprocal
  assign unused = ^{shifted, early};

  // --- Registers 4 to 35 ------------------------------------------------------------------------
  hs_pkg::gradient_t             early, gradient;
  logic [hs_pkg::INDEX_BITS-1:0] index;
  logic [Reciprocal-1:0]         reciprocal;
  always_comb begin
    early        = '0;
    early.value0 = triangle3_q.depth0;
    early.value1 = triangle3_q.depth1;
    early.value2 = triangle3_q.depth2;
    early.first  = first3_q;
    early.slope0 = triangle3_q.slope0;
    early.slope2 = triangle3_q.slope2;
    early.x      = x3_q;
    early.y      = y3_q;
    early.length = length3_q;
  end
  hs_reciprocal u_reciprocal (
    .clk_i, .mantissa_i(mantissa3_q), .reciprocal_o(reciprocal));
  localparam int Rest = hs_pkg::GRADIENT_BASE_BITS;  // without its last field, the reciprocal
  hs_delay_memory #(.Bits(Rest + hs_pkg::INDEX_BITS), .Clocks(Reciprocal)) u_rest (
    .clk_i, .rst_ni, .data_i({early[Reciprocal +: Rest], triangle3_q.index}),
    .data_o({gradient[Reciprocal +: Rest], index}));
  assign gradient[0 +: Reciprocal] = reciprocal;

  assign area_valid_o      = valid_q[Latency-1];
  assign area_o.reciprocal = reciprocal;
  assign area_o.length     = gradient.length;
  assign area_o.first      = gradient.first;
  assign area_o.x          = gradient.x;
  assign area_o.y          = gradient.y;
  assign area_o.index      = index;

  // --- The plane ----------------------------------------------------------------------------------
  hs_gradient #(.Interval(Interval)) u_gradient (
    .clk_i, .rst_ni, .valid_i(area_valid_o), .gradient_i(gradient),
    .valid_o, .plane_o(plane_o.plane));
  hs_delay #(.Bits(hs_pkg::INDEX_BITS), .Clocks(12 + Interval)) u_index (
    .clk_i, .data_i(index), .data_o(plane_o.index));
endmodule
