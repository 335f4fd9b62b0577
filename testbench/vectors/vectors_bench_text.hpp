// SPDX-License-Identifier: Apache-2.0
//
// The files of vector_bench(), with @NAME@ where a set's own values go.
#pragma once

namespace halfspace {

// The bench, the same for every stage: only numbers differ.
inline constexpr const char* kBench =
    R"SV(// @PROGRAM@: vectors of @STAGE@. Do not edit: made by `halfspace vectors --bench`.
//
// Plays vectors.*.hex to hs_vectors_dut and compares. Ends with "PASS" and status 0, or with
// "FAIL", the first difference and another status.
//   +bits_only   packets and their order, not the clocks (a DUT with other latencies)
`timescale 1ns / 1ns
module hs_vectors_tb;
  localparam integer RunBits = @RUN_BITS@;
  localparam integer InBits = @IN_BITS@;
  localparam integer OutBits = @OUT_BITS@;
  localparam integer FrameBits = @FRAME_BITS@;
  localparam integer InPort = @IN_PORT@;
  localparam integer OutPort = @OUT_PORT@;
  localparam integer Runs = @RUNS@;
  localparam integer Inputs = @INPUTS@;
  localparam integer Outputs = @OUTPUTS@;
  localparam integer ReadyWords = @READY_WORDS@;
  localparam integer Clocked = @CLOCKED@;  // accept and out clocks are in the vectors
  localparam integer Patience = 100000;    // clocks without a handshake

  reg [RunBits-1:0] run_word   [0:Runs-1];
  reg [InBits-1:0]  in_word    [0:Inputs-1];
  reg [OutBits-1:0] out_word   [0:Outputs-1];
  reg [31:0]        ready_word [0:ReadyWords-1];

  reg                  clk, rst_n, valid, ready;
  reg  [FrameBits-1:0] frame;
  reg  [InPort-1:0]    in_port;
  wire                 busy_o, ready_o, valid_o;
  wire [OutPort-1:0]   out_port;
`ifdef HS_MUTSEL
  reg [31:0] mutsel;
`endif

  hs_vectors_dut u_dut (
`ifdef HS_MUTSEL
    .mutsel(mutsel),
`endif
    .clk_i(clk), .rst_ni(rst_n), .frame_i(frame), .busy_o(busy_o),
    .valid_i(valid), .ready_o(ready_o), .in_i(in_port),
    .valid_o(valid_o), .ready_i(ready), .out_o(out_port));

  integer r, i, o, i_end, o_end, owed, quiet, pattern, pattern_words, clock, clocks, failed;
  reg     clocked, waiting;
  reg [RunBits-1:0] run;
  reg [InBits-1:0]  in;
  reg [OutBits-1:0] out, held;
  reg [31:0]        offer, accept, due;

  task fail(input [8*48-1:0] what);
    begin
      if (failed == 0) begin
        $display("FAIL: %0s: run %0d clock %0d input %0d output %0d", what, r, clock, i, o);
        $display("  out_o %h", out_port);
        if (o < Outputs) $display("  want  %h", out[OutPort-1:0]);
      end
      failed = failed + 1;
    end
  endtask

  // Before the clock edge: inputs of this clock.
  task drive;
    begin
      in = i < i_end ? in_word[i] : {InBits{1'b0}};
      out = o < o_end ? out_word[o] : {OutBits{1'b0}};
@CLOCK_FIELDS@
      valid = i < i_end && (!clocked || clock >= offer);
      in_port = valid ? in[InPort-1:0] : {InPort{1'bx}};
      ready = 1'b1;
      if (pattern_words > 0) begin
        ready = ready_word[pattern + (clock / 32) % pattern_words][clock % 32];
      end
    end
  endtask

  // What the DUT says before the clock edge.
  task check;
    begin
      quiet = quiet + 1;
      if ((^{busy_o, ready_o, valid_o}) === 1'bx) fail("busy_o, ready_o or valid_o is unknown");
      if (owed > 0 && busy_o !== 1'b1) fail("busy_o is low with outputs to come");
      if (waiting && (valid_o !== 1'b1 || out_port !== held[OutPort-1:0])) begin
        fail("an output changed before it was taken");
      end
      if (valid && ready_o === 1'b1) begin
        if (clocked && clock != accept) fail("an input is accepted at another clock");
        owed = owed + in[InBits-1 -: 32];
        i = i + 1;
        quiet = 0;
      end else if (valid && clocked && clock >= accept) begin
        fail("an input is not accepted at its clock");
      end
      waiting = valid_o === 1'b1 && !ready;
      held[OutPort-1:0] = out_port;
      if (valid_o === 1'b1 && ready) begin
        quiet = 0;
        if (o >= o_end) begin
          fail("an output that is not expected");
        end else begin
          if (out_port !== out[OutPort-1:0]) fail("an output differs");
          if (clocked && clock != due) fail("an output leaves at another clock");
          owed = owed - 1;
          o = o + 1;
        end
      end else if (clocked && o < o_end && clock >= due) begin
        fail("an output does not leave at its clock");
      end
    end
  endtask

  task tick;
    begin
      clk = 1'b1;
      #1;
      clk = 1'b0;
      clock = clock + 1;
    end
  endtask

  // Counts of a run; reset for one clock.
  task begin_run;
    begin
      run = run_word[r];
      frame = run[FrameBits-1:0];
      i_end = i + run[RunBits-1 -: 32];
      o_end = o + run[RunBits-33 -: 32];
      clocks = run[RunBits-65 -: 32];
      pattern = pattern + pattern_words;
      pattern_words = 0;
      if (run[RunBits-97 -: 32] != 0) pattern_words = ((clocks == 0 ? 4096 : clocks) + 31) / 32;
      owed = 0;
      quiet = 0;
      waiting = 1'b0;
      rst_n = 1'b0;
      valid = 1'b0;
      in_port = {InPort{1'bx}};
      ready = 1'b0;
      #1;
      tick;
      rst_n = 1'b1;
      clock = 0;
    end
  endtask

  initial begin
`ifdef HS_MUTSEL
    mutsel = 32'd0;
    if (!$value$plusargs("mutsel=%d", mutsel)) mutsel = 32'd0;
`endif
    $readmemh("vectors.run.hex", run_word);
    $readmemh("vectors.in.hex", in_word);
    $readmemh("vectors.out.hex", out_word);
    $readmemh("vectors.ready.hex", ready_word);
    clocked = Clocked != 0 && !$test$plusargs("bits_only");
    clk = 1'b0;
    failed = 0;
    i = 0;
    o = 0;
    pattern = 0;
    pattern_words = 0;
    for (r = 0; r < Runs && failed == 0; r = r + 1) begin
      begin_run;
      // To the last output, and on until one that should not be there would have come.
      while (failed == 0 && (i < i_end || o < o_end || quiet < 64)) begin
        drive;
        #1;
        check;
        if (quiet > Patience) fail("no handshake for 100000 clocks");
        tick;
      end
      if (failed == 0 && busy_o !== 1'b0) fail("busy_o is high after the last output");
    end
    if (failed != 0) $fatal(1, "FAIL");
    else if (i != Inputs || o != Outputs || o == 0) $fatal(1, "FAIL: not all was compared");
    else $display("PASS: %0d inputs, %0d outputs, %0d runs", i, o, Runs);
    $finish;
  end
endmodule
)SV";

inline constexpr const char* kDut =
    R"SV(// @PROGRAM@: the design under test of hs_vectors_tb. To judge another
// design, connect it here: ports are packed as in hs_pkg.sv.
module hs_vectors_dut (
`ifdef HS_MUTSEL
  input  [31:0]             mutsel,
`endif
  input                     clk_i,
  input                     rst_ni,
  input  [@FRAME_BITS@-1:0] frame_i,
  output                    busy_o,
  input                     valid_i,
  output                    ready_o,
  input  [@IN_PORT@-1:0]    in_i,
  output                    valid_o,
  input                     ready_i,
  output [@OUT_PORT@-1:0]   out_o
);
@DUT@
endmodule
)SV";

inline constexpr const char* kIcarus = R"SH(#!/bin/sh
# @PROGRAM@: the bench in Icarus Verilog, on yosys's netlist of the RTL (Icarus 11 cannot read the
# source). Status 0 and "PASS", or another status.
# usage: run_icarus.sh RTL_FOLDER [BUILD_FOLDER]   or: NETLIST=F.v run_icarus.sh
set -eu
here=$(cd "$(dirname "$0")" && pwd)
build=${2:-$here/build_icarus}
mkdir -p "$build"
if [ -z "${NETLIST:-}" ]; then
  rtl=$(cd "${1:?usage: run_icarus.sh RTL_FOLDER [BUILD_FOLDER]}" && pwd)
  files=$here/hs_config_pkg.sv
  for file in $(cat "$rtl/rtl.f"); do files="$files $rtl/$file"; done
  NETLIST=$build/netlist.v
  yosys -q -p "read_verilog -sv $files; hierarchy -check @HIERARCHY@; rename -top @TOP@; \
    proc; flatten; opt -full; wreduce; peepopt; opt; clean -purge; \
    write_verilog -noattr $NETLIST"
fi
iverilog -g2012 -DHS_NETLIST -s hs_vectors_tb -o "$build/bench.vvp" \
  "$NETLIST" "$here/hs_vectors_dut.sv" "$here/hs_vectors_tb.sv"
cd "$here"
status=0
vvp -n "$build/bench.vvp" ${HS_PLUSARGS:-} >"$build/log.txt" 2>&1 || status=1
cat "$build/log.txt"
[ "$status" -eq 0 ]
grep -q '^PASS: ' "$build/log.txt"
)SH";

inline constexpr const char* kVerilator = R"SH(#!/bin/sh
# @PROGRAM@: the bench in Verilator (5.006 or later), on the RTL's source. Status 0 and "PASS", or
# another status.
# usage: run_verilator.sh RTL_FOLDER [BUILD_FOLDER]
set -eu
here=$(cd "$(dirname "$0")" && pwd)
rtl=$(cd "${1:?usage: run_verilator.sh RTL_FOLDER [BUILD_FOLDER]}" && pwd)
build=${2:-$here/build_verilator}
files=$here/hs_config_pkg.sv
for file in $(cat "$rtl/rtl.f"); do files="$files $rtl/$file"; done
mkdir -p "$build"
# shellcheck disable=SC2086
verilator --binary --timing --assert -O3 --x-assign unique --x-initial unique -CFLAGS -O1 \
  -Wno-fatal -Wno-lint -Wno-style --top-module hs_vectors_tb --Mdir "$build" -o bench \
  $files "$here/hs_vectors_dut.sv" "$here/hs_vectors_tb.sv" >"$build/build.txt" 2>&1 ||
  { cat "$build/build.txt"; exit 1; }
cd "$here"
"$build/bench" +verilator+rand+reset+2 +verilator+seed+7 ${HS_PLUSARGS:-} >"$build/log.txt" 2>&1 ||
  { cat "$build/log.txt"; exit 1; }
cat "$build/log.txt"
grep -q '^PASS: ' "$build/log.txt"
)SH";

inline constexpr const char* kMakefile = R"MK(# @PROGRAM@: make RTL=FOLDER icarus | verilator; clean
RTL ?= rtl
.PHONY: all icarus verilator clean
all: icarus verilator
icarus:
	./run_icarus.sh $(RTL)
verilator:
	./run_verilator.sh $(RTL)
clean:
	rm -rf build_icarus build_verilator
)MK";

}  // namespace halfspace
