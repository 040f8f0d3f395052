// SPDX-License-Identifier: Apache-2.0
#include "panel.h"

#include <math.h>
#include <string.h>
#include <vesica.h>

#include "contact.h"
#include "line.h"
#include "polygon.h"
#include "query.h"

// Pixels.
enum { gutter = 8, drawing = 136, border = 10, inset = 62, inset_gap = 16 };

/// Where the plane's `origin` is drawn, and how many pixels a unit of it has.
struct view {
  struct spot origin;
  double x, y;
  long double scale;
};

// Bounds of the pair, in the middle of a square of `drawing` pixels.
static int32_t find_view(const struct pair* pair, double left, double top, struct view* out) {
  vesica_aabb_f64 a, b;
  long double low_x, low_y, high_x, high_y, extent;
  int32_t error = vesica_bounds_f64(pair->a.kind, pair->a.numbers, &a);
  if (error == 0) error = vesica_bounds_f64(pair->b.kind, pair->b.numbers, &b);
  if (error != 0) return error;
  low_x = fmin(a.min_x, b.min_x), high_x = fmax(a.max_x, b.max_x);
  low_y = fmin(a.min_y, b.min_y), high_y = fmax(a.max_y, b.max_y);
  extent = fmaxl(high_x - low_x, high_y - low_y);
  out->origin.x = low_x + (high_x - low_x) / 2;
  out->origin.y = low_y + (high_y - low_y) / 2;
  out->x = left + drawing / 2.0;
  out->y = top + drawing / 2.0;
  out->scale = extent > 0 ? drawing / extent : 1;
  return isfinite(extent) && isfinite(out->scale) ? 0 : VESICA_E_RANGE;
}

void fill_panel(struct panel* panel, const struct pair* pair, double answer, int wrong) {
  const double seen = 1.5;  // pixels
  struct view view;
  panel->pair = *pair;
  panel->answer = answer;
  panel->wrong = wrong;
  panel->overlap = vesica_overlap_f64(pair->a.kind, pair->a.numbers, pair->b.kind, pair->b.numbers) == 1;
  panel->close = find_query(panel->overlap ? "depth" : "distance")->answer(pair, &panel->size) == 0 &&
                 find_view(pair, 0, 0, &view) == 0 && (double)(panel->size * view.scale) < seen;
}

static void write_polygon(FILE* file, const struct polygon* polygon, const struct view* view, const char* css_class) {
  double largest = 0;
  for (int i = 0; i < polygon->count; i++) {
    largest = fmax(largest, fabs((double)((polygon->at[i].x - polygon->at[0].x) * view->scale)));
    largest = fmax(largest, fabs((double)((polygon->at[i].y - polygon->at[0].y) * view->scale)));
  }
  if (polygon->count > 0 && largest < 2) {
    fprintf(file, "<circle class=\"%s\" cx=\"%.2f\" cy=\"%.2f\" r=\"2\"/>\n", css_class,
            view->x + (double)(polygon->at[0].x * view->scale), view->y - (double)(polygon->at[0].y * view->scale));
    return;
  }
  fprintf(file, "<path class=\"%s\" d=\"", css_class);
  // SVG's y points down.
  for (int i = 0; i < polygon->count; i++) {
    fprintf(file, "%c%.2f %.2f", i == 0 ? 'M' : 'L', view->x + (double)(polygon->at[i].x * view->scale),
            view->y - (double)(polygon->at[i].y * view->scale));
  }
  fputs("Z\"/>\n", file);
}

static void write_shape(FILE* file, const struct shape* shape, const struct view* view, const char* css_class) {
  struct polygon polygon;
  find_polygon(shape, view->origin, NULL, &polygon);
  write_polygon(file, &polygon, view, css_class);
}

static void write_magnified(FILE* file, const struct polygon* polygon, const struct contact* contact,
                            const struct view* view, const char* css_class) {
  struct polygon moved = *polygon;
  for (int i = 0; i < moved.count; i++) {
    moved.at[i].x -= contact->place.x;
    moved.at[i].y -= contact->place.y;
  }
  // Twice the inset, so that no edge of the cut is seen.
  clip_polygon(&moved, inset / view->scale);
  write_polygon(file, &moved, view, css_class);
}

// The gap as a line from shape to shape.
static void write_gap(FILE* file, const struct contact* contact) {
  const double x = (double)contact->normal.x * inset_gap / 2, y = (double)contact->normal.y * inset_gap / 2;
  fprintf(file, "<path class=\"g\" d=\"M%.2f %.2fL%.2f %.2f\"/>\n", -x, y, x, -y);
}

