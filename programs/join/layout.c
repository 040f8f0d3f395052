// SPDX-License-Identifier: Apache-2.0
#define _POSIX_C_SOURCE 200809L
#include "layout.h"

#include <stdio.h>
#include <string.h>
#include <strings.h>

// First the numbers of each kind, in their order.
static const struct form forms[] = {
    {VESICA_POINT, 2, {"x", "y"}},
    {VESICA_SEGMENT, 4, {"x0", "y0", "x1", "y1"}},
    {VESICA_CIRCLE, 3, {"cx", "cy", "r"}},
    {VESICA_AABB, 4, {"min_x", "min_y", "max_x", "max_y"}},
    {VESICA_RECT, 6, {"cx", "cy", "ux", "uy", "hx", "hy"}},
    {VESICA_ELLIPSE, 6, {"cx", "cy", "ux", "uy", "a", "b"}},
    {VESICA_CAPSULE, 5, {"x0", "y0", "x1", "y1", "r"}},
    {VESICA_ROUND_RECT, 7, {"cx", "cy", "ux", "uy", "hx", "hy", "r"}},
    {VESICA_RECT, 4, {"cx", "cy", "w", "h"}},
    {VESICA_RECT, 5, {"cx", "cy", "w", "h", "angle"}},
    {VESICA_RECT, 5, {"cx", "cy", "w", "h", "angle_deg"}},
    {VESICA_ELLIPSE, 5, {"cx", "cy", "a", "b", "angle"}},
    {VESICA_ELLIPSE, 5, {"cx", "cy", "a", "b", "angle_deg"}},
};
static const struct form known_text = {-1, 0, {NULL}};

enum { form_count = sizeof forms / sizeof *forms, plain_forms = VESICA_ROUND_RECT + 1, most_items = 8, item_room = 96 };

int find_column(const char* name, const char* const names[], int count) {
  for (int i = 0; i < count; i++) {
    if (strcmp(names[i], name) == 0) return i;
  }
  return -1;
}

// ---- What --shape says ----

struct item {
  char field[item_room];
  char column[item_room];
};

// Returns how many items, or 0.
static int take_items(const char* wanted, struct item items[most_items], struct fault* fault) {
  int count = 0;
  while (count < most_items) {
    const size_t length = strcspn(wanted, ","), field = strcspn(wanted, "=,");
    struct item* const item = &items[count++];
    const size_t column = field < length ? field + 1 : 0;
    if (length == 0 || length >= item_room) return fail(fault, "--shape: a name is missing or too long");
    snprintf(item->field, item_room, "%.*s", (int)field, wanted);
    snprintf(item->column, item_room, "%.*s", (int)(length - column), wanted + column);
    if (!wanted[length]) return count;
    wanted += length + 1;
  }
  return fail(fault, "--shape: more than %d columns", most_items - 1);
}

static int find_item(const struct item* items, int count, const char* field) {
  for (int i = 0; i < count; i++) {
    if (strcmp(items[i].field, field) == 0) return i;
  }
  return -1;
}

// Fills in the item of each field.
static int match(const struct form* form, const struct item* items, int count, int places[most_numbers]) {
  for (int i = 0; i < form->count; i++) {
    places[i] = find_item(items, count, form->fields[i]);
    if (places[i] < 0) return 0;
  }
  return form->count == count;
}

static const struct form* find_form(const struct item* items, int count, int32_t kind, int places[most_numbers]) {
  for (int i = 0; i < form_count; i++) {
    if ((kind < 0 || kind == forms[i].kind) && match(&forms[i], items, count, places)) return &forms[i];
  }
  // Names of one's own, in the order of the kind's numbers.
  if (kind < 0 || kind >= plain_forms || count != forms[kind].count) return NULL;
  for (int i = 0; i < count; i++) places[i] = i;
  return &forms[kind];
}

enum { list_room = 128 };

static void list_names(const char* const names[], int count, char out[list_room]) {
  size_t length = 0;
  out[0] = 0;
  for (int i = 0; i < count && length < list_room; i++) {
    length += (size_t)snprintf(out + length, list_room - length, "%s%s", i > 0 ? ", " : "", names[i]);
  }
}

static int no_column(const char* name, const char* const names[], int count, struct fault* fault) {
  char all[list_room];
  list_names(names, count, all);
  return fail(fault, "no column '%.40s' among %s", name, all);
}

static int follow(const char* wanted, int32_t kind, const char* const names[], int count, struct layout* out,
                  struct fault* fault) {
  struct item items[most_items];
  int places[most_numbers] = {0};
  const int item_count = take_items(wanted, items, fault);
  if (item_count == 0) return 0;
  out->form = item_count == 1 ? &known_text : find_form(items, item_count, kind, places);
  if (!out->form) return fail(fault, "--shape: '%.60s' are the numbers of no kind (--help)", wanted);
  for (int i = 0; i < item_count; i++) {
    const char* const column = items[places[i]].column;
    out->columns[i] = names ? find_column(column, names, count) : places[i];
    if (out->columns[i] < 0) return no_column(column, names, count, fault);
  }
  return 1;
}

