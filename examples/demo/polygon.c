// SPDX-License-Identifier: Apache-2.0
#include "polygon.h"

#include <math.h>
#include <vesica.h>

static const long double pi = 3.14159265358979323846L;

static void add(struct polygon* polygon, struct spot spot) {
  if (polygon->count < polygon_capacity) polygon->at[polygon->count++] = spot;
}

// Adds centre + s p + t perp(p).
static void add_corner(struct polygon* polygon, struct spot centre, struct spot p, long double s, long double t) {
  centre.x += s * p.x - t * p.y;
  centre.y += s * p.y + t * p.x;
  add(polygon, centre);
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

// Finds the direction of the focus, as the cosine and sine of an angle on the ellipse. Returns 0 if there is none.
static int find_start(struct spot centre, struct spot p, long double a, long double b, struct spot focus,
                      struct spot* start) {
  const long double x = focus.x - centre.x, y = focus.y - centre.y;
  const long double s = (x * p.x + y * p.y) * b, t = (y * p.x - x * p.y) * a;
  const long double length = sqrtl(s * s + t * t);
  start->x = s / length;
  start->y = t / length;
  return isfinite(start->x) && isfinite(start->y);
}

// From the focus to either side, each corner is 1.4 times as far as the one before: the angles are from 4e-20 to pi.
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

static void add_round(struct polygon* polygon, struct spot centre, struct spot p, long double a, long double b,
                      const struct spot* focus) {
  struct spot start;
  if (focus && find_start(centre, p, a, b, *focus, &start)) {
    add_dense_ellipse(polygon, centre, p, a, b, start);
  } else {
    add_even_ellipse(polygon, centre, p, a, b);
  }
}

static void add_rect(struct polygon* polygon, struct spot centre, struct spot p, long double hx, long double hy) {
  add_corner(polygon, centre, p, -hx, -hy);
  add_corner(polygon, centre, p, hx, -hy);
  add_corner(polygon, centre, p, hx, hy);
  add_corner(polygon, centre, p, -hx, hy);
}

// A rectangle with a radius: a quarter of a circle about each corner. Half sizes are lengths.
static void add_round_rect(struct polygon* polygon, struct spot centre, struct spot unit, long double hx,
                           long double hy, long double r) {
  enum { quarter = 24 };
  for (int i = 0; i <= 4 * quarter + 3; i++) {
    const int corner = i / (quarter + 1);
    const long double angle = pi / 2 * (corner + (long double)(i % (quarter + 1)) / quarter);
    const long double s = corner == 0 || corner == 3 ? hx : -hx, t = corner < 2 ? hy : -hy;
    add_corner(polygon, centre, unit, s + r * cosl(angle), t + r * sinl(angle));
  }
}

static struct spot unit_of(struct spot p, long double* length) {
  struct spot unit = {1, 0};
  *length = hypotl(p.x, p.y);
  if (*length > 0) {
    unit.x = p.x / *length;
    unit.y = p.y / *length;
  }
  return unit;
}

static void add_capsule(struct polygon* polygon, struct spot first, struct spot second, long double r) {
  const struct spot centre = {(first.x + second.x) / 2, (first.y + second.y) / 2};
  const struct spot along = {second.x - first.x, second.y - first.y};
  long double length;
  const struct spot unit = unit_of(along, &length);
  add_round_rect(polygon, centre, unit, length / 2, 0, r);
}

void find_polygon(const struct shape* shape, struct spot origin, const struct spot* focus, struct polygon* out) {
  const double* n = shape->numbers;
  const struct spot first = {n[0] - origin.x, n[1] - origin.y}, second = {n[2] - origin.x, n[3] - origin.y};
  const struct spot right = {second.x, first.y}, above = {first.x, second.y}, axis = {n[2], n[3]}, x_axis = {1, 0};
  out->count = 0;
  switch (shape->kind) {
    case VESICA_POINT:
      add(out, first);
      break;
    case VESICA_SEGMENT:
      add(out, first);
      add(out, second);
      break;
    case VESICA_CIRCLE:
      add_round(out, first, x_axis, n[2], n[2], focus);
      break;
    case VESICA_AABB:
      add(out, first);
      add(out, right);
      add(out, second);
      add(out, above);
      break;
    case VESICA_RECT:
      add_rect(out, first, axis, n[4], n[5]);
      break;
    case VESICA_ELLIPSE:
      add_round(out, first, axis, n[4], n[5], focus);
      break;
    case VESICA_CAPSULE:
      add_capsule(out, first, second, n[4]);
      break;
    case VESICA_ROUND_RECT: {
      long double length;
      const struct spot unit = unit_of(axis, &length);
      add_round_rect(out, first, unit, n[4] * length, n[5] * length, n[6]);
      break;
    }
  }
}

// The point between two, f away from the first, t from the second. Reckoned from the nearer one, so that a line that is
// cut on its way there and on its way back is cut at the same place.
static struct spot between(struct spot from, long double f, struct spot to, long double t) {
  struct spot spot;
  if (fabsl(t) < fabsl(f)) return between(to, t, from, f);
  spot.x = from.x + f / (f - t) * (to.x - from.x);
  spot.y = from.y + f / (f - t) * (to.y - from.y);
  return spot;
}

// Keeps the part where x dx + y dy <= limit.
static void cut(struct polygon* polygon, int dx, int dy, long double limit) {
  const struct polygon whole = *polygon;
  polygon->count = 0;
  for (int i = 0; i < whole.count; i++) {
    const struct spot from = whole.at[i], to = whole.at[(i + 1) % whole.count];
    const long double f = from.x * dx + from.y * dy - limit, t = to.x * dx + to.y * dy - limit;
    if (f <= 0) add(polygon, from);
    if ((f <= 0) != (t <= 0)) {
      struct spot spot = between(from, f, to, t);
      // On the line to the last digit, however far away the corners are.
      if (dx != 0) spot.x = dx * limit;
      if (dy != 0) spot.y = dy * limit;
      add(polygon, spot);
    }
  }
}

void clip_polygon(struct polygon* polygon, long double half) {
  cut(polygon, 1, 0, half);
  cut(polygon, -1, 0, half);
  cut(polygon, 0, 1, half);
  cut(polygon, 0, -1, half);
}