// The inset, in the corner of the drawing that is farthest from the contact.
static void write_inset(FILE* file, const struct panel* panel, const struct view* view) {
  struct view magnified = {{0, 0}, 0, 0, 0};
  struct contact contact;
  double x, y, left, top;
  if (find_contact(&panel->pair, panel->overlap, &contact) != 0) return;
  x = view->x + (double)((contact.origin.x + contact.place.x - view->origin.x) * view->scale);
  y = view->y - (double)((contact.origin.y + contact.place.y - view->origin.y) * view->scale);
  left = x < view->x ? view->x + drawing / 2.0 - inset : view->x - drawing / 2.0;
  top = y < view->y ? view->y + drawing / 2.0 - inset : view->y - drawing / 2.0;
  magnified.scale = contact.size > 0 ? inset_gap / (long double)contact.size : view->scale * 1e6L;
  fprintf(file, "<path class=\"l\" d=\"M%.2f %.2fL%.2f %.2f\"/>\n", x, y, left + inset / 2.0, top + inset / 2.0);
  fprintf(file, "<circle class=\"l\" cx=\"%.2f\" cy=\"%.2f\" r=\"4\"/>\n", x, y);
  fprintf(file, "<svg x=\"%.2f\" y=\"%.2f\" width=\"%d\" height=\"%d\" viewBox=\"%g %g %d %d\">\n", left, top, inset,
          inset, -inset / 2.0, -inset / 2.0, inset, inset);
  fprintf(file, "<rect fill=\"#fff\" x=\"%d\" y=\"%d\" width=\"%d\" height=\"%d\"/>\n", -inset, -inset, 2 * inset,
          2 * inset);
  write_magnified(file, &contact.a, &contact, &magnified, panel->overlap ? "oa" : "aa");
  write_magnified(file, &contact.b, &contact, &magnified, panel->overlap ? "ob" : "ab");
  if (contact.size > 0) write_gap(file, &contact);
  fprintf(file, "</svg>\n<rect class=\"i\" x=\"%.2f\" y=\"%.2f\" width=\"%d\" height=\"%d\"/>\n", left, top, inset,
          inset);
}

static void write_drawing(FILE* file, const struct panel* panel, double left, double top) {
  struct view view;
  if (find_view(&panel->pair, left, top, &view) != 0) {
    fprintf(file, "<text class=\"d\" x=\"%.2f\" y=\"%.2f\">too large to draw</text>\n", left, top + drawing / 2.0);
    return;
  }
  write_shape(file, &panel->pair.a, &view, panel->overlap ? "oa" : "aa");
  write_shape(file, &panel->pair.b, &view, panel->overlap ? "ob" : "ab");
  if (panel->close) write_inset(file, panel, &view);
}

// Writes the first `limit` characters, or fewer if the text ends.
static void put_escaped(FILE* file, const char* text, size_t limit) {
  char shown[2] = {0, 0};
  for (; limit > 0 && *text; text++, limit--) {
    switch (*text) {
      case '&':
        fputs("&amp;", file);
        break;
      case '<':
        fputs("&lt;", file);
        break;
      case '>':
        fputs("&gt;", file);
        break;
      default:
        shown[0] = *text;
        put_printable(file, shown, 1);
    }
  }
}

// An id that is too long for a panel loses its middle: its end often counts the cases of one source.
static void put_id(FILE* file, const char* id) {
  const size_t most = 26, head = 15, tail = 8, length = strlen(id);
  put_escaped(file, id, length <= most ? most : head);
  if (length <= most) return;
  fputs("...", file);
  put_escaped(file, id + length - tail, tail);
}

static void put_numbers(FILE* file, const struct shape* shape) {
  fputs(vesica_kind_name(shape->kind), file);
  for (int i = 0; i < vesica_field_count(shape->kind); i++) fprintf(file, " %.17g", shape->numbers[i]);
}

static void put_verdict(FILE* file, const struct panel* panel) {
  if (panel->close && panel->size == 0) {
    fputs("touch: they overlap", file);
  } else if (panel->close) {
    fprintf(file, "%s by %.2g", panel->overlap ? "overlap" : "apart", panel->size);
  } else {
    fputs(panel->overlap ? "overlap" : "apart", file);
  }
  if (panel->wrong) fputs(" (WRONG)", file);
}

static void write_caption(FILE* file, const struct panel* panel, double x, double y) {
  fprintf(file, "<text class=\"%s\" x=\"%.2f\" y=\"%.2f\">", panel->overlap ? "vo" : "va", x, y);
  put_verdict(file, panel);
  fprintf(file, "</text>\n<text class=\"d\" x=\"%.2f\" y=\"%.2f\">%s, %s", x, y + 13,
          vesica_kind_name(panel->pair.a.kind), vesica_kind_name(panel->pair.b.kind));
  if (!panel->pair.query->yes_no) fprintf(file, ": %s %.6g", panel->pair.query->name, panel->answer);
  fprintf(file, "</text>\n<text class=\"d\" x=\"%.2f\" y=\"%.2f\">", x, y + 25);
  put_id(file, panel->pair.id);
  fputs("</text>\n", file);
}

void write_panel(FILE* file, const struct panel* panel, int left, int top) {
  fputs("<g><title>", file);
  put_escaped(file, panel->pair.id, sizeof panel->pair.id);
  fputs("\n", file);
  put_numbers(file, &panel->pair.a);
  fputs("\n", file);
  put_numbers(file, &panel->pair.b);
  fprintf(file, "</title>\n<rect class=\"%s\" x=\"%d\" y=\"%d\" width=\"%d\" height=\"%d\" rx=\"4\"/>\n",
          panel->wrong ? "w" : "f", left, top, panel_width - gutter, panel_height - gutter);
  write_drawing(file, panel, left + (panel_width - gutter - drawing) / 2.0, top + border);
  write_caption(file, panel, left + border, top + border + drawing + 18);
  fputs("</g>\n", file);
}
