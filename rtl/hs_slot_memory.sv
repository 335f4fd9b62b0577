// SPDX-License-Identifier: Apache-2.0
//
// A memory with a port to write and a port to read. A word that is read in the clock in which it is
// written is unknown.
//
// Latency: 1 cycle: read_i takes an address, the word stands at data_o until the next.
module hs_slot_memory #(
  parameter int Bits = 8,
  parameter int Log2 = 9
) (
  input  logic            clk_i,
  input  logic            read_i,
  input  logic            zero_i,  // the word read is 0, whatever is stored
  input  logic [Log2-1:0] read_slot_i,
  output logic [Bits-1:0] data_o,
  input  logic            write_i,
  input  logic [Log2-1:0] write_slot_i,
  input  logic [Bits-1:0] data_i
);
  logic [Bits-1:0] memory [0:(1<<Log2)-1];
  logic [Bits-1:0] data_q;
  always_ff @(posedge clk_i) begin
    if (write_i) memory[write_slot_i] <= data_i;
    if (read_i) begin
      if (zero_i) data_q <= '0;
      else data_q <= write_i && write_slot_i == read_slot_i ? 'x : memory[read_slot_i];
    end
  end
  assign data_o = data_q;
endmodule
