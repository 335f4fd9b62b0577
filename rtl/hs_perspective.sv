// SPDX-License-Identifier: Apache-2.0
//
// One fragment's channels: each attribute less its level over w, divided by 1/w, and the level
// added. One reciprocal for all channels.
//
// Twin:      cmodel/shading.hpp, halfspace::perspective()
// Latency:   5 + RECIPROCAL_BITS / 2 cycles (odd: 5 + RECIPROCAL_BITS), rigid.  Throughput: 1 fragment a cycle.
// Registers: 1 1/w at least 1 | 2 its leading zeros, attributes clamped | 3 both shifted and cut
//            | the reciprocal's | one before the last: products | last: rounded, level added
module hs_perspective #(
  parameter int Channels = 3
) (
  input  logic                                  clk_i,
  input  logic [hs_pkg::UNIT_BITS-1:0]          inverse_w_i,  // units
  input  logic [Channels*hs_pkg::UNIT_BITS-1:0] attribute_i,  // units
  input  logic [Channels*8-1:0]                 level_i,
  output logic [Channels*8-1:0]                 color_o
);
  localparam int Unit = hs_pkg::UNIT_BITS;
  localparam int Reciprocal = hs_pkg::RECIPROCAL_BITS;
  localparam int Digits = Reciprocal % 2 == 0 ? 2 : 1;
  localparam int Wait = Reciprocal / Digits;
  localparam int Numerator = 16;

  // --- Registers 1 to 3: 1/w ------------------------------------------------------------------
  logic [Unit-1:0]       w1_q, w2_q, w_shifted;
  logic [4:0]            zeros, zeros2_q;
  logic [Reciprocal-1:0] mantissa3_q, reciprocal;
  always_comb begin
    zeros = 5'd31;
    for (int k = 0; k < Unit; k++) begin
      if (w1_q[k]) zeros = 5'(Unit - 1 - k);
    end
  end
  assign w_shifted = w2_q << zeros2_q;
  always_ff @(posedge clk_i) begin
    w1_q        <= inverse_w_i[Unit-1] || inverse_w_i == '0 ? Unit'(1) : inverse_w_i;
    w2_q        <= w1_q;
    zeros2_q    <= zeros;
    mantissa3_q <= w_shifted[Unit-1 -: Reciprocal];
  end
  hs_reciprocal #(.Bits(Reciprocal), .Digits(Digits)) u_reciprocal (
    .clk_i, .mantissa_i(mantissa3_q), .reciprocal_o(reciprocal));

  // --- Every register: the channels ----------------------------------------------------------------
  localparam int Shift = Reciprocal + Numerator - 1 - 8;
  localparam int Product = Reciprocal + Numerator;
  logic [Channels*8-1:0] level_last;
  hs_delay #(.Bits(Channels * 8), .Clocks(4 + Wait)) u_level (
    .clk_i, .data_i(level_i), .data_o(level_last));
  for (genvar c = 0; c < Channels; c++) begin : gen_channel
    logic [Unit-1:0]      attribute1_q, attribute2_q, shifted;
    logic [Unit:0]        over;
    logic [Numerator-1:0] numerator3_q, numerator_late;
    logic [Product-1:0]   product_q;
    logic [Product:0]     rounded;
    logic [9:0]           value;  // quotient, at most 256, and level
    logic [7:0]           color_q;
    assign over    = {1'b0, w1_q} - {1'b0, attribute1_q};  // its top bit: the attribute is greater
    assign shifted = attribute2_q << zeros2_q;
    hs_delay #(.Bits(Numerator), .Clocks(Wait)) u_numerator (
      .clk_i, .data_i(numerator3_q), .data_o(numerator_late));
    assign rounded = {1'b0, product_q} + ((Product+1)'(1) << (Shift - 1));
    assign value   = 10'(rounded[Product:Shift]) + {2'b00, level_last[c*8 +: 8]};
    always_ff @(posedge clk_i) begin
      attribute1_q <= attribute_i[c*Unit +: Unit];
      attribute2_q <= attribute1_q[Unit-1] ? '0 : over[Unit] ? w1_q : attribute1_q;
      numerator3_q <= shifted[Unit-1 -: Numerator];
      product_q  <= Product'(numerator_late) * Product'(reciprocal);
      color_q    <= value[9] || value[8] ? 8'd255 : value[7:0];
    end
    assign color_o[c*8 +: 8] = color_q;
    logic unused;  // below what is kept
    assign unused = ^{shifted, over, rounded};
  end
  logic unused;
  assign unused = ^w_shifted;
endmodule
