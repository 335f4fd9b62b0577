// SPDX-License-Identifier: Apache-2.0
//
// A scoreboard for hs_rasterizer or a design with its ports: watches both handshakes, gives every
// accepted triangle to the model and compares every tile with what the model expects: place, tag,
// masks, and, with CheckClocks, the clock. Stops the simulation with $fatal at the first
// difference, naming the tile, and where a value that is compared is X or Z. The model takes its
// configuration from hs_config_pkg. Not for synthesis.
//
// A frame begins with the first triangle after reset or finish(), and has the frame_i of then.
// Clock 0 is the first edge after reset; without a reset between two frames, what makes the first
// triangle come at the model's clock. With CheckClocks the bench must follow the stall pattern of
// stall_probability_i and stall_seed_i (hs_stall_gap, hs_stall_ready).
module hs_scoreboard #(
  parameter bit CheckClocks = 1'b1
) (
  input logic                   clk_i,
  input logic                   rst_ni,
  input hs_pkg::frame_state_t   frame_i,
  input real                    stall_probability_i,
  input longint unsigned        stall_seed_i,

  input logic                   in_valid_i,
  input logic                   in_ready_i,
  input hs_pkg::triangle_t      triangle_i,

  input logic                   out_valid_i,
  input logic                   out_ready_i,
  input hs_pkg::coverage_tile_t coverage_i
);
  chandle          model = null;
  bit              begun = 1'b0;
  bit              counted = 1'b0;  // clock counts from a reset
  longint unsigned clock = 0;
  longint unsigned triangles = 0;
  longint unsigned tiles = 0;

  // The design's own free values.
  function automatic string configuration();
    string range, pixel, grid;
    range = $sformatf("\"viewport_bits\": %0d, \"guard_bits\": %0d, \"extent_bits\": %0d",
        hs_config_pkg::VIEWPORT_BITS, hs_config_pkg::GUARD_BITS, hs_config_pkg::EXTENT_BITS);
    pixel = $sformatf("\"subpixel_bits\": %0d, \"samples\": %0d",
        hs_config_pkg::SUBPIXEL_BITS, hs_config_pkg::SAMPLES);
    grid = $sformatf("\"grid_log2\": %0d, \"setup_interval\": %0d, \"tag_bits\": %0d",
        hs_config_pkg::GRID_LOG2, hs_config_pkg::SETUP_INTERVAL, hs_config_pkg::TAG_BITS);
    configuration = {"{", range, ", ", pixel, ", ", grid, "}"};
  endfunction

  // Sign-extended by the assignment of a signed net.
  function automatic int coordinate(input logic signed [hs_pkg::VERTEX_BITS-1:0] value);
    coordinate = int'(value);
  endfunction

  task automatic require_ok(input int status, input string what);
    if (status != hs_model_pkg::STATUS_OK) begin
      $fatal(1, "scoreboard: %s: %s", what, hs_model_pkg::hs_dpi_error());
    end
  endtask

  task automatic begin_frame();
    if (model == null) model = hs_model_pkg::hs_dpi_create(configuration());
    if (model == null) $fatal(1, "scoreboard: %s", hs_model_pkg::hs_dpi_error());
    require_ok(hs_model_pkg::hs_dpi_begin_frame(
        model, int'(frame_i.width), int'(frame_i.height), int'(frame_i.cull),
        stall_probability_i, stall_seed_i), "frame");
    begun = 1'b1;
    triangles = 0;
  endtask

  task automatic accept();
    longint unsigned expected;
    if ($isunknown(triangle_i) || $isunknown(frame_i)) begin
      $fatal(1, "scoreboard: triangle %0d: a bit of it or of the frame is X or Z", triangles);
    end
    if (!begun) begin_frame();
    require_ok(hs_model_pkg::hs_dpi_push_triangle(
        model, coordinate(triangle_i.vertex0.x), coordinate(triangle_i.vertex0.y),
        coordinate(triangle_i.vertex1.x), coordinate(triangle_i.vertex1.y),
        coordinate(triangle_i.vertex2.x), coordinate(triangle_i.vertex2.y),
        int'(triangle_i.tag)), "triangle");
    require_ok(hs_model_pkg::hs_dpi_accepted(model, triangles, expected), "triangle's clock");
    if (!counted) clock = expected;
    counted = 1'b1;
    if (CheckClocks && expected != clock) begin
      $fatal(1, "scoreboard: triangle %0d: accepted at clock %0d, model %0d", triangles, clock,
             expected);
    end
    triangles = triangles + 1;
  endtask

  task automatic compare();
    int              x, y, status;
    int unsigned     tag;
    longint unsigned expected;
    bit [hs_model_pkg::MASK_BITS-1:0] mask;
    if (!begun) $fatal(1, "scoreboard: tile %0d: before any triangle of its frame", tiles);
    status = hs_model_pkg::hs_dpi_pull_tile(model, x, y, tag, expected, mask);
    if (status == hs_model_pkg::STATUS_EMPTY) begin
      $fatal(1, "scoreboard: tile %0d at (%0d, %0d) tag %0d: the model expects none", tiles,
             coverage_i.x, coverage_i.y, coverage_i.tag);
    end
    require_ok(status, "tile");
    // !==, because != takes an X for equal.
    if (coverage_i.x !== hs_pkg::N'(x) || coverage_i.y !== hs_pkg::N'(y) ||
        coverage_i.tag !== hs_pkg::TAG_BITS'(tag)) begin
      $fatal(1, "scoreboard: tile %0d: dut (%0d, %0d) tag %0d, model (%0d, %0d) tag %0d", tiles,
             coverage_i.x, coverage_i.y, coverage_i.tag, x, y, tag);
    end
    for (int m = 0; m < hs_pkg::SAMPLES; m++) begin
      if (coverage_i.mask[m*hs_pkg::LANES +: hs_pkg::LANES] !== mask[m*64 +: hs_pkg::LANES]) begin
        $fatal(1, "scoreboard: tile %0d at (%0d, %0d) tag %0d sample %0d: dut mask %h, model %h",
               tiles, x, y, tag, m, coverage_i.mask[m*hs_pkg::LANES +: hs_pkg::LANES],
               mask[m*64 +: hs_pkg::LANES]);
      end
    end
    if (CheckClocks && expected != clock) begin
      $fatal(1, "scoreboard: tile %0d at (%0d, %0d) tag %0d: dut clock %0d, model %0d", tiles, x,
             y, tag, clock, expected);
    end
    tiles = tiles + 1;
  endtask

  always @(posedge clk_i) begin
    if (rst_ni !== 1'b1) begin
      clock = 0;
      begun = 1'b0;
      counted = 1'b1;
    end else begin
      if ($isunknown({in_valid_i, in_ready_i, out_valid_i, out_ready_i})) begin
        $fatal(1, "scoreboard: a valid or ready is X or Z at clock %0d", clock);
      end
      // A triangle's tiles come later than the triangle: the order of the two does not matter.
      if (in_valid_i && in_ready_i) accept();
      if (out_valid_i && out_ready_i) compare();
      clock = clock + 1;
    end
  end

  // To be called when the design is empty: nothing the model expects may be missing.
  task automatic finish();
    int              x, y;
    int unsigned     tag;
    longint unsigned expected;
    bit [hs_model_pkg::MASK_BITS-1:0] mask;
    if (begun && hs_model_pkg::hs_dpi_pull_tile(model, x, y, tag, expected, mask) ==
        hs_model_pkg::STATUS_OK) begin
      $fatal(1, "scoreboard: tile %0d at (%0d, %0d) tag %0d is missing: model clock %0d", tiles, x,
             y, tag, expected);
    end
    hs_model_pkg::hs_dpi_destroy(model);
    model = null;
    begun = 1'b0;
    counted = 1'b0;
  endtask
endmodule
