// SPDX-License-Identifier: Apache-2.0
//
// What a quantity changes by along x, or along y, and how much of that lies between the plane's
// start and pixel (0, 0):
//
//   slope   = floor((d1 s2 + d2 s0) (2 r + 1) / 2^(32 + length - s - F))
//   to_zero = slope * centre
//
// both modulo 2^PLANE_BITS, S.F and S.(F+f) units.
//
// Latency:   10 cycles, rigid.  Throughput: 1 a cycle.  Part of hs_gradient.
// Registers: 1 products, slopes split in two | 2 their sums | 3 d1 s2 + d2 s0 | 4 to 6 times 2 r + 1
//            | 7 shifted | 8 to 10 times the way to the centre
module hs_gradient_axis (
  input  logic                                    clk_i,
  input  logic signed [hs_pkg::UNIT_BITS-1:0]     d1_i,  // value 1 - value 0
  input  logic signed [hs_pkg::UNIT_BITS-1:0]     d2_i,
  input  logic signed [hs_pkg::DELTA_BITS-1:0]    s2_i,
  input  logic signed [hs_pkg::DELTA_BITS-1:0]    s0_i,
  input  logic signed [hs_pkg::CENTRE_BITS-1:0]   centre_i,
  input  logic [hs_pkg::AREA_RECIPROCAL_BITS-1:0] reciprocal_i,
  input  logic [hs_pkg::LENGTH_BITS-1:0]          length_i,
  output logic [hs_pkg::PLANE_BITS-1:0]           slope_o,
  output logic [hs_pkg::PLANE_BITS-1:0]           to_zero_o
);
  localparam int Unit = hs_pkg::UNIT_BITS;
  localparam int Delta = hs_pkg::DELTA_BITS;
  localparam int Low = Delta / 2;
  localparam int High = Delta - Low;
  localparam int Sum = Unit + Delta;                           // of the two products
  localparam int Factor = hs_pkg::AREA_RECIPROCAL_BITS + 2;    // 2 r + 1, with a sign
  localparam int Bits = hs_pkg::PLANE_BITS;
  // The shift beyond the area's bits.
  localparam int Shift = hs_pkg::AREA_RECIPROCAL_BITS - hs_pkg::S - hs_pkg::GRADIENT_BITS;

  // --- Registers 1 to 3: d1 s2 + d2 s0 ------------------------------------------------------------
  logic signed [High-1:0] s2_high, s0_high;
  logic signed [Low:0]    s2_low, s0_low;
  assign s2_high = s2_i[Delta-1:Low];
  assign s0_high = s0_i[Delta-1:Low];
  assign s2_low  = {1'b0, s2_i[Low-1:0]};
  assign s0_low  = {1'b0, s0_i[Low-1:0]};

  logic signed [Unit+High-1:0] high2_q, high0_q;
  logic signed [Unit+Low:0]    low2_q, low0_q;
  logic signed [Unit+High-1:0] high_q;  // the sum fits, so this may wrap
  logic signed [Unit+Low+1:0]  low_q;
  logic signed [Sum-1:0]       sum_q;
  always_ff @(posedge clk_i) begin
    high2_q <= d1_i * s2_high;
    high0_q <= d2_i * s0_high;
    low2_q  <= d1_i * s2_low;
    low0_q  <= d2_i * s0_low;
    high_q  <= high2_q + high0_q;
    low_q   <= (Unit+Low+2)'(low2_q) + (Unit+Low+2)'(low0_q);
    sum_q   <= {(Sum-Low)'(low_q >>> Low) + high_q, low_q[Low-1:0]};
  end

  // --- Registers 4 to 7: over the doubled area -----------------------------------------------------
  logic [hs_pkg::AREA_RECIPROCAL_BITS-1:0] reciprocal3;
  logic [hs_pkg::LENGTH_BITS-1:0]          length6;
  logic signed [Sum+Factor-1:0]            product6;
  logic [Bits-1:0]                         slope7_q;
  hs_delay #(.Bits(hs_pkg::AREA_RECIPROCAL_BITS), .Clocks(3)) u_reciprocal (
    .clk_i, .data_i(reciprocal_i), .data_o(reciprocal3));
  hs_delay #(.Bits(hs_pkg::LENGTH_BITS), .Clocks(6)) u_length (
    .clk_i, .data_i(length_i), .data_o(length6));
  hs_wide_product #(.Value(Sum), .Factor(Factor)) u_over_area (
    .clk_i, .value_i(sum_q), .factor_i({1'b0, reciprocal3, 1'b1}), .product_o(product6));

  logic signed [Sum+Factor-Shift-1:0] whole, shifted;
  assign whole   = product6[Sum+Factor-1:Shift];
  assign shifted = whole >>> length6;
  always_ff @(posedge clk_i) slope7_q <= Bits'(shifted);
  logic unused;
  assign unused = ^{product6, shifted};

  // --- Registers 8 to 10: to the centre of pixel (0, 0) --------------------------------------------
  logic signed [hs_pkg::CENTRE_BITS-1:0] centre7;
  hs_delay #(.Bits(hs_pkg::CENTRE_BITS), .Clocks(7)) u_centre (
    .clk_i, .data_i(centre_i), .data_o(centre7));
  hs_wide_product #(.Value(Bits), .Factor(hs_pkg::CENTRE_BITS), .Product(Bits)) u_to_zero (
    .clk_i, .value_i(slope7_q), .factor_i(centre7), .product_o(to_zero_o));
  hs_delay #(.Bits(Bits), .Clocks(3)) u_slope (
    .clk_i, .data_i(slope7_q), .data_o(slope_o));
endmodule
