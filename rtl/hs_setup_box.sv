// SPDX-License-Identifier: Apache-2.0
//
// One axis of the sample box: the pixels of the frame that may hold a covered sample.
// Step 8 of docs/03_design/triangle_setup.md.
//
// Latency: registers 3 to 6 of hs_triangle_setup, which owns the handshake: load_i[n] fills
//          register n; empty_o belongs to what register 5 holds.
module hs_setup_box (
  input  logic                                  clk_i,
  input  logic [6:3]                            load_i,
  input  logic signed [hs_pkg::VERTEX_BITS-1:0] v0_i,
  input  logic signed [hs_pkg::VERTEX_BITS-1:0] v1_i,
  input  logic signed [hs_pkg::VERTEX_BITS-1:0] v2_i,
  input  logic [2:0]                            falls_i,  // bit i: vertex i+1 is before vertex i
  input  logic [hs_pkg::N:0]                    size_i,   // of the frame, px
  output logic                                  empty_o,
  output logic [hs_pkg::N-1:0]                  first_o,
  output logic [hs_pkg::N-1:0]                  last_o
);
  localparam int N = hs_pkg::N;
  localparam int F = hs_pkg::POSITION_BITS;
  localparam int Vertex = hs_pkg::VERTEX_BITS;
  localparam int Scaled = Vertex + F - hs_pkg::S + 1;  // S.f px, and room for the constants
  localparam int Pixel = Scaled - F;
  // Of 1/16 px in 2^-f px: the least and the greatest sample coordinate.
  localparam int Low = (hs_pkg::SAMPLE_LOW << F) >> 4;
  localparam int High = (hs_pkg::SAMPLE_HIGH << F) >> 4;
  localparam int FirstStep = (1 << F) - 1 - High;  // first = floor((v_min + FirstStep) / 2^f)
  localparam int LastStep = -1 - Low;              // last = floor((v_max + LastStep) / 2^f)

  logic signed [Vertex-1:0] min3_d, max3_d, min3_q, max3_q;
  logic signed [Scaled-1:0] min3, max3, first3, last3;
  logic signed [Pixel-1:0]  first4_q, last4_q;
  logic        [Pixel-2:0]  first5_q;  // may lie beyond the frame
  logic        [N-1:0]      limit, last5_q, first6_q, last6_q;
  logic                     before5_q;  // the box ends before the frame

  always_comb begin
    if (!falls_i[0]) begin
      min3_d = falls_i[2] ? v0_i : v2_i;
      max3_d = falls_i[1] ? v1_i : v2_i;
    end else begin
      min3_d = falls_i[1] ? v2_i : v1_i;
      max3_d = falls_i[2] ? v2_i : v0_i;
    end
  end

  assign min3   = Scaled'(min3_q) <<< (F - hs_pkg::S);
  assign max3   = Scaled'(max3_q) <<< (F - hs_pkg::S);
  assign first3 = min3 + Scaled'(FirstStep);
  assign last3  = max3 + Scaled'(LastStep);

  logic unused;
  assign unused = ^{first3[F-1:0], last3[F-1:0]};

  assign limit = N'(size_i - 1'b1);

  always_ff @(posedge clk_i) begin
    if (load_i[3]) begin
      min3_q <= min3_d;
      max3_q <= max3_d;
    end
    if (load_i[4]) begin
      first4_q <= first3[Scaled-1:F];
      last4_q  <= last3[Scaled-1:F];
    end
    if (load_i[5]) begin
      first5_q  <= first4_q[Pixel-1] ? '0 : first4_q[Pixel-2:0];
      last5_q   <= last4_q[Pixel-2:0] > (Pixel-1)'(limit) ? limit : last4_q[N-1:0];
      before5_q <= last4_q[Pixel-1];
    end
    if (load_i[6]) begin
      first6_q <= first5_q[N-1:0];
      last6_q  <= last5_q;
    end
  end

  assign empty_o = before5_q || first5_q > (Pixel-1)'(last5_q);
  assign first_o = first6_q;
  assign last_o  = last6_q;
endmodule
