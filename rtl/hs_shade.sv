// SPDX-License-Identifier: Apache-2.0
//
// The colours of a tile's lanes that passed: groups of Fragments lanes, those without a lane that
// passed left out, one group a clock.
//
// Fragments: lanes of a group, side by side: 1; 4, two of two; 8, two rows of four (with a grid of
//            4 x 4 lanes two whole rows).
//
// Twin:       cmodel/shading.hpp, halfspace::shading(), of one sample
// Latency:    9 + RECIPROCAL_BITS / 2 cycles (odd: 9 + RECIPROCAL_BITS) to a tile's first group.
// Throughput: 1 group per cycle.
// Handshake:  valid/ready in; a group that comes out is not held up. Timing:
//             docs/03_design/timing.md
// Registers:  1 tile, hands over its groups | 2 the group's first lane: row, column | 3 their sum
//             | 4 each lane's values | hs_perspective
module hs_shade #(
  parameter int Fragments = 8,
  parameter int Channels = 3,
  localparam int GroupLog2 = $clog2(hs_pkg::LANES / Fragments),
  localparam int OutBits = hs_pkg::SLOTS_LOG2 + GroupLog2 + Fragments * (1 + 8 * Channels)
) (
  input  logic                clk_i,
  input  logic                rst_ni,  // synchronous, active low
  output logic                busy_o,

  input  logic                valid_i,
  output logic                ready_o,
  input  hs_pkg::shade_tile_t tile_i,

  output logic                valid_o,
  output logic [OutBits-1:0]  group_o  // slot, group, mask of its lanes, colour of each
);
  localparam int Grid = hs_pkg::GRID;
  localparam int Lanes = hs_pkg::LANES;
  localparam int Unit = hs_pkg::UNIT_BITS;
  localparam int Width = Fragments == 1 ? 1 : Fragments == 4 ? 2 : 4;
  localparam int Height = Fragments / Width;
  localparam int Columns = Grid / Width;  // of groups
  localparam int Groups = Lanes / Fragments;
  localparam int Planes = Channels + 1;

  // --- Register 1: the tile and the groups it has left ----------------------------------------------
  hs_pkg::shade_tile_t tile1_q;
  logic [Lanes-1:0]    lanes, lanes1_q;  // by group
  logic [Groups-1:0]   any, rest_q, lowest, rest;
  logic [GroupLog2-1:0] group;
  logic [2:0]           column, row;  // of the group's first lane
  for (genvar g = 0; g < Groups; g++) begin : gen_group
    for (genvar k = 0; k < Fragments; k++) begin : gen_lane
      assign lanes[g*Fragments + k] =
          tile_i.passed[(g/Columns*Height + k/Width)*Grid + g%Columns*Width + k%Width];
    end
    assign any[g] = |lanes[g*Fragments +: Fragments];
  end
  assign lowest  = rest_q & (~rest_q + Groups'(1));
  assign rest    = rest_q & ~lowest;
  assign ready_o = rest == '0;
  always_comb begin
    group  = '0;
    column = '0;
    row    = '0;
    for (int g = 0; g < Groups; g++) begin
      if (lowest[g]) begin
        group  = group | GroupLog2'(g);
        column = column | 3'(g % Columns * Width);
        row    = row | 3'(g / Columns * Height);
      end
    end
  end
  always_ff @(posedge clk_i) begin
    if (!rst_ni) rest_q <= '0;
    else if (ready_o) rest_q <= valid_i ? any : '0;
    else rest_q <= rest;
  end
  always_ff @(posedge clk_i) begin
    if (ready_o && valid_i) begin
      tile1_q  <= tile_i;
      lanes1_q <= lanes;
    end
  end

  // --- What goes along, from register 2 to the last -------------------------------------------------
  localparam int Reciprocal = hs_pkg::RECIPROCAL_BITS;
  localparam int Registers = 8 + (Reciprocal % 2 == 0 ? Reciprocal / 2 : Reciprocal);
  localparam int Color = 8 * Channels;
  logic [Registers-1:0] valid_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= '0;
    else valid_q <= {valid_q[Registers-2:0], |rest_q};
  end
  assign valid_o = valid_q[Registers-1];
  assign busy_o  = |{rest_q, valid_q};
  hs_delay #(.Bits(hs_pkg::SLOTS_LOG2 + GroupLog2 + Fragments), .Clocks(Registers)) u_along (
    .clk_i, .data_i({tile1_q.slot, group, lanes1_q[group*Fragments +: Fragments]}),
    .data_o(group_o[OutBits-1:Fragments*Color]));
  logic [Channels*8-1:0] level4;
  hs_delay #(.Bits(Channels * 8), .Clocks(3)) u_level (
    .clk_i, .data_i(tile1_q.level[Channels*8-1:0]), .data_o(level4));

  // --- Registers 2 to 4: planes at the group's lanes ------------------------------------------------
  logic [Planes*Fragments*Unit-1:0] value4_q;  // lane by lane, 1/w first
  for (genvar p = 0; p < Planes; p++) begin : gen_plane
    logic [Unit-1:0] base, dx, dy, across, down;
    logic [Unit-1:0] row2_q, column2_q, dx2_q, dy2_q, first3_q, dx3_q, dy3_q;
    assign {base, dx, dy} = tile1_q.planes[p*hs_pkg::TILE_PLANE_BITS +: hs_pkg::TILE_PLANE_BITS];
    hs_small_product u_across (.value_i(dx), .factor_i(column), .product_o(across));
    hs_small_product u_down (.value_i(dy), .factor_i(row), .product_o(down));
    always_ff @(posedge clk_i) begin
      column2_q <= across;
      row2_q    <= base + down;
      dx2_q     <= dx;
      dy2_q     <= dy;
      first3_q  <= row2_q + column2_q;
      dx3_q     <= dx2_q;
      dy3_q     <= dy2_q;
    end
    for (genvar k = 0; k < Fragments; k++) begin : gen_lane
      logic [Unit-1:0] along, below;
      // Written out: a written product would cost a multiplier block.
      if (k % Width == 3) begin : gen_three
        assign along = (dx3_q << 1) + dx3_q;
      end else begin : gen_shifted
        assign along = k % Width == 0 ? '0 : dx3_q << (k % Width - 1);
      end
      assign below = k / Width == 0 ? '0 : dy3_q;
      always_ff @(posedge clk_i) begin
        value4_q[(k*Planes + p)*Unit +: Unit] <= first3_q + (along + below);
      end
    end
    if (Fragments == 1) begin : gen_one
      logic unused;
      assign unused = ^{dx3_q, dy3_q};
    end
  end
  logic unused;  // the level of channels that are absent, and the mask, which is there by group
  assign unused = ^tile1_q;

  for (genvar k = 0; k < Fragments; k++) begin : gen_fragment
    hs_perspective #(.Channels(Channels)) u_perspective (
      .clk_i, .inverse_w_i(value4_q[k*Planes*Unit +: Unit]),
      .attribute_i(value4_q[(k*Planes + 1)*Unit +: Channels*Unit]), .level_i(level4),
      .color_o(group_o[k*Color +: Color]));
  end
endmodule
