// SPDX-License-Identifier: Apache-2.0
//
// floor(2^(2 Bits) / (2 m + 1)) of an m whose top bit is set: the reciprocal of the middle of
// [m, m + 1). Non-restoring: a negative remainder is put right by adding in the next digit, so a
// digit is one addition.
//
// Bits:    of m and of the result, even.
// Digits:  quotient bits a register; divides Bits.
//
// Twin:    cmodel/interpolation.hpp, halfspace::area_reciprocal(); cmodel/shading.hpp,
//          halfspace::reciprocal()
// Latency: Bits / Digits cycles, rigid.  Throughput: 1 a cycle.
module hs_reciprocal #(
  parameter int Bits = hs_pkg::AREA_RECIPROCAL_BITS,
  parameter int Digits = 1
) (
  input  logic            clk_i,
  input  logic [Bits-1:0] mantissa_i,   // top bit set
  output logic [Bits-1:0] reciprocal_o  // top bit set
);
  localparam int Registers = Bits / Digits;

  // Slice n: what register n holds, n = 0 being the input.
  logic [(Registers+1)*(Bits+1)-1:0] divisor;
  logic [(Registers+1)*(Bits+2)-1:0] remainder;  // signed
  logic [(Registers+1)*Bits-1:0]     quotient;
  assign divisor[0 +: Bits+1]   = {mantissa_i, 1'b1};
  assign remainder[0 +: Bits+2] = {2'b01, {Bits{1'b0}}};
  assign quotient[0 +: Bits]    = '0;
  assign reciprocal_o           = quotient[Registers*Bits +: Bits];
  logic unused;  // the last register's divisor and remainder
  assign unused = ^{divisor[Registers*(Bits+1) +: Bits+1], remainder[Registers*(Bits+2) +: Bits+2]};

  for (genvar n = 0; n < Registers; n++) begin : gen_register
    logic [Bits:0]   divisor_q;
    logic [Bits+1:0] remainder_d, remainder_q;
    logic [Bits-1:0] quotient_d, quotient_q;
    logic            negative;
    always_comb begin
      remainder_d = remainder[n*(Bits+2) +: Bits+2];
      quotient_d  = quotient[n*Bits +: Bits];
      negative    = 1'b0;
      for (int digit = 0; digit < Digits; digit++) begin
        negative    = remainder_d[Bits+1];
        // 2 w - d is 2 w + ~d + 1, and the 1 goes into the empty bit of 2 w.
        remainder_d = {remainder_d[Bits:0], !negative} +
                      ({1'b0, divisor[n*(Bits+1) +: Bits+1]} ^ {(Bits+2){!negative}});
        quotient_d  = {quotient_d[Bits-2:0], !remainder_d[Bits+1]};
      end
    end
    always_ff @(posedge clk_i) begin
      divisor_q   <= divisor[n*(Bits+1) +: Bits+1];
      remainder_q <= remainder_d;
      quotient_q  <= quotient_d;
    end
    assign divisor[(n+1)*(Bits+1) +: Bits+1]   = divisor_q;
    assign remainder[(n+1)*(Bits+2) +: Bits+2] = remainder_q;
    assign quotient[(n+1)*Bits +: Bits]        = quotient_q;
  end
endmodule
