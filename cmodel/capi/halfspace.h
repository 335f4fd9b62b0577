/* SPDX-License-Identifier: Apache-2.0
 *
 * The C interface of the Halfspace rasterizer model: triangles in; coverage tiles with the clock
 * at which the hardware hands them over, fragments and pictures out. Page: docs/02_use/c_api.md.
 *
 * Order of calls: hs_create_*(), hs_begin_frame(), hs_push_*() and hs_pull_*() as you like,
 * hs_read_*(), again hs_begin_frame() for the next frame, hs_destroy().
 *
 * Errors: every call that can fail returns an hs_status; no C++ exception leaves the library. Bad
 * input is refused, never wrapped or clamped, and leaves the model as it was; of several triangles
 * those before the refused one stay drawn. hs_last_error() says what was wrong, in one line. A null
 * pointer where one is needed is HS_ERROR_ARGUMENT.
 *
 * Threads: a model may be used by one thread at a time; different models by different threads at
 * once. Ownership: what hs_create_*() makes belongs to the caller until hs_destroy(); every other
 * pointer is borrowed for the call; returned strings are constants or live as said.
 *
 * Compatibility: HALFSPACE_API_VERSION grows when a program must change. Structs that begin with
 * struct_size may gain fields at their end: set struct_size to sizeof the struct, clear the rest to
 * zero, set what you need. The other structs do not change within an API version.
 */
#ifndef HALFSPACE_H
#define HALFSPACE_H

#include <stddef.h>
#include <stdint.h>

#define HALFSPACE_API_VERSION 1

