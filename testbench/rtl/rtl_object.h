/* SPDX-License-Identifier: Apache-2.0
 *
 * The Verilated RTL of one configuration, as a shared object that rtl_build.hpp makes and
 * rtl_rasterizer.hpp loads. Packets cross as words: packed SystemVerilog structs, 32 bits a word,
 * least significant first (testbench/vectors/layout.hpp has their fields).
 */
#ifndef HALFSPACE_RTL_OBJECT_H
#define HALFSPACE_RTL_OBJECT_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Grows with every change of this file: an object of another version is not loaded. */
#define HS_RTL_OBJECT_VERSION 1

/* One rasterizer. Objects share nothing: each may be used by a thread of its own. */
typedef struct hs_rtl hs_rtl;

/* A public constant of hs_config_pkg or hs_pkg, as the RTL was elaborated with it. */
typedef struct {
  const char* name; /* null ends the list */
  int64_t value;
} hs_rtl_constant;

typedef struct {
  uint32_t version; /* HS_RTL_OBJECT_VERSION */
  const hs_rtl_constant* constants;
  int has_waves; /* whether open_waves() does anything */

  hs_rtl* (*create)(void); /* after reset */
  void (*destroy)(hs_rtl*);

  /* Holds reset for `clocks` clocks; everything inside is lost. */
  void (*reset)(hs_rtl*, int clocks);
  /* frame_state_t; stable while busy(). */
  void (*set_frame)(hs_rtl*, const uint32_t* words);

  /* Inputs of the coming clock edge: triangle_t (null: none), and whether a tile can be taken. */
  void (*drive)(hs_rtl*, const uint32_t* triangle, int ready);
  /* After drive(): bit l is 1 when a packet changes hands on link l at the coming edge.
   * 0: triangle accepted; l = 1 .. levels: into level l - 1; levels + 1: a tile leaves. */
  uint64_t (*fires)(const hs_rtl*);
  /* The packet on a link: setup_triangle_t (1), traversal_t (2 .. levels), coverage_tile_t
   * (levels + 1). Writes `count` words, the upper ones 0. */
  void (*read)(const hs_rtl*, int link, uint32_t* words, int count);
  /* The edge. Not 0: an assertion failed, and has said so on stdout. */
  int (*clock)(hs_rtl*);
  int (*busy)(const hs_rtl*);

  /* Waves from now on into an FST file, until close or destruction. */
  void (*open_waves)(hs_rtl*, const char* path);
  void (*close_waves)(hs_rtl*);
} hs_rtl_object;

/* The one symbol of the shared object. */
#define HS_RTL_OBJECT_SYMBOL "halfspace_rtl_object"
const hs_rtl_object* halfspace_rtl_object(void);

#ifdef __cplusplus
}
#endif

#endif
