// SPDX-License-Identifier: Apache-2.0
#include "outline.h"

struct vector {
  double x, y;
};

static double smaller(double a, double b) { return a < b ? a : b; }
static double larger(double a, double b) { return a > b ? a : b; }

int32_t find_view(const struct pair* pair, double left, double top, double size, struct view* out) {
  vesica_aabb_f64 a, b;
  double low_x, low_y, width, height;
  int32_t error = vesica_bounds_f64(pair->a.kind, pair->a.numbers, &a);
  if (error == 0) error = vesica_bounds_f64(pair->b.kind, pair->b.numbers, &b);
  if (error != 0) return error;
  low_x = smaller(a.min_x, b.min_x) / 2;
  low_y = smaller(a.min_y, b.min_y) / 2;
  width = larger(a.max_x, b.max_x) / 2 - low_x;
  height = larger(a.max_y, b.max_y) / 2 - low_y;
  out->left = left, out->top = top, out->size = size;
  out->half_extent = larger(width, height);
  if (!(out->half_extent > 0)) out->half_extent = 1;
  out->half_x = low_x - (out->half_extent - width) / 2;
  out->half_y = low_y - (out->half_extent - height) / 2;
  return 0;
}

// Pixels of a length along x or y.
static double scaled(const struct view* view, double length) { return length / 2 / view->half_extent * view->size; }

// SVG's y points down.
static struct vector place(const struct view* view, double x, double y) {
  struct vector p;
  p.x = view->left + (x / 2 - view->half_x) / view->half_extent * view->size;
  p.y = view->top + view->size - (y / 2 - view->half_y) / view->half_extent * view->size;
  return p;
}

// The vector length * (x, y) in pixels.
static struct vector direction(const struct view* view, double length, double x, double y) {
  struct vector d;
  d.x = scaled(view, length * x);
  d.y = -scaled(view, length * y);
  return d;
}

static struct vector corner(struct vector centre, struct vector p, double s, struct vector q, double t) {
  centre.x += s * p.x + t * q.x;
  centre.y += s * p.y + t * q.y;
  return centre;
}

static void put_point(FILE* file, const char* command, struct vector p) {
  fprintf(file, "%s%.2f %.2f", command, p.x, p.y);
}

static void put_parallelogram(FILE* file, struct vector centre, struct vector p, struct vector q) {
  put_point(file, "M", corner(centre, p, 1, q, 1));
  put_point(file, "L", corner(centre, p, -1, q, 1));
  put_point(file, "L", corner(centre, p, -1, q, -1));
  put_point(file, "L", corner(centre, p, 1, q, -1));
}

// An ellipse of half axes p and q: a cubic a quarter, whose handles of 4/3 (sqrt 2 - 1) keep it within 0.03%.
static void put_ellipse(FILE* file, struct vector centre, struct vector p, struct vector q) {
  const double handle = 0.5522847498;
  put_point(file, "M", corner(centre, p, 1, q, 0));
  for (int quarter = 0; quarter < 4; quarter++) {
    const struct vector turned = {-p.x, -p.y};
    put_point(file, "C", corner(centre, p, 1, q, handle));
    put_point(file, " ", corner(centre, p, handle, q, 1));
    put_point(file, " ", corner(centre, p, 0, q, 1));
    p = q;
    q = turned;
  }
}

// Centre and two half axes of a shape, in pixels. A segment has its half as the first axis, an AABB is a rectangle.
static void find_frame(const struct shape* shape, const struct view* view, struct vector* centre, struct vector* p,
                       struct vector* q) {
  const double* n = shape->numbers;
  const struct vector zero = {0, 0};
  *centre = place(view, n[0], n[1]);
  *p = *q = zero;
  if (shape->kind == VESICA_SEGMENT || shape->kind == VESICA_AABB) {
    const struct vector other = place(view, n[2], n[3]);
    const struct vector half = {(other.x - centre->x) / 2, (other.y - centre->y) / 2};
    *centre = corner(*centre, half, 1, zero, 0);
    *p = half;
    if (shape->kind == VESICA_AABB) p->y = 0, q->y = half.y;
  } else if (shape->kind == VESICA_CIRCLE) {
    *p = direction(view, n[2], 1, 0);
    *q = direction(view, n[2], 0, 1);
  } else if (shape->kind == VESICA_RECT || shape->kind == VESICA_ELLIPSE) {
    *p = direction(view, n[4], n[2], n[3]);
    *q = direction(view, n[5], -n[3], n[2]);
  }
}

static int is_small(struct vector v) { return v.x * v.x + v.y * v.y < 1; }

void write_shape(FILE* file, const struct shape* shape, const struct view* view, const char* css_class) {
  struct vector centre, p, q;
  find_frame(shape, view, &centre, &p, &q);
  if (is_small(p) && is_small(q)) {
    fprintf(file, "<circle class=\"%s\" cx=\"%.2f\" cy=\"%.2f\" r=\"2\"/>\n", css_class, centre.x, centre.y);
    return;
  }
  fprintf(file, "<path class=\"%s\" d=\"", css_class);
  if (shape->kind == VESICA_CIRCLE || shape->kind == VESICA_ELLIPSE) {
    put_ellipse(file, centre, p, q);
  } else {
    put_parallelogram(file, centre, p, q);
  }
  fputs("Z\"/>\n", file);
}