#ifdef __cplusplus
extern "C" {
#endif
#ifdef __GNUC__
#pragma GCC visibility push(default)
#endif

typedef enum hs_status {
  HS_OK = 0,
  HS_EMPTY = 1,             /* nothing waits to be pulled */
  HS_ERROR_ARGUMENT = 2,    /* a null pointer, a struct_size or an array of the wrong size */
  HS_ERROR_CONFIG = 3,      /* no such preset, bad JSON, an illegal configuration */
  HS_ERROR_RANGE = 4,       /* a coordinate, tag, attribute or frame size out of range */
  HS_ERROR_ORDER = 5,       /* not now: no frame begun, or that output was not asked for */
  HS_ERROR_FILE = 6,        /* a scene cannot be read, or is broken */
  HS_ERROR_UNSUPPORTED = 7, /* this build has no file formats (HALFSPACE_CLI=OFF) */
  HS_ERROR_MEMORY = 8,
  HS_ERROR_INTERNAL = 9 /* a bug in Halfspace */
} hs_status;

typedef struct hs_model hs_model;

/* HALFSPACE_API_VERSION of the library that is running; compare it with the header's. */
uint32_t hs_api_version(void);
/* The project's version, such as "0.1.0". */
const char* hs_version(void);
/* What a status means; never null. */
const char* hs_status_text(hs_status status);
/* What was wrong with this thread's last failed call; "" when none failed. Valid until the next
 * failed call of the thread. */
const char* hs_last_error(void);

/* --- Models -------------------------------------------------------------------------------- */

/* A model of the preset "tiny", "full", "d3d" or "msaa4". On failure *model is set to null. */
hs_status hs_create_preset(const char* name, hs_model** model);
/* A model of a configuration in JSON, such as {"preset": "full", "samples": 4}. Keys:
 * docs/03_design/config.md. */
hs_status hs_create_json(const char* text, hs_model** model);
/* Null is allowed. */
void hs_destroy(hs_model* model);

/* The configuration, and what follows from it. Widths in bits, signed unless said. */
typedef struct hs_info {
  size_t struct_size;
  int32_t subpixel_bits, viewport_bits, guard_bits, samples, grid_log2, setup_interval;
  int32_t tag_bits, depth_bits, attributes, inverse_w_bits, gradient_bits, reciprocal_bits;
  int32_t snap;                           /* 0 nearest even, 1 half away from zero, 2 truncate */
  int32_t grid;                           /* a tile is grid x grid pixels */
  int32_t levels;                         /* grids in the pyramid */
  int32_t max_size;                       /* pixels, greatest frame width and height */
  int32_t vertex_bits;                    /* a coordinate, 2^-subpixel_bits px */
  int32_t delta_bits;                     /* an edge's slopes */
  int32_t area_bits;                      /* the doubled area */
  int32_t edge_bits;                      /* an edge value at any sample of the frame */
  int32_t lane_bits;                      /* an edge value in one lane of a grid */
  int32_t root_bits;                      /* an edge value at the root's origin */
  int32_t coordinate_min, coordinate_max; /* legal vertex coordinates, 2^-subpixel_bits px */
  int32_t extent_bits; /* every edge is shorter than 2^this px in x and in y; 0: no limit */
} hs_info;
/* info->struct_size must be set; that many bytes are filled. */
hs_status hs_get_info(const hs_model* model, hs_info* info);

/* --- Frames -------------------------------------------------------------------------------- */

enum { HS_CULL_NONE = 0, HS_CULL_BACK = 1, HS_CULL_FRONT = 2 };
/* A fragment is drawn when its depth is ... the stored one. Nearer is smaller. */
enum {
  HS_DEPTH_LESS = 0,
  HS_DEPTH_LESS_EQUAL = 1,
  HS_DEPTH_ALWAYS = 2,
  HS_DEPTH_NEVER = 3,
  HS_DEPTH_EQUAL = 4,
  HS_DEPTH_GREATER = 5,
  HS_DEPTH_GREATER_EQUAL = 6,
  HS_DEPTH_NOT_EQUAL = 7
};
/* Which of the last fields of hs_frame count. */
enum { HS_DEPTH_CLEAR = 1, HS_SCISSOR = 2 };

/* What a frame keeps for its reader, besides hit counts and statistics. 0 means HS_TILES. */
enum {
  HS_TILES = 1,     /* hs_pull_tiles(): 160 bytes each until pulled */
  HS_FRAGMENTS = 2, /* hs_pull_fragments(): needs depth and colour; 84 bytes each until pulled */
  HS_PICTURE = 4,   /* hs_read_color(), hs_read_depth() */
  HS_CLOCKS = 8,    /* hs_read_triangle_clocks(): 16 bytes a triangle until the next frame */
  HS_COUNTS = 16    /* nothing but the hit counts and statistics, which are always there */
};

typedef struct hs_frame {
  size_t struct_size;
  int32_t width, height;    /* pixels, 1..max_size */
  int32_t cull;             /* HS_CULL_* */
  int32_t depth_function;   /* HS_DEPTH_* */
  uint32_t outputs;         /* HS_TILES | ... */
  uint8_t background[3];    /* red, green, blue where nothing is drawn */
  uint8_t reserved;         /* 0 */
  double stall_probability; /* 0 <= p < 1: how often the world outside holds the hardware up */
  uint64_t stall_seed;
  uint32_t flags;       /* HS_DEPTH_CLEAR | HS_SCISSOR */
  uint32_t depth_clear; /* depth where nothing is drawn, depth_bits; without: 2^depth_bits - 1 */
  int32_t scissor[4];   /* x, y, width, height, px, in the frame: no fragment outside is drawn;
                           tiles, hit counts and clocks are those without it */
} hs_frame;

/* Starts an empty frame at clock 0; what the last one left unpulled is dropped. */
hs_status hs_begin_frame(hs_model* model, const hs_frame* frame);
/* The same frame again from its start. */
hs_status hs_reset(hs_model* model);

/* The stall pattern that the clocks of a frame assume, for a bench to follow: how many clocks the
 * source waits, after its previous triangle was accepted, before it offers triangle 0, 1, ...; and
 * whether a tile is taken at a clock. A probability outside 0 <= p < 1 counts as 0. */
uint32_t hs_stall_gap(double probability, uint64_t seed, uint64_t triangle);
int hs_stall_ready(double probability, uint64_t seed, uint64_t clock);

/* --- Triangles ----------------------------------------------------------------------------- */

/* Vertices in 2^-subpixel_bits px, x right and y down from the frame's top-left corner:
 * x0 y0 x1 y1 x2 y2, each in [coordinate_min, coordinate_max], edges within extent_bits. tag:
 * tag_bits. Colours are white, depth in the middle. */
hs_status hs_push_triangle(hs_model* model, const int32_t xy[6], uint32_t tag);
/* count triangles, tags first_tag, first_tag + 1, ... modulo 2^tag_bits. Stops at the first one
 * refused; *pushed (may be null) says how many were drawn. Faster than one by one. */
hs_status hs_push_triangles(hs_model* model, const int32_t* xy, size_t count, uint32_t first_tag,
                            size_t* pushed);
/* Vertices in pixels, snapped as the configuration says; then as hs_push_triangle(). */
hs_status hs_push_triangle_px(hs_model* model, const double xy[6], uint32_t tag);

/* A vertex as the hardware gets it. */
typedef struct hs_vertex {
  int32_t x, y;       /* 2^-subpixel_bits px */
  uint32_t depth;     /* 0..1 times 2^depth_bits - 1, in units of 1/64: below 2^(depth_bits + 6);
                         from 27 depth bits on of 2^(depth_bits - 32): 32 bits in all */
  uint32_t inverse_w; /* 1..2^inverse_w_bits - 1: 1/w of the three, of which only ratios count */
  uint16_t value[8];  /* red, green, blue, ...: 0..255 in units of 1/256 */
} hs_vertex;
hs_status hs_push_shaded(hs_model* model, const hs_vertex vertex[3], uint32_t tag);

/* A vertex in clip space (OpenGL's: -w <= x, y, z <= w is seen), before the division by w. */
typedef struct hs_clip_vertex {
  double position[4]; /* x, y, z, w */
  double value[8];    /* red, green, blue, ...: 0..255 */
} hs_clip_vertex;
/* Clips, projects and snaps: 0..8 triangles enter the hardware, all with this tag. A triangle with
 * a coordinate that is not finite is counted and dropped, as graphics APIs want it. */
hs_status hs_push_clip(hs_model* model, const hs_clip_vertex vertex[3], uint32_t tag);

/* What hs_draw_scene() is told of the camera; fields whose flag is not set are found so that the
 * whole scene is seen. */
enum {
  HS_CAMERA_EYE = 1,
  HS_CAMERA_TARGET = 2,
  HS_CAMERA_UP = 4,
  HS_CAMERA_FOV = 8,
  HS_CAMERA_ORTHO = 16,     /* orthographic; ortho_height 0 fits the scene */
  HS_CAMERA_FLAT_LIGHT = 32 /* a colour per triangle instead of per vertex */
};
typedef struct hs_camera {
  size_t struct_size;
  uint32_t flags;
  uint32_t reserved;               /* 0 */
  double eye[3], target[3], up[3]; /* world units */
  double fov_y_degrees;            /* above 0, below 180 */
  double ortho_height;             /* world units from the bottom of the picture to its top */
} hs_camera;
/* Draws a mesh file (OBJ, glTF, GLB, PLY, STL) as `halfspace render` does; tags number its
 * triangles from 0, modulo 2^tag_bits. camera may be null. */
hs_status hs_draw_scene(hs_model* model, const char* path, const hs_camera* camera);

/* --- Results, in the order of the hardware --------------------------------------------------- */

/* One tile of one triangle, at least one bit set. */
typedef struct hs_tile {
  int32_t x, y; /* its first pixel */
  uint32_t tag;
  uint32_t samples;  /* masks in use */
  uint64_t clock;    /* the clock edge at which the hardware hands it over; 0 is the first one after
                        reset */
  uint64_t triangle; /* its triangle's number, in the order they entered the hardware, from 0 */
  uint64_t mask[16]; /* one per sample: bit j * grid + i is pixel (x + i, y + j) */
} hs_tile;
/* Moves up to `capacity` tiles to `tile`; *count says how many. HS_EMPTY when none waits. */
hs_status hs_pull_tiles(hs_model* model, hs_tile* tile, size_t capacity, size_t* count);

/* A pixel of a triangle with a sample that passed the depth test. */
typedef struct hs_fragment {
  int32_t x, y; /* pixel */
  uint32_t tag;
  uint16_t covered; /* bit m: sample m is inside the triangle */
  uint16_t passed;  /* bit m: it passed the depth test */
  uint8_t color[3]; /* red, green, blue */
  uint8_t reserved;
  uint32_t depth[16]; /* of the samples that passed, depth_bits; 0 elsewhere */
} hs_fragment;
hs_status hs_pull_fragments(hs_model* model, hs_fragment* fragment, size_t capacity, size_t* count);

/* --- Results of the frame so far ------------------------------------------------------------- */

typedef struct hs_stats {
  size_t struct_size;
  uint64_t triangles_in;         /* pushed; of hs_push_clip() and scenes, before clipping */
  uint64_t triangles_not_finite; /* of these dropped: a coordinate is NaN, infinite, above 1e100 */
  uint64_t triangles_outside;    /* dropped: nothing of it is seen */
  uint64_t triangles_clipped;
  uint64_t triangles;           /* entered the hardware */
  uint64_t triangles_zero_area; /* of these, dropped by triangle_setup */
  uint64_t triangles_culled;
  uint64_t triangles_no_sample;
  uint64_t tiles_visited, tiles_covered;
  uint64_t samples_tested, samples_covered;
  uint64_t fragments;        /* pixels with a covered sample, before the depth test */
  uint64_t fragments_shaded; /* of these, with a sample that passed; 0 without depth */
  uint64_t cycles;           /* clocks to the last edge at which a packet came or went */
  uint32_t coverage_crc32;   /* as `halfspace render --stats` */
  uint32_t reserved;
} hs_stats;
/* stats->struct_size must be set; that many bytes are filled. */
hs_status hs_get_stats(const hs_model* model, hs_stats* stats);

/* When a triangle was accepted, and when setup handed it to the pyramid (HS_NEVER: dropped). */
typedef struct hs_triangle_clocks {
  uint64_t accepted, setup;
} hs_triangle_clocks;
#define HS_NEVER UINT64_MAX
/* Of triangles first .. first + count - 1, numbered as hs_tile::triangle. */
hs_status hs_read_triangle_clocks(const hs_model* model, uint64_t first, size_t count,
                                  hs_triangle_clocks* clocks);

/* Pictures, row by row from the top; size is the array's number of elements and must fit exactly:
 * hits width * height (triangles that cover the pixel, up to 255), depth width * height (of sample
 * 0; what it was cleared to where nothing is), color 3 * width * height (red, green, blue). */
hs_status hs_read_hits(const hs_model* model, uint8_t* hits, size_t size);
hs_status hs_read_depth(const hs_model* model, uint32_t* depth, size_t size);
hs_status hs_read_color(const hs_model* model, uint8_t* color, size_t size);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif
#ifdef __cplusplus
}
#endif

#endif
