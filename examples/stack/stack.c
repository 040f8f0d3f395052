/* SPDX-License-Identifier: Apache-2.0 */
/* A pyramid of boxes on the ground, held by sequential impulses: vesica_join_f64 finds the pairs, vesica_manifold_f64
 * their contacts, and each contact begins with its last impulse, which it is found by its numbers.
 *
 * stack [ROWS [SECONDS]] prints how far a box moved at most, and the energy. It fails if a box moved by more than a
 * twentieth of its size, or if the energy grew. 44 rows are 990 boxes.
 *
 * cc -O2 stack.c $(pkg-config --cflags --libs vesica) -lm -o stack
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <vesica.h>

enum { most_bodies = 5000, most_contacts = 8 * most_bodies, room = 1024, iterations = 30 };

typedef struct {
  double vx, vy, spin, inverse_mass, inverse_inertia;
} body;

typedef struct {
  int64_t a, b, number_a, number_b;
  double nx, ny, ax, ay, bx, by, depth; /* the normal, and the point from both centres */
  double mass, mass_across, push, drag; /* along the normal and across it: masses, and impulses so far */
} contact;

static const double gravity = 10, friction = 0.6, step = 1.0 / 60, slop = 0.005, recovery = 0.2;
static vesica_rect_f64 shape[most_bodies];
static body bodies[most_bodies];
static contact now[most_contacts], last[most_contacts];
static int64_t count, contacts, lasts;
static void *index_memory, *scratch;
static int64_t index_size, scratch_size;

static int in_order(const void* p, const void* q) {
  const contact *c = p, *d = q;
  const int64_t difference[] = {c->a - d->a, c->b - d->b, c->number_a - d->number_a, c->number_b - d->number_b};
  for (int i = 0; i < 4; i++)
    if (difference[i] != 0) return difference[i] < 0 ? -1 : 1;
  return 0;
}

/* ---- The solver ---- */

static double effective_mass(const contact* c, double x, double y) {
  const body *a = &bodies[c->a], *b = &bodies[c->b];
  const double turn_a = c->ax * y - c->ay * x, turn_b = c->bx * y - c->by * x;
  return 1 / (a->inverse_mass + b->inverse_mass + a->inverse_inertia * turn_a * turn_a +
              b->inverse_inertia * turn_b * turn_b);
}

static void add_contact(int64_t a, int64_t b, const vesica_contacts_f64* m, int second) {
  contact c = {.a = a, .b = b, .nx = m->nx, .ny = m->ny};
  const double x = second ? m->x1 : m->x0, y = second ? m->y1 : m->y0;
  c.number_a = second ? m->a1 : m->a0, c.number_b = second ? m->b1 : m->b0;
  c.depth = second ? m->depth1 : m->depth0;
  c.ax = x - shape[a].cx, c.ay = y - shape[a].cy, c.bx = x - shape[b].cx, c.by = y - shape[b].cy;
  c.mass = effective_mass(&c, c.nx, c.ny), c.mass_across = effective_mass(&c, -c.ny, c.nx);
  const contact* before = bsearch(&c, last, (size_t)lasts, sizeof c, in_order);
  if (before != NULL) c.push = before->push, c.drag = before->drag;
  if (contacts < most_contacts) now[contacts++] = c;
}

/* Finds the contacts of all pairs that overlap. */
static int64_t find_contacts(void) {
  vesica_shapes_f64 all;
  int64_t first[room], second[room], state[4] = {0, 0, 0, 0};
  vesica_contacts_f64 m;
  vesica_shapes_from_records_f64(VESICA_RECT, count, shape, sizeof *shape, &all);
  int64_t error = vesica_index_build_f64(&all, 1, index_memory, index_size, scratch, scratch_size);
  while (error >= 0 && state[0] != -1) {
    error = vesica_join_f64(VESICA_JOIN_OVERLAP, index_memory, &all, 1, index_memory, &all, 1, 0, 1, scratch,
                            scratch_size, first, second, room, state);
    for (int64_t i = 0; i < error; i++) {
      const int64_t a = first[i], b = second[i];
      const int32_t found = vesica_manifold_f64(VESICA_RECT, &shape[a], VESICA_RECT, &shape[b], &m);
      for (int k = 0; k < found; k++) add_contact(a, b, &m, k);
    }
  }
  return error;
}

static void apply(const contact* c, double x, double y) {
  body *a = &bodies[c->a], *b = &bodies[c->b];
  a->vx -= a->inverse_mass * x, a->vy -= a->inverse_mass * y;
  a->spin -= a->inverse_inertia * (c->ax * y - c->ay * x);
  b->vx += b->inverse_mass * x, b->vy += b->inverse_mass * y;
  b->spin += b->inverse_inertia * (c->bx * y - c->by * x);
}

