// SPDX-License-Identifier: Apache-2.0
//
// The early depth test of one sample plane: a tile's lanes compared with its stored depths, which
// the lanes that pass replace. A tile of which no lane passes ends in the last register.
//
// A tile's word is read as it enters register 3 and written as it leaves. When the tile before it
// has the same slot, it takes that tile's result instead, so no tile ever waits for another's.
//
// Twin:       cmodel/depth.hpp, halfspace::depth_test()
// Latency:    4 cycles.  Throughput: 1 tile per cycle.
// Handshake:  valid/ready. Timing: docs/03_design/timing.md
// Registers:  1 plane | 2 rows' first lanes, columns' steps | 3 depths, beside the stored word
//             | 4 the lanes that passed
module hs_depth_test #(
  parameter int SlotsLog2 = hs_pkg::SLOTS_LOG2  // tiles stored
) (
  input  logic                  clk_i,
  input  logic                  rst_ni,   // synchronous, active low
  input  hs_pkg::depth_state_t  state_i,  // stable while busy_o
  output logic                  busy_o,

  input  logic                  valid_i,
  output logic                  ready_o,
  input  hs_pkg::depth_tile_t   tile_i,

  output logic                  valid_o,
  input  logic                  ready_i,
  output hs_pkg::depth_passed_t passed_o
);
  localparam int Grid = hs_pkg::GRID;
  localparam int Lanes = hs_pkg::LANES;
  localparam int Unit = hs_pkg::UNIT_BITS;
  localparam int Bits = hs_pkg::DEPTH_BITS;
  localparam int Lane = Bits + 1;  // a lane's depth, below whether the lane was ever drawn
  localparam int Slot = SlotsLog2;

  // --- Handshake ------------------------------------------------------------------------------
  logic       passed4;  // register 4 holds a lane that passed
  logic [4:1] valid_q, ready, load;
  always_comb begin
    ready[4] = !valid_q[4] || !passed4 || ready_i;
    ready[3] = !valid_q[3] || ready[4];
    ready[2] = !valid_q[2] || ready[3];
    ready[1] = !valid_q[1] || ready[2];
  end
  assign load = {valid_q[3:1], valid_i} & ready;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= '0;
    else valid_q <= load | (valid_q & ~ready);
  end
  assign ready_o = ready[1];
  assign valid_o = valid_q[4] && passed4;
  assign busy_o  = |valid_q;

  // --- Registers 1 to 3: the tile, and the same slot twice in a row ------------------------------
  hs_pkg::depth_tile_t tile1_q, tile2_q, tile3_q;
  logic                unused_tile;  // the planes are rows and columns by register 2
  assign unused_tile = ^{tile2_q, tile3_q};
  logic [Slot-1:0]  slot2, slot3;
  logic             writes, forwards3_q;
  assign slot2  = tile2_q.slot[Slot-1:0];
  assign slot3  = tile3_q.slot[Slot-1:0];
  assign writes = load[4];  // register 3's tile leaves
  // Rounds a depth when the lanes are cut to it.
  localparam logic [Unit-1:0] Half = Bits < 30 ? Unit'(1) << (29 - Bits) : '0;
  always_ff @(posedge clk_i) begin
    if (load[1]) begin
      tile1_q            <= tile_i;
      tile1_q.plane.base <= tile_i.plane.base + Half;
    end
    if (load[2]) tile2_q <= tile1_q;
    if (load[3]) begin
      tile3_q     <= tile2_q;
      forwards3_q <= writes && slot2 == slot3 && !tile2_q.fresh;
    end
  end

  // --- Registers 2 and 3: the lanes' depths ------------------------------------------------------
  logic [Grid*Unit-1:0]  column_d, column2_q, row_d, row2_q;
  logic [Lanes*Bits-1:0] depth3_q;
  hs_multiples u_columns (.value_i(tile1_q.plane.dx), .multiples_o(column_d));
  hs_multiples u_rows (.value_i(tile1_q.plane.dy), .multiples_o(row_d));
  for (genvar k = 0; k < Grid; k++) begin : gen_start
    always_ff @(posedge clk_i) begin
      if (load[2]) begin
        column2_q[k*Unit +: Unit] <= column_d[k*Unit +: Unit];
        row2_q[k*Unit +: Unit]    <= tile1_q.plane.base + row_d[k*Unit +: Unit];
      end
    end
  end
  for (genvar l = 0; l < Lanes; l++) begin : gen_depth
    logic [Unit-1:0] units;
    logic [Bits-1:0] whole;
    assign units = row2_q[l/Grid*Unit +: Unit] + column2_q[l%Grid*Unit +: Unit];
    if (Bits <= 30) begin : gen_cut
      assign whole = units[29 -: Bits];
    end else begin : gen_widened
      assign whole = {units[29:0], {(Bits-30){1'b0}}};
    end
    logic unused;  // what is finer than a depth
    assign unused = ^units;
    // Below the near plane 0, beyond the far plane all ones.
    always_ff @(posedge clk_i) begin
      if (load[3]) depth3_q[l*Bits +: Bits] <= (whole | {Bits{units[30]}}) & {Bits{!units[31]}};
    end
  end

  // --- Registers 3 and 4: compare ------------------------------------------------------------------
  logic [Lanes*Lane-1:0] read3, forwarded3_q, stored, merged;
  logic [Bits-1:0]       clear3_q;  // what a lane of a fresh slot begins with; else 0
  hs_slot_memory #(.Bits(Lanes * Lane), .Log2(Slot)) u_depths (
    .clk_i, .read_i(load[3]), .zero_i(tile2_q.fresh), .read_slot_i(slot2), .data_o(read3),
    .write_i(writes), .write_slot_i(slot3), .data_i(merged));
  always_ff @(posedge clk_i) begin
    if (load[3]) begin
      forwarded3_q <= merged;
      clear3_q     <= tile2_q.fresh ? state_i.clear : '0;
    end
  end
  assign stored = (forwards3_q ? forwarded3_q : read3) | {Lanes{1'b0, clear3_q}};

  logic [Lanes-1:0] pass;
  for (genvar l = 0; l < Lanes; l++) begin : gen_lane
    logic [Bits-1:0] depth, old;
    logic [Bits:0]   less;
    logic [Bits+1:0] less_equal;
    logic            wins, unused;
    assign depth      = depth3_q[l*Bits +: Bits];
    assign old        = stored[l*Lane +: Bits];
    // Two carry chains: equality as a tree of gates would be the slowest path, and the largest part.
    assign less       = {1'b0, depth} - {1'b0, old};
    assign less_equal = {1'b0, depth, 1'b0} - {1'b0, old, 1'b1};
    assign wins       = less[Bits] ? state_i.less :
                        less_equal[Bits+1] ? state_i.equal : state_i.greater;
    assign unused     = ^{less, less_equal};
    assign pass[l]    = wins && tile3_q.mask[l];
    assign merged[l*Lane +: Lane] = {stored[l*Lane+Bits] || pass[l], pass[l] ? depth : old};
  end

  hs_pkg::depth_passed_t passed4_q;
  always_ff @(posedge clk_i) begin
    if (load[4]) begin
      passed4_q.passed <= pass;
      passed4_q.slot   <= tile3_q.slot;
      passed4_q.index  <= tile3_q.index;
    end
  end
  assign passed4  = |passed4_q.passed;
  assign passed_o = passed4_q;
endmodule
