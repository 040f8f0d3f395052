// SPDX-License-Identifier: Apache-2.0
/// The patterns of docs/join.md on squares that move, beside all pairs one by one. Compiled behind the page's code.
#include <stdlib.h>
#include <string.h>

enum { most = 3000, changes = 40 };

static vesica_rect_f64 bodies[most], probes[most];
static uint8_t expected[most][most + changes];
static int64_t missing;

static double next_number(void) {
  static uint64_t state = 1;
  state = state * 6364136223846793005u + 1442695040888963407u;
  return (double)(state >> 40) / 0x1p24;
}

static vesica_rect_f64 draw(void) {
  const vesica_rect_f64 body = {50 * next_number(), 50 * next_number(), 1, next_number(), 0.3, 0.2};
  return body;
}

static void* aligned(int64_t bytes) { return aligned_alloc(64, (size_t)(bytes + 63) / 64 * 64); }

/* A pair must be expected, and is then no longer. */
static void strike_out(int64_t a, int64_t b, void* user) {
  (void)user;
  if (!expected[a][b]) {
    printf("pair %d, %d is wrong or comes twice\n", (int)a, (int)b);
    exit(1);
  }
  expected[a][b] = 0;
  missing--;
}

static void expect(int64_t a, int64_t b, const vesica_rect_f64* first, const vesica_rect_f64* second) {
  if (vesica_overlap_rect_rect_f64(first, second) == 1) {
    expected[a][b] = 1;
    missing++;
  }
}

static void require(int holds, const char* what) {
  if (holds) return;
  printf("%s, %d pairs are missing\n", what, (int)missing);
  exit(1);
}

static struct frame_memory take_memory(int64_t count) {
  struct frame_memory m;
  m.index_size = vesica_index_size(count);
  m.scratch_size =
      vesica_index_scratch(count) > vesica_join_scratch() ? vesica_index_scratch(count) : vesica_join_scratch();
  m.index = aligned(m.index_size);
  m.scratch = aligned(m.scratch_size);
  return m;
}

static vesica_shapes_f64 view(int64_t count, const vesica_rect_f64* from) {
  vesica_shapes_f64 shapes;
  vesica_shapes_from_records_f64(VESICA_RECT, count, from, sizeof *from, &shapes);
  return shapes;
}

static void each_frame(void) {
  const struct frame_memory m = take_memory(most);
  const vesica_shapes_f64 shapes = view(most, bodies);
  for (int frame = 0; frame < 3; frame++) {
    for (int i = 0; i < most; i++) bodies[i].cx += next_number() - 0.5;
    bodies[7].hx = frame == 1 ? -1 : 0.3; /* broken for one frame */
    for (int i = 0; i < most; i++)
      for (int j = i + 1; j < most; j++) expect(i, j, &bodies[i], &bodies[j]);
    require(missing > 100 && collide(&shapes, &m, strike_out, NULL) == 0 && missing == 0, "a frame");
  }
  free(m.index);
  free(m.scratch);
}

static void from_file(void) {
  const struct frame_memory m = take_memory(most);
  const vesica_shapes_f64 shapes = view(most, bodies);
  const int64_t built = vesica_index_build_f64(&shapes, 1, m.index, m.index_size, m.scratch, m.scratch_size);
  require(save_index("static.index", m.index), "saving");
  const struct indexed mapped = {&shapes, 1, map_index("static.index")};
  require(mapped.index != NULL && vesica_index_bytes(mapped.index) == built, "mapping");
  for (int i = 0; i < most; i++)
    for (int j = i + 1; j < most; j++) expect(i, j, &bodies[i], &bodies[j]);
  require(each_pair(&mapped, &mapped, m.scratch, m.scratch_size, strike_out, NULL) == 0 && missing == 0, "a file");
  munmap((void*)(uintptr_t)mapped.index, (size_t)built);
  require(truncate("static.index", built - 64) == 0 && map_index("static.index") == NULL, "a file cut off");
  require(map_index("nowhere") == NULL, "no file");
  free(m.index);
  free(m.scratch);
}

static void few_changes(void) {
  static uint8_t replaced[most];
  vesica_rect_f64 changed[changes];
  const struct frame_memory all = take_memory(most), asking = take_memory(most), few = take_memory(changes);
  const vesica_shapes_f64 base = view(most, bodies), small = view(changes, changed), ask = view(most, probes);
  const struct indexed asked = {&ask, 1, asking.index};
  const struct changing b = {{&base, 1, all.index}, {&small, 1, few.index}, replaced};
  for (int i = 0; i < most; i++) probes[i] = draw();
  for (int i = 0; i < changes; i++) changed[i] = draw();
  for (int i = 0; i < changes / 2; i++) replaced[i * 31] = 1; /* as many are new */
  vesica_index_build_f64(&ask, 1, asking.index, asking.index_size, asking.scratch, asking.scratch_size);
  vesica_index_build_f64(&base, 1, all.index, all.index_size, all.scratch, all.scratch_size);
  vesica_index_build_f64(&small, 1, few.index, few.index_size, few.scratch, few.scratch_size);
  for (int i = 0; i < most; i++) {
    for (int j = 0; j < most; j++)
      if (!replaced[j]) expect(i, j, &probes[i], &bodies[j]);
    for (int j = 0; j < changes; j++) expect(i, most + j, &probes[i], &changed[j]);
  }
  require(each_pair_with_changing(&asked, &b, all.scratch, all.scratch_size, strike_out, NULL) == 0 && missing == 0,
          "a few changes");
  free(all.index), free(all.scratch), free(asking.index), free(asking.scratch), free(few.index), free(few.scratch);
}

int main(void) {
  for (int i = 0; i < most; i++) bodies[i] = draw();
  each_frame();
  from_file();
  few_changes();
  return 0;
}
