// SPDX-License-Identifier: Apache-2.0
//
// One edge's value at a child's origin: e + 2^q c (A i + B j), saturated upwards.
//
// Latency: 1 cycle: load_i takes everything, e_o follows until the next load.
//          Part of hs_tile_traversal.
module hs_child_step #(
  parameter int Side = hs_pkg::GRID,
  parameter int ChildLog2 = hs_pkg::GRID_LOG2  // log2 of the child's side c, px
) (
  input  logic                                clk_i,
  input  logic                                load_i,
  input  logic [$clog2(Side)-1:0]             column_i,
  input  logic [$clog2(Side)-1:0]             row_i,
  input  hs_pkg::edge_slope_t                 slope_i,
  input  logic signed [hs_pkg::DELTA_BITS:0]  ab_i,  // A + B
  input  logic signed [hs_pkg::NODE_BASE_BITS+ChildLog2+hs_pkg::GRID_LOG2-1:0] e_i,  // at the node
  output logic signed [hs_pkg::ROOT_BITS-1:0] e_o   // at the child
);
  localparam int Delta = hs_pkg::DELTA_BITS;
  localparam int SideLog2 = $clog2(Side);
  localparam int Step = Delta + SideLog2 + 1;  // A i + B j
  localparam int Shift = ChildLog2 + hs_pkg::SAMPLE_BITS;
  localparam int ChildBits = hs_pkg::NODE_BASE_BITS + ChildLog2;
  localparam int NodeBits = ChildBits + hs_pkg::GRID_LOG2;

  logic signed [Delta-1:0] a, b;
  assign a = slope_i.a;
  assign b = slope_i.b;

  // One of 0, A, B, A + B for each bit of column and row, highest first.
  logic signed [Step-1:0] step, step_q;
  for (genvar n = 0; n < SideLog2; n++) begin : gen_bit
    logic signed [Delta:0]        part;
    logic signed [Delta+1+n:0] sum;  // of the parts up to this one
    always_comb begin
      case ({row_i[n], column_i[n]})
        2'd0: part = '0;
        2'd1: part = (Delta+1)'(a);
        2'd2: part = (Delta+1)'(b);
        default: part = ab_i;
      endcase
    end
    if (n == 0) begin : gen_first
      assign sum = (Delta+2)'(part);
    end else begin : gen_next
      assign sum = {(Delta+2)'(signed'(gen_bit[n-1].sum[Delta+n:n])) + (Delta+2)'(part),
                    gen_bit[n-1].sum[n-1:0]};
    end
  end
  assign step = gen_bit[SideLog2-1].sum[Step-1:0];

  logic signed [NodeBits-1:0] e_q;
  always_ff @(posedge clk_i) begin
    if (load_i) begin
      step_q <= step;
      e_q    <= e_i;
    end
  end

  // A live child's e is above -M; from M on it is clamped to M - 1.
  logic signed [NodeBits:0] sum;
  logic                     over;
  assign sum  = {(NodeBits+1-Shift)'(signed'(e_q[NodeBits-1:Shift])) + (NodeBits+1-Shift)'(step_q),
                 e_q[Shift-1:0]};
  assign over = !sum[NodeBits] && |sum[NodeBits-1:ChildBits-1];
  logic signed [ChildBits-1:0] e;
  assign e    = over ? {1'b0, {(ChildBits-1){1'b1}}} : sum[ChildBits-1:0];
  assign e_o  = hs_pkg::ROOT_BITS'(e);
endmodule
