// SPDX-License-Identifier: Apache-2.0
#include "contact.h"

#include <math.h>
#include <vesica.h>

static long double dot(struct spot a, struct spot b) { return a.x * b.x + a.y * b.y; }

static struct spot minus(struct spot a, struct spot b) {
  const struct spot difference = {a.x - b.x, a.y - b.y};
  return difference;
}

static struct spot perp(struct spot v) {
  const struct spot turned = {-v.y, v.x};
  return turned;
}

// How far the polygon reaches along a direction.
static long double reach(const struct polygon* polygon, struct spot direction) {
  long double most = dot(polygon->at[0], direction);
  for (int i = 1; i < polygon->count; i++) most = fmaxl(most, dot(polygon->at[i], direction));
  return most;
}

// Keeps a direction, of any length, if the gap from a to b is wider along it than along the best one so far.
static void try_direction(struct contact* contact, struct spot direction) {
  const long double length = sqrtl(dot(direction, direction));
  const struct spot normal = {direction.x / length, direction.y / length}, back = {-normal.x, -normal.y};
  const long double width = -reach(&contact->b, back) - reach(&contact->a, normal);
  if (!(length > 0) || !(width > contact->width)) return;
  contact->width = width;
  contact->normal = normal;
}

// The gap is widest across an edge of one of the two, or along an edge: two segments may lie on one line.
static void try_edges(struct contact* contact, const struct polygon* polygon) {
  for (int i = 0; i < polygon->count; i++) {
    struct spot direction = minus(polygon->at[(i + 1) % polygon->count], polygon->at[i]);
    for (int turn = 0; turn < 4; turn++, direction = perp(direction)) try_direction(contact, direction);
  }
}

// The part of a polygon's outline that reaches farthest along `direction`, measured along `side`.
static void find_end(const struct polygon* polygon, struct spot direction, struct spot side, long double slack,
                     long double* low, long double* high) {
  const long double farthest = reach(polygon, direction) - slack;
  *low = INFINITY;
  *high = -INFINITY;
  for (int i = 0; i < polygon->count; i++) {
    const long double across = dot(polygon->at[i], side);
    if (dot(polygon->at[i], direction) < farthest) continue;
    *low = fminl(*low, across);
    *high = fmaxl(*high, across);
  }
}

// The middle of the gap. Where two sides face each other it is long: then the middle nearest to the origin.
static void find_place(struct contact* contact) {
  const struct spot normal = contact->normal, back = {-normal.x, -normal.y}, side = perp(normal);
  const long double along = reach(&contact->a, normal) + contact->width / 2, slack = fabsl(contact->width) / 4;
  long double low_a, high_a, low_b, high_b, low, high, across;
  find_end(&contact->a, normal, side, slack, &low_a, &high_a);
  find_end(&contact->b, back, side, slack, &low_b, &high_b);
  low = fmaxl(low_a, low_b);
  high = fminl(high_a, high_b);
  across = low > high ? (low + high) / 2 : fminl(fmaxl(0, low), high);
  contact->place.x = along * normal.x + across * side.x;
  contact->place.y = along * normal.y + across * side.y;
}

// Is the gap between the polygons the gap between the shapes? Rounding may lose a gap that is tiny beside the shapes.
// Between two corners the gap is measured along an edge, and may be too small by a factor of up to sqrt(2).
static int is_true(const struct contact* contact, int overlap) {
  const long double width = overlap ? -contact->width : contact->width;
  return width >= 0.7L * contact->size && width <= 1.1L * contact->size;
}

int32_t find_contact(const struct pair* pair, int overlap, struct contact* out) {
  const struct shape *a = &pair->a, *b = &pair->b;
  const struct spot zero = {0, 0};
  vesica_closest_points_f64 closest;
  vesica_penetration_f64 penetration;
  struct spot other;
  int32_t error = vesica_nearest_f64(a->kind, a->numbers, b->kind, b->numbers, &closest);
  if (error == 0) error = vesica_depth_f64(a->kind, a->numbers, b->kind, b->numbers, &penetration);
  if (error != 0) return error;
  out->size = overlap ? penetration.depth : closest.distance;
  out->origin.x = closest.ax, out->origin.y = closest.ay;
  other.x = closest.bx - out->origin.x, other.y = closest.by - out->origin.y;
  find_polygon(a, out->origin, &zero, &out->a);
  find_polygon(b, out->origin, &other, &out->b);
  out->width = -INFINITY;
  try_direction(out, other);
  try_edges(out, &out->a);
  try_edges(out, &out->b);
  if (!isfinite(out->width) || (out->size > 0 && !is_true(out, overlap))) return VESICA_E_RANGE;
  find_place(out);
  return 0;
}
