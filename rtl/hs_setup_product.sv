// SPDX-License-Identifier: Apache-2.0
//
// One edge's deltas and the partial products of its constant x_i y_j - x_j y_i. Each product is
// split at the middle of y, so that it takes two short cycles instead of a long one.
//
// Latency: combinational. Part of hs_triangle_setup.
module hs_setup_product (
  input  hs_pkg::point_t        i_i,
  input  hs_pkg::point_t        j_i,
  output hs_pkg::edge_product_t product_o
);
  localparam int Low = hs_pkg::VERTEX_LOW_BITS;
  localparam int High = hs_pkg::VERTEX_HIGH_BITS;

  logic signed [hs_pkg::VERTEX_BITS-1:0] xi, yi, xj, yj;
  assign xi = i_i.x;
  assign yi = i_i.y;
  assign xj = j_i.x;
  assign yj = j_i.y;

  logic signed [High-1:0] yi_high, yj_high;
  logic signed [Low:0]    yi_low, yj_low;
  assign yi_high = yi[hs_pkg::VERTEX_BITS-1:Low];
  assign yj_high = yj[hs_pkg::VERTEX_BITS-1:Low];
  assign yi_low  = {1'b0, yi[Low-1:0]};
  assign yj_low  = {1'b0, yj[Low-1:0]};

  logic signed [hs_pkg::DELTA_BITS-1:0]                    a, b;
  logic signed [hs_pkg::VERTEX_BITS+High-1:0]              ij_high, ji_high;
  logic signed [hs_pkg::VERTEX_BITS+hs_pkg::VERTEX_LOW_BITS-1:0] ij_low, ji_low;
  assign a       = hs_pkg::DELTA_BITS'(yi) - hs_pkg::DELTA_BITS'(yj);
  assign b       = hs_pkg::DELTA_BITS'(xj) - hs_pkg::DELTA_BITS'(xi);
  assign ij_high = xi * yj_high;
  assign ji_high = xj * yi_high;
  assign ij_low  = xi * yj_low;
  assign ji_low  = xj * yi_low;

  assign product_o.a       = a;
  assign product_o.b       = b;
  assign product_o.ij_high = ij_high;
  assign product_o.ij_low  = ij_low;
  assign product_o.ji_high = ji_high;
  assign product_o.ji_low  = ji_low;
endmodule
