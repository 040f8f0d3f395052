/* SPDX-License-Identifier: Apache-2.0 */
/* The yardstick of the hosts: what the same calls cost from C. A line a question: ns a call of two rectangles, and ns
 * an element of arrays of 1e3 and 1e6, the least of a hundred and of seven repeats. They are short, so that other work
 * on the machine spares some. Every host has this program; all have the same rectangles. */
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <vesica.h>

enum { count = 1000000 };

static vesica_rect_f64 *rect_a, *rect_b;
static double* column[5];
static uint8_t* bytes;

static vesica_rect_f64 rect(int64_t i) {
  const int odd = i % 2 == 1;
  const vesica_rect_f64 made = {
      (double)(i * 7919 % 4001) / 1000, (double)(i * 104729 % 4003) / 1000, odd ? 5.0 / 13 : 0.8, odd ? 12.0 / 13 : 0.6,
      0.5 + (double)(i % 100) / 200,    0.5 + (double)(i % 70) / 140};
  return made;
}

static double seconds(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static double overlap_one(int i) { return vesica_overlap_f64(VESICA_RECT, &rect_a[i].cx, VESICA_RECT, &rect_b[i].cx); }
static double nearest_one(int i) {
  vesica_closest_points_f64 out;
  vesica_nearest_f64(VESICA_RECT, &rect_a[i].cx, VESICA_RECT, &rect_b[i].cx, &out);
  return out.distance;
}
static double iou_one(int i) {
  double out = 0;
  vesica_iou_f64(VESICA_RECT, &rect_a[i].cx, VESICA_RECT, &rect_b[i].cx, &out);
  return out;
}

static void overlap_all(const vesica_shapes_f64* a, const vesica_shapes_f64* b) {
  vesica_overlap_many_f64(a, b, bytes);
}
static void nearest_all(const vesica_shapes_f64* a, const vesica_shapes_f64* b) {
  vesica_nearest_many_f64(a, b, column[0], column[1], column[2], column[3], column[4]);
}
static void iou_all(const vesica_shapes_f64* a, const vesica_shapes_f64* b) { vesica_iou_many_f64(a, b, column[0]); }

static double least_of_one(double (*call)(int)) {
  double least = 1e300;
  volatile double sum = 0;
  for (int repeat = 0; repeat < 100; ++repeat) {
    const double start = seconds();
    for (int i = 0; i < 1000; ++i) sum = sum + call(i);
    const double ns = (seconds() - start) / 1000 * 1e9;
    if (ns < least) least = ns;
  }
  return least;
}

static double least_of_many(void (*call)(const vesica_shapes_f64*, const vesica_shapes_f64*), int n, int repeats) {
  vesica_shapes_f64 a, b;
  double least = 1e300;
  vesica_shapes_from_records_f64(VESICA_RECT, n, rect_a, sizeof *rect_a, &a);
  vesica_shapes_from_records_f64(VESICA_RECT, n, rect_b, sizeof *rect_b, &b);
  for (int repeat = 0; repeat < repeats; ++repeat) {
    const double start = seconds();
    call(&a, &b);
    const double ns = (seconds() - start) / n * 1e9;
    if (ns < least) least = ns;
  }
  return least;
}

static void row(const char* question, double (*one)(int),
                void (*all)(const vesica_shapes_f64*, const vesica_shapes_f64*)) {
  printf("C %s %.4g %.4g %.4g\n", question, least_of_one(one), least_of_many(all, 1000, 100),
         least_of_many(all, count, 7));
}

int main(void) {
  rect_a = malloc(count * sizeof *rect_a);
  rect_b = malloc(count * sizeof *rect_b);
  bytes = malloc(count);
  for (int k = 0; k < 5; ++k) column[k] = malloc(count * sizeof *column[k]);
  for (int64_t i = 0; i < count; ++i) rect_a[i] = rect(i), rect_b[i] = rect(3 * i + 1);
  row("overlap", overlap_one, overlap_all);
  row("nearest", nearest_one, nearest_all);
  row("iou", iou_one, iou_all);
  return 0;
}
