// SPDX-License-Identifier: Apache-2.0
//
// The free values of test configuration `samples16`: sixteen samples, finer than the subpixels.
//
// Compile before rtl.f. Twin: testbench/rtl/rtl_configs.hpp; tests/config_package_test.cpp compares them.
`define HS_SUBPIXEL_BITS 2
`define HS_VIEWPORT_BITS 6
`define HS_GUARD_BITS 7
`define HS_EXTENT_BITS 0
`define HS_SAMPLES 16
`define HS_GRID_LOG2 2
`define HS_SETUP_INTERVAL 1
`define HS_TAG_BITS 8

package hs_config_pkg;
  localparam int SUBPIXEL_BITS /*verilator public*/ = `HS_SUBPIXEL_BITS;
  localparam int VIEWPORT_BITS /*verilator public*/ = `HS_VIEWPORT_BITS;
  localparam int GUARD_BITS /*verilator public*/ = `HS_GUARD_BITS;
  localparam int EXTENT_BITS /*verilator public*/ = `HS_EXTENT_BITS;
  localparam int SAMPLES /*verilator public*/ = `HS_SAMPLES;
  localparam int GRID_LOG2 /*verilator public*/ = `HS_GRID_LOG2;
  localparam int SETUP_INTERVAL /*verilator public*/ = `HS_SETUP_INTERVAL;
  localparam int TAG_BITS /*verilator public*/ = `HS_TAG_BITS;
endpackage