// ---- What the names say ----

static int has_fields(const struct form* form, const char* const names[], int count) {
  for (int i = 0; i < form->count; i++) {
    if (find_column(form->fields[i], names, count) < 0) return 0;
  }
  return 1;
}

static int find_known_text(const char* const names[], int count) {
  static const char* const usual[] = {"wkt", "geometry", "geom", "the_geom"};
  for (size_t i = 0; i < sizeof usual / sizeof *usual; i++) {
    for (int j = 0; j < count; j++) {
      if (strcasecmp(names[j], usual[i]) == 0) return j;
    }
  }
  return -1;
}

// The name of a column that looks like a size or an angle and is none of the form's fields, or NULL. Without it a table
// of x, y, w and h would be one of points.
static const char* find_unused_size(const struct form* form, const char* const names[], int count) {
  static const char* const sizes[] = {"w",  "h",  "width", "height", "r",     "radius",    "length",
                                      "hx", "hy", "ux",    "uy",     "angle", "angle_deg", "rotation"};
  for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
    for (int j = 0; j < count; j++) {
      if (strcasecmp(names[j], sizes[i]) == 0 && find_column(names[j], form->fields, form->count) < 0) return names[j];
    }
  }
  return NULL;
}

// The form with most fields among those whose fields are all there: a capsule has a segment's and one more.
static int guess(int32_t kind, const char* const names[], int count, struct layout* out, struct fault* fault) {
  const int text = kind < 0 || has_vertices(kind) ? find_known_text(names, count) : -1;
  int found = 0, most = 0;
  if (text >= 0) {
    out->form = &known_text;
    out->columns[0] = text;
    return 1;
  }
  for (int i = 0; i < form_count; i++) {
    const struct form* const form = &forms[i];
    if ((kind >= 0 && kind != form->kind) || form->count < most || !has_fields(form, names, count)) continue;
    found = form->count > most ? 1 : found + 1;
    most = form->count;
    out->form = form;
  }
  if (found != 1) {
    const char* const what = found > 0 ? "more than one kind" : kind < 0 ? "no kind" : vesica_kind_name(kind);
    char all[list_room];
    list_names(names, count, all);
    return fail(fault,
                kind < 0 || found > 0 ? "its columns (%s) are those of %s: --shape tells which"
                                      : "its columns (%s) are not those of %s: --shape tells which",
                all, what);
  }
  const char* const unused = find_unused_size(out->form, names, count);
  if (kind < 0 && unused) {
    return fail(fault, "its columns are those of %s, but there is '%.40s': --shape or --kind tells which",
                vesica_kind_name(out->form->kind), unused);
  }
  for (int i = 0; i < out->form->count; i++) out->columns[i] = find_column(out->form->fields[i], names, count);
  return 1;
}

static int follow_kind(int32_t kind, int count, struct layout* out, struct fault* fault) {
  if (kind < 0) return fail(fault, "plain numbers: --kind or --shape tells what a row is");
  if (kind >= plain_forms || count != forms[kind].count) {
    return fail(fault, "%d columns, but %s has %d numbers", count, vesica_kind_name(kind), vesica_field_count(kind));
  }
  out->form = &forms[kind];
  for (int i = 0; i < count; i++) out->columns[i] = i;
  return 1;
}

int find_layout(const char* wanted, int32_t kind, const char* const names[], int count, struct layout* out,
                struct fault* fault) {
  if (wanted) return follow(wanted, kind, names, count, out, fault);
  return names ? guess(kind, names, count, out, fault) : follow_kind(kind, count, out, fault);
}

// ---- Shapes ----

// Centre, half sizes and angle. Where this fails, the numbers stay: they say why.
static void turn(const struct form* form, const double* values, double scale, struct shape* out) {
  const double box[5] = {values[0], values[1], scale * values[2], scale * values[3], form->count == 5 ? values[4] : 0};
  const int32_t unit =
      form->count == 5 && strcmp(form->fields[4], "angle") == 0 ? VESICA_ANGLE_RADIANS : VESICA_ANGLE_DEGREES;
  vesica_rect_f64 rect = {box[0], box[1], box[4] - box[4] + 1, 0, box[2], box[3]};
  if (vesica_rects_from_boxes_f64(box, 1, 0, unit, &rect) < 0) {
    rect = (vesica_rect_f64){box[0], box[1], box[4] - box[4] + 1, 0, box[2], box[3]};
  }
  out->numbers[0] = rect.cx;
  out->numbers[1] = rect.cy;
  out->numbers[2] = rect.ux;
  out->numbers[3] = rect.uy;
  out->numbers[4] = rect.hx;
  out->numbers[5] = rect.hy;
}

void make_shape(const struct form* form, const double* values, struct shape* out) {
  out->kind = form->kind;
  if (form - forms >= plain_forms) {
    turn(form, values, form->kind == VESICA_ELLIPSE ? 2 : 1, out);
  } else {
    memcpy(out->numbers, values, (size_t)form->count * sizeof *values);
  }
}
