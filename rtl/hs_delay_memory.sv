// SPDX-License-Identifier: Apache-2.0
//
// What came in so many clocks ago, in a memory: where registers would be many.
//
// Latency: Clocks cycles, 2 at least; rigid.
module hs_delay_memory #(
  parameter int Bits = 8,
  parameter int Clocks = 2
) (
  input  logic            clk_i,
  input  logic            rst_ni,  // synchronous, active low
  input  logic [Bits-1:0] data_i,
  output logic [Bits-1:0] data_o
);
  localparam int Log2 = $clog2(Clocks);
  logic [Log2-1:0] write_q, read;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) write_q <= '0;
    else write_q <= write_q + Log2'(1);
  end
  assign read = write_q - Log2'(Clocks - 1);
  hs_slot_memory #(.Bits(Bits), .Log2(Log2)) u_memory (
    .clk_i, .read_i(1'b1), .zero_i(1'b0), .read_slot_i(read), .data_o,
    .write_i(1'b1), .write_slot_i(write_q), .data_i);
endmodule
