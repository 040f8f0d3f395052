// SPDX-License-Identifier: Apache-2.0
#include "inset.h"

#include "contact.h"

// Pixels: the side of an inset, and the length of the gap in it.
enum { side = 62, gap = 16 };

// The corner of the drawing that is farthest from the contact at (x, y).
static void find_corner(const struct view* view, double x, double y, double* left, double* top) {
  *left = x < view->x ? view->x + drawing / 2.0 - side : view->x - drawing / 2.0;
  *top = y < view->y ? view->y + drawing / 2.0 - side : view->y - drawing / 2.0;
}

// Marks the contact, and leads from there to the inset.
static void write_leader(FILE* file, double x, double y, double left, double top) {
  fprintf(file, "<path class=\"l\" d=\"M%.2f %.2fL%.2f %.2f\"/>\n", x, y, left + side / 2.0, top + side / 2.0);
  fprintf(file, "<circle class=\"l\" cx=\"%.2f\" cy=\"%.2f\" r=\"4\"/>\n", x, y);
}

static void write_magnified(FILE* file, const struct polygon* polygon, const struct view* view, const char* css_class) {
  struct polygon moved = *polygon;
  for (int i = 0; i < moved.count; i++) {
    moved.at[i].x -= view->origin.x;
    moved.at[i].y -= view->origin.y;
  }
  // Twice the inset, so that no edge of the cut is seen.
  clip_polygon(&moved, side / view->scale);
  write_polygon(file, &moved, view, css_class);
}

// The gap as a line from shape to shape.
static void write_gap(FILE* file, const struct contact* contact) {
  const double x = (double)contact->normal.x * gap / 2, y = (double)contact->normal.y * gap / 2;
  fprintf(file, "<path class=\"g\" d=\"M%.2f %.2fL%.2f %.2f\"/>\n", -x, y, x, -y);
}

// Writes the magnified part in a square of its own, with the origin in the middle.
static void write_square(FILE* file, const struct contact* contact, int overlap, const struct view* view) {
  write_magnified(file, &contact->a, view, overlap ? "oa" : "aa");
  write_magnified(file, &contact->b, view, overlap ? "ob" : "ab");
  if (contact->size > 0) write_gap(file, contact);
}

void write_inset(FILE* file, const struct pair* pair, int overlap, const struct view* view) {
  const int half = side / 2;
  struct view magnified = {{0, 0}, 0, 0, 0};
  struct contact contact;
  double x, y, left, top;
  if (find_contact(pair, overlap, &contact) != 0) return;
  x = view->x + (double)((contact.origin.x + contact.place.x - view->origin.x) * view->scale);
  y = view->y - (double)((contact.origin.y + contact.place.y - view->origin.y) * view->scale);
  find_corner(view, x, y, &left, &top);
  write_leader(file, x, y, left, top);
  magnified.origin = contact.place;
  magnified.scale = contact.size > 0 ? gap / (long double)contact.size : view->scale * 1e6L;
  fprintf(file, "<rect class=\"p\" x=\"%.2f\" y=\"%.2f\" width=\"%d\" height=\"%d\"/>\n", left, top, side, side);
  fprintf(file, "<svg x=\"%.2f\" y=\"%.2f\" width=\"%d\" height=\"%d\" viewBox=\"%d %d %d %d\">\n", left, top, side,
          side, -half, -half, side, side);
  write_square(file, &contact, overlap, &magnified);
  fprintf(file, "</svg>\n<rect class=\"i\" x=\"%.2f\" y=\"%.2f\" width=\"%d\" height=\"%d\"/>\n", left, top, side,
          side);
  fprintf(file, "<text class=\"s\" x=\"%.2f\" y=\"%.2f\">%.3g</text>\n", left + 4, top + side - 5.0, contact.size);
}
