// SPDX-License-Identifier: Apache-2.0
//
// One quantity at three vertices in, its plane over the frame out: a product with the reciprocal of
// the doubled area, of which only the floor rounds.
//
// Interval: clocks from one quantity to the next. 1: x and y side by side; 2: one after the other
//           through the same multipliers.
//
// Twin:       cmodel/interpolation.hpp, halfspace::interpolation_setup(), halfspace::corner_plane()
// Latency:    13 cycles (Interval 2: 14), rigid.  Throughput: 1 quantity per Interval cycles.
// Registers:  1 differences | 2 to 11 hs_gradient_axis | (Interval 2: x waits for y)
//             | 12 the way to pixel (0, 0) | 13 the value there
module hs_gradient #(
  parameter int Interval = 1  // 1 or 2
) (
  input  logic                  clk_i,
  input  logic                  rst_ni,  // synchronous, active low
  input  logic                  valid_i,
  input  hs_pkg::gradient_t     gradient_i,
  output logic                  valid_o,
  output hs_pkg::corner_plane_t plane_o
);
  localparam int Unit = hs_pkg::UNIT_BITS;
  localparam int Bits = hs_pkg::PLANE_BITS;
  localparam int Axis = 10;                   // latency of hs_gradient_axis
  localparam int Latency = Axis + 2 + Interval;

  logic [Latency-1:0] valid_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= '0;
    else valid_q <= {valid_q[Latency-2:0], valid_i};
  end
  assign valid_o = valid_q[Latency-1];

  // --- Register 1: differences to vertex 0, value at the start --------------------------------------
  logic signed [Unit-1:0] value0, value1, value2, first, d1_q, d2_q, first_q;
  assign value0 = gradient_i.value0;
  assign value1 = gradient_i.value1;
  assign value2 = gradient_i.value2;
  assign first  = gradient_i.first == 2'd0 ? value0 : gradient_i.first == 2'd1 ? value1 : value2;

  hs_pkg::gradient_t gradient_q;
  logic              unused_values;  // they are differences by now
  assign unused_values = ^gradient_q;
  always_ff @(posedge clk_i) begin
    if (Interval == 1 || valid_i) begin
      d1_q       <= value1 - value0;
      d2_q       <= value2 - value0;
      first_q    <= first;
      gradient_q <= gradient_i;
    end else begin  // y in the place of x
      gradient_q.slope0.a <= gradient_q.slope0.b;
      gradient_q.slope2.a <= gradient_q.slope2.b;
      gradient_q.x        <= gradient_q.y;
    end
  end

  // --- Registers 2 to 11: both axes ------------------------------------------------------------------
  logic [Bits-1:0] dx, dy, x_to_zero, y_to_zero;
  if (Interval == 1) begin : gen_two
    hs_gradient_axis u_x (
      .clk_i, .d1_i(d1_q), .d2_i(d2_q), .s2_i(gradient_q.slope2.a), .s0_i(gradient_q.slope0.a),
      .centre_i(gradient_q.x), .reciprocal_i(gradient_q.reciprocal), .length_i(gradient_q.length),
      .slope_o(dx), .to_zero_o(x_to_zero));
    hs_gradient_axis u_y (
      .clk_i, .d1_i(d1_q), .d2_i(d2_q), .s2_i(gradient_q.slope2.b), .s0_i(gradient_q.slope0.b),
      .centre_i(gradient_q.y), .reciprocal_i(gradient_q.reciprocal), .length_i(gradient_q.length),
      .slope_o(dy), .to_zero_o(y_to_zero));
  end else begin : gen_one
    logic [Bits-1:0] dx_q, x_to_zero_q;
    hs_gradient_axis u_axis (
      .clk_i, .d1_i(d1_q), .d2_i(d2_q), .s2_i(gradient_q.slope2.a), .s0_i(gradient_q.slope0.a),
      .centre_i(gradient_q.x), .reciprocal_i(gradient_q.reciprocal), .length_i(gradient_q.length),
      .slope_o(dy), .to_zero_o(y_to_zero));
    always_ff @(posedge clk_i) begin
      dx_q        <= dy;
      x_to_zero_q <= y_to_zero;
    end
    assign dx        = dx_q;
    assign x_to_zero = x_to_zero_q;
  end

  // --- Registers 12 and 13: the value at pixel (0, 0) -------------------------------------------------
  localparam int Slope = hs_pkg::PLANE_SLOPE_BITS;
  localparam int Fraction = Bits - Unit;
  logic [Unit-1:0]   first12;
  logic [Slope-1:0]  dx12_q, dy12_q;
  logic [Fraction:0] low12_q;   // the sum of both ways below a unit, with its carry
  logic [Unit-1:0]   high12_q;  // and above, without it
  logic [Unit:0]     at_pixel0;
  hs_pkg::corner_plane_t plane_q;
  hs_delay #(.Bits(Unit), .Clocks(Latency - 2)) u_first (
    .clk_i, .data_i(first_q), .data_o(first12));
  always_ff @(posedge clk_i) begin
    low12_q           <= {1'b0, x_to_zero[Fraction-1:0]} + {1'b0, y_to_zero[Fraction-1:0]};
    high12_q          <= x_to_zero[Bits-1:Fraction] + y_to_zero[Bits-1:Fraction];
    dx12_q            <= dx[Slope-1:0];
    dy12_q            <= dy[Slope-1:0];
    plane_q.at_pixel0 <= {at_pixel0[Unit:1], low12_q[Fraction-1:0]};
    plane_q.dx        <= dx12_q;
    plane_q.dy        <= dy12_q;
  end
  assign at_pixel0 = {high12_q, 1'b1} + {first12, low12_q[Fraction]};
  assign plane_o   = plane_q;
  logic unused;  // bits that only the way to pixel (0, 0) takes, and the carry's place
  assign unused = ^{dx, dy, at_pixel0};
endmodule