/* The speed of b's point relative to a's, along a direction. */
static double speed(const contact* c, double x, double y) {
  const body *a = &bodies[c->a], *b = &bodies[c->b];
  return (b->vx - b->spin * c->by - a->vx + a->spin * c->ay) * x +
         (b->vy + b->spin * c->bx - a->vy - a->spin * c->ax) * y;
}

/* The total impulses stay in the friction cone. */
static void solve(contact* c, double part_of_depth) {
  const double apart = part_of_depth / step * fmax(c->depth - slop, 0);
  const double push = fmax(c->push + c->mass * (apart - speed(c, c->nx, c->ny)), 0), more = push - c->push;
  c->push = push;
  apply(c, more * c->nx, more * c->ny);
  const double most = friction * push, wanted = c->drag - c->mass_across * speed(c, -c->ny, c->nx);
  const double drag = fmin(fmax(wanted, -most), most), turn = drag - c->drag;
  c->drag = drag;
  apply(c, -turn * c->ny, turn * c->nx);
}

static int advance(void) {
  lasts = contacts, contacts = 0;
  for (int64_t i = 0; i < lasts; i++) last[i] = now[i];
  qsort(last, (size_t)lasts, sizeof *last, in_order);
  if (find_contacts() < 0) return 0;
  for (int64_t i = 0; i < count; i++)
    if (bodies[i].inverse_mass > 0) bodies[i].vy -= step * gravity;
  for (int64_t i = 0; i < contacts; i++)
    apply(&now[i], now[i].push * now[i].nx - now[i].drag * now[i].ny,
          now[i].push * now[i].ny + now[i].drag * now[i].nx);
  for (int k = 0; k < iterations; k++)
    for (int64_t i = 0; i < contacts; i++) solve(&now[i], recovery);
  for (int64_t i = 0; i < count; i++) {
    vesica_rect_f64* s = &shape[i];
    const double turn = step * bodies[i].spin, c = cos(turn), d = sin(turn), ux = s->ux;
    s->cx += step * bodies[i].vx, s->cy += step * bodies[i].vy;
    s->ux = c * ux - d * s->uy, s->uy = d * ux + c * s->uy;
  }
  for (int64_t i = 0; i < contacts; i++) solve(&now[i], 0); /* what moved boxes apart shall not be momentum */
  return 1;
}

/* ---- The pyramid ---- */

static int64_t add_box(double x, double y, double half_width, double half_height, double mass) {
  const vesica_rect_f64 s = {x, y, 1, 0, half_width, half_height};
  const body b = {0, 0, 0, mass, 3 * mass / (half_width * half_width + half_height * half_height)};
  shape[count] = s, bodies[count] = b;
  return count++;
}

static double energy(void) {
  double sum = 0;
  for (int64_t i = 1; i < count; i++) {
    const body* b = &bodies[i];
    sum += 0.5 * (b->vx * b->vx + b->vy * b->vy) + 0.5 * b->spin * b->spin / b->inverse_inertia + gravity * shape[i].cy;
  }
  return sum;
}

int main(int argc, char** argv) {
  const int rows = argc > 1 ? atoi(argv[1]) : 20;
  const double seconds = argc > 2 ? atof(argv[2]) : 10;
  if (rows < 1 || rows * (rows + 1) / 2 >= most_bodies) return 2;
  add_box(0, -1, 2 * rows, 1, 0);
  for (int row = 0; row < rows; row++)
    for (int i = 0; i < rows - row; i++) add_box(1.125 * (i - 0.5 * (rows - row - 1)), row + 0.5, 0.5, 0.5, 1);
  index_size = vesica_index_size(count), scratch_size = vesica_index_scratch(count);
  if (scratch_size < vesica_join_scratch()) scratch_size = vesica_join_scratch();
  index_memory = aligned_alloc(64, (size_t)(index_size + 63) / 64 * 64);
  scratch = aligned_alloc(64, (size_t)(scratch_size + 63) / 64 * 64);
  vesica_rect_f64* start = malloc((size_t)count * sizeof *start);
  if (index_memory == NULL || scratch == NULL || start == NULL) return 2;
  for (int64_t i = 0; i < count; i++) start[i] = shape[i];

  const double first = energy();
  double most = first, moved = 0, tilt = 0;
  for (double t = 0; t < seconds; t += step) {
    if (!advance()) return 2;
    most = fmax(most, energy());
  }
  for (int64_t i = 1; i < count; i++) {
    moved = fmax(moved, hypot(shape[i].cx - start[i].cx, shape[i].cy - start[i].cy));
    tilt = fmax(tilt, fabs(shape[i].uy));
  }
  printf(
      "%lld boxes, %lld contacts after %g s: moved by at most %.4f, tilted by %.5f; energy %.6f of the first, at most "
      "%.9f\n",
      (long long)count - 1, (long long)contacts, seconds, moved, tilt, energy() / first, most / first);
  free(index_memory), free(scratch), free(start);
  return moved < 0.05 && most <= first * (1 + 1e-9) ? 0 : 1;
}
