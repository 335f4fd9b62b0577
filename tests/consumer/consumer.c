/* SPDX-License-Identifier: Apache-2.0
 *
 * A C99 program against the installed library: consumer SCENE WIDTH HEIGHT prints the CRC-32 of the
 * scene's coverage, as `halfspace render --stats` has it. */
#include <halfspace.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int fail(const char* what, hs_status status) {
  fprintf(stderr, "consumer: %s: %s: %s\n", what, hs_status_text(status), hs_last_error());
  return 1;
}

int main(int argc, char** argv) {
  hs_model* model = NULL;
  hs_frame frame;
  hs_stats stats;
  hs_status status;
  if (argc != 4 || hs_api_version() != HALFSPACE_API_VERSION) return 2;
  status = hs_create_preset("full", &model);
  if (status != HS_OK) return fail("create", status);
  memset(&frame, 0, sizeof frame);
  frame.struct_size = sizeof frame;
  frame.width = atoi(argv[2]);
  frame.height = atoi(argv[3]);
  frame.outputs = HS_COUNTS;
  status = hs_begin_frame(model, &frame);
  if (status == HS_OK) status = hs_draw_scene(model, argv[1], NULL);
  memset(&stats, 0, sizeof stats);
  stats.struct_size = sizeof stats;
  if (status == HS_OK) status = hs_get_stats(model, &stats);
  if (status != HS_OK) {
    hs_destroy(model);
    return fail("draw", status);
  }
  printf("%lu\n", (unsigned long)stats.coverage_crc32);
  hs_destroy(model);
  return 0;
}
