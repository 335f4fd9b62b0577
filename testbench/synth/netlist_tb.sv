// SPDX-License-Identifier: Apache-2.0
//
// Plays +stimulus=FILE (netlist_vectors.cpp) to hs_rasterizer and writes to +out=FILE, for every
// clock without reset, what the outputs are just before the edge:
// "CLOCK ready_o valid_o busy_o COVERAGE", COVERAGE being "-" while valid_o is low.
//
// The packet is unknown while it is not offered, so nothing may look at it then. For Verilator and
// Icarus alike, the design as source or as netlist: widths come as macros.
`timescale 1ns / 1ns
module netlist_tb;
  localparam integer Line = 3 + `FRAME_BITS + `TRIANGLE_BITS;
  reg [Line-1:0]           stimulus [0:`CLOCKS-1];
  reg                      clk, rst_n, ready, valid;
  reg [`FRAME_BITS-1:0]    frame;
  reg [`TRIANGLE_BITS-1:0] triangle;
  wire                      busy_o, ready_o, valid_o;
  wire [`COVERAGE_BITS-1:0] coverage_o;
  reg [8*1024-1:0]          path;
  integer                   clock, out;

  hs_rasterizer u_dut (
    .clk_i(clk), .rst_ni(rst_n), .frame_i(frame), .busy_o(busy_o),
    .valid_i(valid), .ready_o(ready_o), .triangle_i(triangle),
    .valid_o(valid_o), .ready_i(ready), .coverage_o(coverage_o));

  initial begin
    if (!$value$plusargs("stimulus=%s", path)) $finish;
    $readmemh(path, stimulus);
    if (!$value$plusargs("out=%s", path)) $finish;
    out = $fopen(path, "w");
    for (clock = 0; clock < `CLOCKS; clock = clock + 1) begin
      clk = 1'b0;
      {rst_n, ready, valid, frame, triangle} = stimulus[clock];
      if (!valid) triangle = {`TRIANGLE_BITS{1'bx}};
      #1;
      if (rst_n) begin
        $fwrite(out, "%0d %b %b %b ", clock, ready_o, valid_o, busy_o);
        if (valid_o === 1'b0) $fwrite(out, "-\n");
        else $fwrite(out, "%h\n", coverage_o);
      end
      clk = 1'b1;
      #1;
    end
    $fclose(out);
    $finish;
  end
endmodule
