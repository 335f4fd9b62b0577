// SPDX-License-Identifier: Apache-2.0
//
// One edge on its way through setup: partial products in, oriented and biased edge function out.
// Steps 3 to 7 of docs/03_design/triangle_setup.md.
//
// Latency: registers 3 to 6 of hs_triangle_setup, which owns the handshake: load_i[n] fills
//          register n. constant_o is register 4's C, modulo 2^AREA_BITS; flip_i belongs to what
//          register 5 holds.
module hs_setup_edge (
  input  logic                                 clk_i,
  input  logic [6:3]                           load_i,
  input  hs_pkg::edge_product_t                product_i,
  output logic signed [hs_pkg::AREA_BITS-1:0]  constant_o,
  input  logic                                 flip_i,
  output hs_pkg::edge_slope_t                  slope_o,
  output logic signed [hs_pkg::ROOT_BITS-1:0]  e_o,
  output hs_pkg::corner_t                      corner_o
);
  localparam int Delta = hs_pkg::DELTA_BITS;
  localparam int Low = hs_pkg::VERTEX_LOW_BITS;
  // E at the frame's corner, which is no sample: where edges may span the frame, one bit more than
  // at one.
  localparam int Edge = hs_pkg::EDGE_FULL_BITS + (hs_pkg::EXTENT_REACHED ? 1 : 0);
  localparam int Kept = hs_pkg::EDGE_BITS + (hs_pkg::EXTENT_REACHED ? 1 : 0);
  localparam int Constant = hs_pkg::CONSTANT_BITS;

  // Register 3: the differences of the high and of the low partial products.
  logic signed [hs_pkg::VERTEX_BITS+hs_pkg::VERTEX_HIGH_BITS-1:0] ij_high, ji_high;
  logic signed [hs_pkg::VERTEX_BITS+Low-1:0]                      ij_low, ji_low;
  logic signed [hs_pkg::VERTEX_BITS+hs_pkg::VERTEX_HIGH_BITS:0]   high3_q;
  logic signed [hs_pkg::VERTEX_BITS+Low:0]                        low3_q;
  logic signed [Delta-1:0]                                        a3_q, b3_q;
  assign ij_high = product_i.ij_high;
  assign ji_high = product_i.ji_high;
  assign ij_low  = product_i.ij_low;
  assign ji_low  = product_i.ji_low;

  always_ff @(posedge clk_i) begin
    if (load_i[3]) begin
      high3_q <= ij_high - ji_high;
      low3_q  <= ij_low - ji_low;
      a3_q    <= product_i.a;
      b3_q    <= product_i.b;
    end
  end

  // Register 4: C at the frame's corner, and one pixel's diagonal step.
  logic signed [Constant-Low-1:0]          high3, low3;
  logic signed [Constant-1:0]              constant4_q;
  logic signed [Delta-1:0]                 a4_q, b4_q;
  logic signed [Delta:0]                   diagonal4_q;
  logic                                    a_zero4_q, b_zero4_q;
  assign high3 = (Constant-Low)'(high3_q);  // C fits, so the bits above repeat its sign
  assign low3  = (Constant-Low)'(signed'(low3_q[hs_pkg::VERTEX_BITS+Low:Low]));

  always_ff @(posedge clk_i) begin
    if (load_i[4]) begin
      constant4_q <= {high3 + low3, low3_q[Low-1:0]};
      a4_q        <= a3_q;
      b4_q        <= b3_q;
      diagonal4_q <= a3_q + b3_q;
      a_zero4_q   <= a3_q == '0;
      b_zero4_q   <= b3_q == '0;
    end
  end
  assign constant_o = hs_pkg::AREA_BITS'(constant4_q);

  // Register 5: C at the root's origin. Half a pixel further for one sample.
  logic signed [Edge-1:0]  corner4, half4, edge5_q;
  logic signed [Delta-1:0] a5_q, b5_q;
  logic                    a_zero5_q, b_zero5_q;
  assign corner4 = Edge'(constant4_q) <<< (hs_pkg::POSITION_BITS - hs_pkg::S);
  if (hs_pkg::SAMPLES == 1) begin : gen_half
    assign half4 = Edge'(diagonal4_q) <<< (hs_pkg::POSITION_BITS - 1);
  end else begin : gen_no_half
    assign half4 = '0;
    logic unused;
    assign unused = ^diagonal4_q;
  end

  always_ff @(posedge clk_i) begin
    if (load_i[5]) begin
      edge5_q   <= corner4 + half4;
      a5_q      <= a4_q;
      b5_q      <= b4_q;
      a_zero5_q <= a_zero4_q;
      b_zero5_q <= b_zero4_q;
    end
  end

  // Register 6: orient, bias, drop bits, saturate.
  logic                    a_above, b_above, top_left;
  logic signed [Delta-1:0] a5, b5;
  logic signed [Edge-1:0]  flipped5, bias5, biased5;
  logic signed [Kept-1:0]  kept5;
  assign a_above  = (a5_q[Delta-1] == flip_i) && !a_zero5_q;
  assign b_above  = (b5_q[Delta-1] == flip_i) && !b_zero5_q;
  assign top_left = a_above || (a_zero5_q && b_above);
  assign a5       = flip_i ? -a5_q : a5_q;
  assign b5       = flip_i ? -b5_q : b5_q;
  // -E = ~E + 1 and the bias of -1 make one addition of -1, 0 or 1.
  assign flipped5 = edge5_q ^ {Edge{flip_i}};
  assign bias5    = {{(Edge-1){!flip_i && !top_left}}, flip_i == top_left};
  assign biased5  = flipped5 + bias5;
  assign kept5    = biased5[Edge-1:hs_pkg::DROPPED_BITS];
  logic unused;
  assign unused = ^{high3_q, biased5};

  logic signed [hs_pkg::ROOT_BITS-1:0] e5;
  if (Kept > hs_pkg::ROOT_BITS) begin : gen_saturate
    logic over;
    assign over = kept5[Kept-2:hs_pkg::ROOT_BITS-1] != {(Kept-hs_pkg::ROOT_BITS){kept5[Kept-1]}};
    assign e5   = over ? {kept5[Kept-1], {(hs_pkg::ROOT_BITS-1){!kept5[Kept-1]}}}
                       : kept5[hs_pkg::ROOT_BITS-1:0];
  end else begin : gen_fits
    assign e5 = hs_pkg::ROOT_BITS'(kept5);
  end

  // The corner: of the extreme sample offsets, the one furthest inside, seen from the next pixel.
  localparam int Unit = 4 - hs_pkg::SAMPLE_BITS;
  localparam int Last = hs_pkg::SAMPLES == 1 ? 1 : (16 - hs_pkg::SAMPLE_HIGH) >> Unit;
  localparam int First = hs_pkg::SAMPLES == 1 ? 0 : hs_pkg::SAMPLE_LOW >> Unit;
  localparam int Inset = hs_pkg::INSET_BITS;
  logic [hs_pkg::REACH_BITS-1:0] a_reach, b_reach, reach5;
  logic [Inset-1:0]              a_inset, b_inset, inset5;
  assign a_reach = a_above ? a5 : '0;
  assign b_reach = b_above ? b5 : '0;
  assign reach5  = a_reach + b_reach;
  if (First == 0 && Last == 1) begin : gen_inset_reach
    assign a_inset = Inset'(a_reach);
    assign b_inset = Inset'(b_reach);
  end else begin : gen_inset_both
    logic [Delta-1:0] a_size, b_size;
    assign a_size  = a5_q[Delta-1] ? -a5_q : a5_q;
    assign b_size  = b5_q[Delta-1] ? -b5_q : b5_q;
    assign a_inset = a_above ? Inset'(a_size) * Inset'(Last) : Inset'(a_size) * Inset'(First);
    assign b_inset = b_above ? Inset'(b_size) * Inset'(Last) : Inset'(b_size) * Inset'(First);
  end
  assign inset5 = a_inset + b_inset;

  logic signed [Delta-1:0]             a6_q, b6_q;
  logic signed [hs_pkg::ROOT_BITS-1:0] e6_q;
  logic [hs_pkg::REACH_BITS-1:0]       reach6_q;
  logic [Inset-1:0]                    inset6_q;

  always_ff @(posedge clk_i) begin
    if (load_i[6]) begin
      a6_q     <= a5;
      b6_q     <= b5;
      e6_q     <= e5;
      reach6_q <= reach5;
      inset6_q <= inset5;
    end
  end
  assign slope_o.a      = a6_q;
  assign slope_o.b      = b6_q;
  assign e_o            = e6_q;
  assign corner_o.reach = reach6_q;
  assign corner_o.inset = inset6_q;
endmodule
