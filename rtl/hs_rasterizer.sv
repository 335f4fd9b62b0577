// SPDX-License-Identifier: Apache-2.0
//
// The rasterizer: triangles in, coverage tiles out. The only file that knows the order of the
// stages: triangle_setup, then LEVELS - 1 levels of tile_traversal, then coverage.
//
// Twin:       cmodel/rasterizer.hpp
// Latency:    triangle to first mask, SETUP_INTERVAL 1 and one sample: 9 + 5 (LEVELS - 1) cycles.
// Throughput: one leaf tile per cycle.
// Handshake:  valid/ready at both ends. Timing: docs/03_design/timing.md
// Visible:    a testbench reads the handshakes between stages by name (public_flat_rd): setup_*,
//             and link_*, bit or slice l the input of level l, LEVELS - 1 being coverage.
module hs_rasterizer (
  input  logic                   clk_i,
  input  logic                   rst_ni,  // synchronous, active low
  input  hs_pkg::frame_state_t   frame_i,  // stable while busy_o
  output logic                   busy_o,   // a packet is somewhere inside

  input  logic                   valid_i,
  output logic                   ready_o,
  input  hs_pkg::triangle_t      triangle_i,

  output logic                   valid_o,
  input  logic                   ready_i,
  output hs_pkg::coverage_tile_t coverage_o
);
  localparam int Levels = hs_pkg::LEVELS;
  localparam int Bits = hs_pkg::TRAVERSAL_BITS;

  logic                    setup_valid /*verilator public_flat_rd*/;
  logic                    setup_ready /*verilator public_flat_rd*/;
  hs_pkg::setup_triangle_t setup       /*verilator public_flat_rd*/;
  logic [Levels-1:0]       link_valid  /*verilator public_flat_rd*/;
  logic [Levels-1:0]       link_ready  /*verilator public_flat_rd*/;
  logic [Levels*Bits-1:0]  link_node   /*verilator public_flat_rd*/;
  logic [Levels:0]         busy;

  hs_triangle_setup u_setup (
    .clk_i, .rst_ni, .frame_i, .busy_o(busy[Levels]),
    .valid_i, .ready_o, .triangle_i,
    .valid_o(setup_valid), .ready_i(setup_ready), .setup_o(setup));

  // The root's node: origin (0, 0) and setup's edge values.
  hs_pkg::traversal_t root;
  always_comb begin
    root         = '0;
    root.node.e0 = setup.e0;
    root.node.e1 = setup.e1;
    root.node.e2 = setup.e2;
    root.slope0  = setup.slope0;
    root.slope1  = setup.slope1;
    root.slope2  = setup.slope2;
    root.box     = setup.box;
    root.tag     = setup.tag;
    root.corner0 = setup.corner0;
    root.corner1 = setup.corner1;
    root.corner2 = setup.corner2;
  end
  assign link_valid[0]        = setup_valid;
  assign link_node[0 +: Bits] = root;
  assign setup_ready          = link_ready[0];

  for (genvar l = 0; l < Levels - 1; l++) begin : gen_level
    hs_tile_traversal #(.Level(l)) u_traversal (
      .clk_i, .rst_ni, .busy_o(busy[l]),
      .valid_i(link_valid[l]), .ready_o(link_ready[l]), .node_i(link_node[l*Bits +: Bits]),
      .valid_o(link_valid[l+1]), .ready_i(link_ready[l+1]),
      .node_o(link_node[(l+1)*Bits +: Bits]));
  end

  hs_coverage u_coverage (
    .clk_i, .rst_ni, .busy_o(busy[Levels-1]),
    .valid_i(link_valid[Levels-1]), .ready_o(link_ready[Levels-1]),
    .tile_i(link_node[(Levels-1)*Bits +: Bits]),
    .valid_o, .ready_i, .coverage_o);

  assign busy_o = |busy;
endmodule
