// SPDX-License-Identifier: Apache-2.0
//
// One valid/ready handshake: once offered, a packet stays offered and does not change until taken.
//
// Bound to both ends of every stage; Verilator only.
module hs_handshake_checker #(
  parameter int Bits = 1
) (
  input logic            clk_i,
  input logic            rst_ni,
  input logic            valid_i,
  input logic            ready_i,
  input logic [Bits-1:0] packet_i
);
  // The clock is written out: with default clocking Verilator 5.006 fails on a module that is bound
  // in several sizes.
  assert_held : assert property (
      @(posedge clk_i) disable iff (!rst_ni) valid_i && !ready_i |=> valid_i && $stable(packet_i))
      else $error("offered packet withdrawn or changed");

  cover_stall : cover property (
      @(posedge clk_i) disable iff (!rst_ni) valid_i && !ready_i);
  cover_transfer : cover property (
      @(posedge clk_i) disable iff (!rst_ni) valid_i && ready_i);
endmodule
