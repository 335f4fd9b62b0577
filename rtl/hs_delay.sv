// SPDX-License-Identifier: Apache-2.0
//
// What came in so many clocks ago.
//
// Latency: Clocks cycles, rigid; 0 is a wire.
module hs_delay #(
  parameter int Bits = 8,
  parameter int Clocks = 1
) (
  input  logic            clk_i,
  input  logic [Bits-1:0] data_i,
  output logic [Bits-1:0] data_o
);
  if (Clocks == 0) begin : gen_wire
    assign data_o = data_i;
    logic unused;
    assign unused = clk_i;
  end else begin : gen_registers
    logic [Clocks*Bits-1:0] data_q;
    always_ff @(posedge clk_i) data_q <= (Clocks*Bits)'({data_q, data_i});
    assign data_o = data_q[(Clocks-1)*Bits +: Bits];
  end
endmodule
