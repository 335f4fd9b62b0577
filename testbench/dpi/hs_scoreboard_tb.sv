// SPDX-License-Identifier: Apache-2.0
//
// An example: hs_rasterizer with random triangles under hs_scoreboard. +triangles=N (a frame, 1000)
// +seed=N (1). Two frames: at full speed, and with the model's stall pattern. +no_reset: no reset
// between the two.
module hs_scoreboard_tb;
  localparam int V = hs_pkg::VERTEX_BITS;
  localparam int S = hs_pkg::S;
  // The frame, in pixels: less where the configuration's greatest is smaller.
  localparam int Most = 1 << hs_pkg::N;
  localparam int Width = Most < 200 ? Most : 200;
  localparam int Height = Most < 170 ? Most : 170;
  // The greatest coordinate. With a guard band of the frame's size its end is beyond the legal one.
  localparam int Last = (Width << S) - (hs_pkg::HAS_GUARD_BAND ? 1 : 0);
  // Vertices 1 and 2 are this many powers of two from vertex 0 at most: half a legal edge.
  localparam int Extent = hs_config_pkg::EXTENT_BITS;
  localparam int Reach = Extent == 0 ? 7 + S : Extent + S - 1;

  logic                   clk = 1'b0;
  logic                   rst_n = 1'b0;
  hs_pkg::frame_state_t   frame = '0;
  logic                   busy, in_valid, in_ready, out_valid, out_ready;
  hs_pkg::triangle_t      triangle;
  hs_pkg::coverage_tile_t coverage;
  real                    stall_probability = 0.0;
  longint unsigned        stall_seed = 1;

  hs_rasterizer u_dut (
    .clk_i(clk), .rst_ni(rst_n), .frame_i(frame), .busy_o(busy),
    .valid_i(in_valid), .ready_o(in_ready), .triangle_i(triangle),
    .valid_o(out_valid), .ready_i(out_ready), .coverage_o(coverage));

  hs_scoreboard u_scoreboard (
    .clk_i(clk), .rst_ni(rst_n), .frame_i(frame),
    .stall_probability_i(stall_probability), .stall_seed_i(stall_seed),
    .in_valid_i(in_valid), .in_ready_i(in_ready), .triangle_i(triangle),
    .out_valid_i(out_valid), .out_ready_i(out_ready), .coverage_i(coverage));

  always #1 clk = !clk;

  // A vertex near `near`, in range: a mix of tiny, middling and frame-sized triangles.
  int unsigned random_state;
  function automatic int unsigned random();
    random_state = random_state ^ (random_state << 13);
    random_state = random_state ^ (random_state >> 17);
    random_state = random_state ^ (random_state << 5);
    random = random_state;
  endfunction
  function automatic int clamp(input int value);
    clamp = value < 0 ? 0 : value > Last ? Last : value;
  endfunction
  function automatic hs_pkg::triangle_t random_triangle(input int number);
    int x, y, reach;
    x = int'(random() % (Width << S));
    y = int'(random() % (Width << S));
    reach = 2 + int'(random() % (6 + S));
    reach = 1 << (reach < Reach ? reach : Reach);
    random_triangle.vertex0.x = V'(x);
    random_triangle.vertex0.y = V'(y);
    random_triangle.vertex1.x = V'(clamp(x + int'(random() % (2 * reach)) - reach));
    random_triangle.vertex1.y = V'(clamp(y + int'(random() % (2 * reach)) - reach));
    random_triangle.vertex2.x = V'(clamp(x + int'(random() % (2 * reach)) - reach));
    random_triangle.vertex2.y = V'(clamp(y + int'(random() % (2 * reach)) - reach));
    random_triangle.tag = hs_pkg::TAG_BITS'(number);
  endfunction

  // Drives `count` triangles from the falling edge before clock 0 on.
  task automatic run_frame(input int count, input bit reset);
    int              sent;
    longint unsigned clock, offer, compared;
    compared = u_scoreboard.tiles;
    if (reset) rst_n = 1'b0;
    in_valid = 1'b0;
    out_ready = 1'b0;
    triangle = '0;
    frame.width = (hs_pkg::N + 1)'(Width);
    frame.height = (hs_pkg::N + 1)'(Height);
    frame.cull = hs_pkg::CULL_NONE;
    repeat (3) @(negedge clk);
    rst_n = 1'b1;
    sent = 0;
    clock = 0;
    offer = longint'(hs_model_pkg::hs_stall_gap(stall_probability, stall_seed, 0));
    triangle = random_triangle(0);
    while (sent < count || busy) begin
      in_valid = sent < count && clock >= offer;
      out_ready = hs_model_pkg::hs_stall_ready(stall_probability, stall_seed, clock) != 0;
      #0.5;  // a quarter of a clock: combinational ready settles
      if (in_valid && in_ready) begin
        sent = sent + 1;
        offer = clock + 1 +
                longint'(hs_model_pkg::hs_stall_gap(stall_probability, stall_seed, longint'(sent)));
        @(negedge clk);
        triangle = random_triangle(sent);
      end else begin
        @(negedge clk);
      end
      clock = clock + 1;
      if (clock > 1000000) $fatal(1, "bench: not empty after %0d clocks", clock);
    end
    in_valid = 1'b0;
    if (u_scoreboard.tiles == compared) $fatal(1, "bench: nothing was compared");
    u_scoreboard.finish();
  endtask

  int count;
  int seed;
  initial begin
    if ($value$plusargs("triangles=%d", count) == 0) count = 1000;
    if ($value$plusargs("seed=%d", seed) == 0) seed = 1;
    random_state = seed == 0 ? 1 : seed;
    run_frame(count, 1'b1);
    stall_probability = 0.3;
    stall_seed = longint'(seed);
    run_frame(count, $test$plusargs("no_reset") == 0);
    $display("seed %0d, %0d triangles, %0d tiles: bits and clocks are the model's", seed, 2 * count,
             u_scoreboard.tiles);
    $finish;
  end
endmodule
