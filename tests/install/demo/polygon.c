// SPDX-License-Identifier: Apache-2.0
#include "polygon.h"

#include <math.h>
#include <vesica.h>

static const long double pi = 3.14159265358979323846L;

static void add(struct polygon* polygon, long double x, long double y) {
  const struct spot spot = {x, y};
  if (polygon->count < polygon_capacity) polygon->at[polygon->count++] = spot;
}

// Adds centre + s p + t perp(p).
static void add_corner(struct polygon* polygon, struct spot centre, struct spot p, long double s, long double t) {
  add(polygon, centre.x + s * p.x - t * p.y, centre.y + s * p.y + t * p.x);
}

// Half lengths a along p, and b across it. (start.x, start.y) is the cosine and sine of the first corner's angle.
static void add_ellipse(struct polygon* polygon, struct spot centre, struct spot p, long double a, long double b,
                        struct spot start, const long double* angles, int count) {
  for (int i = 0; i < count; i++) {
    const long double c = cosl(angles[i]), s = sinl(angles[i]);
    add_corner(polygon, centre, p, a * (start.x * c - start.y * s), b * (start.y * c + start.x * s));
  }
}

static void add_even_ellipse(struct polygon* polygon, struct spot centre, struct spot p, long double a, long double b) {
  enum { count = 96 };
  const struct spot start = {1, 0};
  long double angles[count];
  for (int i = 0; i < count; i++) angles[i] = 2 * pi * i / count;
  add_ellipse(polygon, centre, p, a, b, start, angles, count);
}

// Where the focus is, as the cosine and sine of an angle on the ellipse. Returns 0 where there is no such angle.
static int find_start(struct spot centre, struct spot p, long double a, long double b, struct spot focus,
                      struct spot* start) {
  const long double x = focus.x - centre.x, y = focus.y - centre.y;
  const long double s = (x * p.x + y * p.y) * b, t = (y * p.x - x * p.y) * a;
  const long double length = sqrtl(s * s + t * t);
  start->x = s / length;
  start->y = t / length;
  return isfinite(start->x) && isfinite(start->y);
}

// Each corner is 1.4 times as far from the focus as the one before: from pi down to pi times 2e-20.
static void add_dense_ellipse(struct polygon* polygon, struct spot centre, struct spot p, long double a, long double b,
                              struct spot start) {
  enum { side = 136, count = 2 * side + 1 };
  long double angles[count], angle = pi / 1.4L;
  for (int i = 0; i < side; i++, angle /= 1.4L) {
    angles[i] = -angle;
    angles[count - 1 - i] = angle;
  }
  angles[side] = 0;
  add_ellipse(polygon, centre, p, a, b, start, angles, count);
}

void find_polygon(const struct shape* shape, struct spot origin, const struct spot* focus, struct polygon* out) {
  const double* n = shape->numbers;
  const int round = shape->kind == VESICA_CIRCLE || shape->kind == VESICA_ELLIPSE;
  const int turned = shape->kind == VESICA_RECT || shape->kind == VESICA_ELLIPSE;
  const struct spot centre = {n[0] - origin.x, n[1] - origin.y};
  const struct spot p = {turned ? n[2] : 1, turned ? n[3] : 0};
  const long double a = turned ? n[4] : n[2], b = turned ? n[5] : n[2];
  struct spot start;
  out->count = 0;
  if (round && focus && find_start(centre, p, a, b, *focus, &start)) {
    add_dense_ellipse(out, centre, p, a, b, start);
  } else if (round) {
    add_even_ellipse(out, centre, p, a, b);
  } else if (turned) {
    for (int i = 0; i < 4; i++) add_corner(out, centre, p, i == 0 || i == 3 ? -a : a, i < 2 ? -b : b);
  } else {
    add(out, centre.x, centre.y);
    if (shape->kind == VESICA_AABB) add(out, n[2] - origin.x, centre.y);
    if (shape->kind != VESICA_POINT) add(out, n[2] - origin.x, n[3] - origin.y);
    if (shape->kind == VESICA_AABB) add(out, centre.x, n[3] - origin.y);
  }
}

// Keeps what has x dx + y dy <= limit.
static void cut(struct polygon* polygon, int dx, int dy, long double limit) {
  const struct polygon whole = *polygon;
  polygon->count = 0;
  for (int i = 0; i < whole.count; i++) {
    const struct spot from = whole.at[i], to = whole.at[(i + 1) % whole.count];
    const long double f = from.x * dx + from.y * dy - limit, t = to.x * dx + to.y * dy - limit;
    if (f <= 0) add(polygon, from.x, from.y);
    if ((f <= 0) != (t <= 0)) {
      add(polygon, from.x + f / (f - t) * (to.x - from.x), from.y + f / (f - t) * (to.y - from.y));
    }
  }
}

void clip_polygon(struct polygon* polygon, long double half) {
  cut(polygon, 1, 0, half);
  cut(polygon, -1, 0, half);
  cut(polygon, 0, 1, half);
  cut(polygon, 0, -1, half);
}
