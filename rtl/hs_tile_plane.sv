// SPDX-License-Identifier: Apache-2.0
//
// A triangle's planes moved to one of its tiles.
//
// Planes:    quantities moved side by side.
// SideBits:  of what rides along.
//
// Twin:       cmodel/interpolation.hpp, halfspace::tile_plane()
// Latency:    3 cycles.  Throughput: 1 tile per cycle.
// Handshake:  valid/ready; register 1 is the table's that the planes are read from.
//             Timing: docs/03_design/timing.md
// Registers:  2 products | 3 their sum | 4 the planes over the tile
module hs_tile_plane #(
  parameter int Planes = 1,
  parameter int SideBits = 1,
  localparam int InBits = Planes * hs_pkg::CORNER_PLANE_BITS + 2 * hs_pkg::TILE_BITS + SideBits,
  localparam int OutBits = Planes * hs_pkg::TILE_PLANE_BITS + SideBits
) (
  input  logic               clk_i,
  input  logic               rst_ni,  // synchronous, active low
  output logic               busy_o,

  input  logic               valid_i,
  output logic               ready_o,
  input  logic [InBits-1:0]  tile_i,  // corner_plane_t each, tile's column, row, what rides along

  output logic               valid_o,
  input  logic               ready_i,
  output logic [OutBits-1:0] plane_o  // tile_plane_t each, what rides along
);
  // --- Handshake ------------------------------------------------------------------------------
  logic [4:2] valid_q, ready, load;
  always_comb begin
    ready[4] = !valid_q[4] || ready_i;
    ready[3] = !valid_q[3] || ready[4];
    ready[2] = !valid_q[2] || ready[3];
  end
  assign load = {valid_q[3:2], valid_i} & ready;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= '0;
    else valid_q <= load | (valid_q & ~ready);
  end
  assign ready_o = ready[2];
  assign valid_o = valid_q[4];
  assign busy_o  = |valid_q;

  // --- What rides along -------------------------------------------------------------------------
  logic [SideBits-1:0] side2_q, side3_q, side4_q;
  always_ff @(posedge clk_i) begin
    if (load[2]) side2_q <= tile_i[SideBits-1:0];
    if (load[3]) side3_q <= side2_q;
    if (load[4]) side4_q <= side3_q;
  end
  assign plane_o[SideBits-1:0] = side4_q;

  // --- Registers 2 to 4: one plane ----------------------------------------------------------------
  localparam int Unit = hs_pkg::UNIT_BITS;
  localparam int Fraction = hs_pkg::GRADIENT_BITS;
  localparam int Bits = hs_pkg::PLANE_BITS;
  localparam int Low = hs_pkg::POSITION_BITS + hs_pkg::GRID_LOG2;  // below a tile's step
  localparam int Step = Bits - Low;
  localparam int Tile = hs_pkg::TILE_BITS;
  logic [Tile-1:0] column, row;
  assign column = tile_i[SideBits+Tile +: Tile];
  assign row    = tile_i[SideBits +: Tile];

  for (genvar p = 0; p < Planes; p++) begin : gen_plane
    localparam int Slope = hs_pkg::PLANE_SLOPE_BITS;
    localparam int At = SideBits + 2 * Tile + p * hs_pkg::CORNER_PLANE_BITS;
    logic [Bits-1:0]  at_pixel0, at2_q, at3_q, sum;
    logic [Slope-1:0] dx, dy;
    logic [Step-1:0]  x2_q, y2_q, sum3_q;
    logic [Unit-1:0]  dx_rounded, dy_rounded, dx2_q, dy2_q, dx3_q, dy3_q, dx4_q, dy4_q, base4_q;
    assign {at_pixel0, dx, dy} = tile_i[At +: hs_pkg::CORNER_PLANE_BITS];
    if (Fraction > 0) begin : gen_round
      assign dx_rounded = dx[Fraction +: Unit] + Unit'(dx[Fraction-1]);
      assign dy_rounded = dy[Fraction +: Unit] + Unit'(dy[Fraction-1]);
    end else begin : gen_whole
      assign dx_rounded = dx[Unit-1:0];
      assign dy_rounded = dy[Unit-1:0];
    end
    assign sum = {at3_q[Bits-1:Low] + sum3_q, at3_q[Low-1:0]};

    always_ff @(posedge clk_i) begin
      if (load[2]) begin
        at2_q <= at_pixel0;
        x2_q  <= dx[Step-1:0] * Step'(column);
        y2_q  <= dy[Step-1:0] * Step'(row);
        dx2_q <= dx_rounded;
        dy2_q <= dy_rounded;
      end
      if (load[3]) begin
        at3_q  <= at2_q;
        sum3_q <= x2_q + y2_q;
        dx3_q  <= dx2_q;
        dy3_q  <= dy2_q;
      end
      if (load[4]) begin
        base4_q <= sum[Bits-1 -: Unit];
        dx4_q   <= dx3_q;
        dy4_q   <= dy3_q;
      end
    end
    assign plane_o[SideBits + p*hs_pkg::TILE_PLANE_BITS +: hs_pkg::TILE_PLANE_BITS] =
        {base4_q, dx4_q, dy4_q};
    logic unused;  // what is finer than a unit
    assign unused = ^{sum, dx, dy};
  end
endmodule
