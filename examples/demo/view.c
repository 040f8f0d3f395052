// SPDX-License-Identifier: Apache-2.0
#include "view.h"

#include <math.h>
#include <vesica.h>

int32_t find_view(const struct pair* pair, double left, double top, struct view* out) {
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

// SVG's y points down.
static double pixel_x(const struct view* view, struct spot spot) { return view->x + (double)(spot.x * view->scale); }
static double pixel_y(const struct view* view, struct spot spot) { return view->y - (double)(spot.y * view->scale); }

static int is_small(const struct polygon* polygon, const struct view* view) {
  for (int i = 1; i < polygon->count; i++) {
    if (fabs(pixel_x(view, polygon->at[i]) - pixel_x(view, polygon->at[0])) > 2) return 0;
    if (fabs(pixel_y(view, polygon->at[i]) - pixel_y(view, polygon->at[0])) > 2) return 0;
  }
  return 1;
}

void write_polygon(FILE* file, const struct polygon* polygon, const struct view* view, const char* css_class) {
  if (polygon->count == 0) return;
  if (is_small(polygon, view)) {
    fprintf(file, "<circle class=\"%s\" cx=\"%.2f\" cy=\"%.2f\" r=\"3\"/>\n", css_class, pixel_x(view, polygon->at[0]),
            pixel_y(view, polygon->at[0]));
    return;
  }
  fprintf(file, "<path class=\"%s\" d=\"", css_class);
  for (int i = 0; i < polygon->count; i++) {
    fprintf(file, "%c%.2f %.2f", i == 0 ? 'M' : 'L', pixel_x(view, polygon->at[i]), pixel_y(view, polygon->at[i]));
  }
  fputs("Z\"/>\n", file);
}

void write_shape(FILE* file, const struct shape* shape, const struct view* view, const char* css_class) {
  struct polygon polygon;
  find_polygon(shape, view->origin, NULL, &polygon);
  write_polygon(file, &polygon, view, css_class);
}
