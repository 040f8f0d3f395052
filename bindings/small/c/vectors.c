/* SPDX-License-Identifier: Apache-2.0 */
/* vectors.c FILE: the shared vectors (bindings/vectors) by plain C. Exit status 0 when all answers are right. */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <vesica.h>

enum { batch_limit = 64 };

struct batch {
  int count, line[batch_limit], expected[batch_limit];
  vesica_rect_f64 rect[batch_limit];
  vesica_ellipse_f64 ellipse[batch_limit];
};

static int wrong;

static void check(int line, int32_t answer, int32_t expected) {
  if (answer == expected) return;
  printf("line %d: %d, not %d\n", line, (int)answer, (int)expected);
  wrong = 1;
}

/* Reads " kind a0 .. a5". Returns 1 on success. */
static int read_shape(FILE* file, int* kind, double numbers[6]) {
  if (fscanf(file, "%d", kind) != 1) return 0;
  for (int i = 0; i < 6; ++i) {
    uint64_t bits;
    if (fscanf(file, "%" SCNx64, &bits) != 1) return 0;
    memcpy(&numbers[i], &bits, sizeof bits);
  }
  return 1;
}

static int32_t overlap_f32(int kind_a, const double a[6], int kind_b, const double b[6]) {
  float float_a[6], float_b[6];
  for (int i = 0; i < 6; ++i) {
    float_a[i] = (float)a[i];
    float_b[i] = (float)b[i];
  }
  return vesica_overlap_f32(kind_a, float_a, kind_b, float_b);
}

static int read_vectors(FILE* file, struct batch* batch) {
  char what[8];
  int calls = 0, line = 1, expected, kind_a, kind_b;
  double a[6], b[6];
  for (; fscanf(file, "%7s", what) == 1; ++line) {
    if (what[0] != '#') {
      if (fscanf(file, "%d", &expected) != 1 || !read_shape(file, &kind_a, a) || !read_shape(file, &kind_b, b))
        return -1;
      if (strcmp(what, "many") == 0) {
        if (batch->count == batch_limit) return -1;
        batch->line[batch->count] = line;
        batch->expected[batch->count] = expected;
        memcpy(&batch->rect[batch->count], a, sizeof a);
        memcpy(&batch->ellipse[batch->count++], b, sizeof b);
      } else {
        const int in_double = strcmp(what, "f64") == 0;
        check(line, in_double ? vesica_overlap_f64(kind_a, a, kind_b, b) : overlap_f32(kind_a, a, kind_b, b), expected);
        ++calls;
      }
    }
    for (int c = 0; c != '\n' && c != EOF;) c = getc(file); /* the rest of the line */
  }
  return calls;
}

/* Two arrays of structs in step, as they are. */
static int64_t overlap_many(const vesica_rect_f64* a, const vesica_ellipse_f64* b, int count, uint8_t* out) {
  vesica_shapes_f64 shapes_a, shapes_b;
  vesica_shapes_from_records_f64(VESICA_RECT, count, a, sizeof *a, &shapes_a);
  vesica_shapes_from_records_f64(VESICA_ELLIPSE, count, b, sizeof *b, &shapes_b);
  return vesica_overlap_many_f64(&shapes_a, &shapes_b, out);
}

static void answer_batch(const struct batch* batch) {
  uint8_t out[batch_limit];
  int valid = 0, hits = 0;
  for (; valid < batch->count && batch->expected[valid] >= 0; ++valid) hits += batch->expected[valid];
  if (overlap_many(batch->rect, batch->ellipse, valid, out) != hits) wrong = 1;
  /* With an invalid element, an error: and yet every valid one has its answer. */
  if (overlap_many(batch->rect, batch->ellipse, batch->count, out) != VESICA_E_SHAPE) wrong = 1;
  for (int i = 0; i < batch->count; ++i) check(batch->line[i], out[i], batch->expected[i] > 0);
}

/* Numbers are written to a struct. */
static void show_nearest(void) {
  const vesica_aabb_f64 box = {0.0, 0.0, 2.0, 2.0};
  const vesica_circle_f64 disc = {6.0, 1.0, 1.0};
  vesica_closest_points_f64 p;
  const int32_t answer = vesica_nearest_f64(VESICA_AABB, &box, VESICA_CIRCLE, &disc, &p);
  const int right = p.distance == 3 && p.ax == 2 && p.ay == 1 && p.bx == 5 && p.by == 1;
  if (answer == 0 && right) printf("nearest: as in C\n");
}

static void show_nan(void) {
  const vesica_circle_f64 disc = {0.0, 0.0, 1.0};
  const vesica_point_f64 point = {NAN, 0.0};
  const int32_t answer = vesica_overlap_point_circle_f64(&point, &disc);
  if (answer < 0) printf("NaN: %s\n", vesica_strerror(answer));
}

int main(int argc, char** argv) {
  static struct batch batch;
  if (vesica_version() < VESICA_VERSION) {
    fprintf(stderr, "vesica %d is older than %d\n", (int)vesica_version(), VESICA_VERSION);
    return 1;
  }
  FILE* file = argc == 2 ? fopen(argv[1], "r") : NULL;
  if (file == NULL) return 2;
  const int calls = read_vectors(file, &batch);
  fclose(file);
  answer_batch(&batch);
  show_nan();
  show_nearest();
  printf("%d calls, %d in a batch\n", calls, batch.count);
  return wrong;
}
