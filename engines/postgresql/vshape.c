// SPDX-License-Identifier: Apache-2.0
/// The type's input and output, and its questions.

#include "vshape.h"

#include "libpq/pqformat.h"
#include "utils/builtins.h"
#include "utils/geo_decls.h"

PG_MODULE_MAGIC;

void _PG_init(void);

void _PG_init(void) {
  if (vesica_version() < VESICA_VERSION)
    ereport(ERROR, (errcode(ERRCODE_SYSTEM_ERROR), errmsg("libvesica %d is older than this extension, which needs %d",
                                                          vesica_version(), VESICA_VERSION)));
}

// ---- Input and output ----

PG_FUNCTION_INFO_V1(vshape_in);
Datum vshape_in(PG_FUNCTION_ARGS) {
  char fault[shape_fault_room];
  struct shape* shape = palloc(sizeof *shape);
  if (!shape_from_text(PG_GETARG_CSTRING(0), shape, fault))
    ereport(ERROR, (errcode(ERRCODE_INVALID_TEXT_REPRESENTATION), errmsg("vshape: %s", fault)));
  PG_RETURN_POINTER(shape);
}

PG_FUNCTION_INFO_V1(vshape_out);
Datum vshape_out(PG_FUNCTION_ARGS) {
  char* text = palloc(shape_text_room);
  shape_to_text(PG_GETARG_VSHAPE(0), text);
  PG_RETURN_CSTRING(text);
}

PG_FUNCTION_INFO_V1(vshape_recv);
Datum vshape_recv(PG_FUNCTION_ARGS) {
  StringInfo message = (StringInfo)PG_GETARG_POINTER(0);
  const int32_t kind = (int32_t)pq_getmsgint(message, 4);
  double numbers[shape_numbers];
  char fault[shape_fault_room] = "unknown kind";
  struct shape* shape = palloc(sizeof *shape);
  for (int i = 0; i < vesica_field_count(kind) && i < shape_numbers; i++) numbers[i] = pq_getmsgfloat8(message);
  if (!shape_from_numbers(kind, numbers, shape, fault))
    ereport(ERROR, (errcode(ERRCODE_INVALID_BINARY_REPRESENTATION), errmsg("vshape: %s", fault)));
  PG_RETURN_POINTER(shape);
}

PG_FUNCTION_INFO_V1(vshape_send);
Datum vshape_send(PG_FUNCTION_ARGS) {
  const struct shape* shape = PG_GETARG_VSHAPE(0);
  StringInfoData message;
  pq_begintypsend(&message);
  pq_sendint32(&message, (uint32)shape->kind);
  for (int i = 0; i < vesica_field_count(shape->kind); i++) pq_sendfloat8(&message, shape->numbers[i]);
  PG_RETURN_BYTEA_P(pq_endtypsend(&message));
}

PG_FUNCTION_INFO_V1(vs_valid);
Datum vs_valid(PG_FUNCTION_ARGS) {
  char fault[shape_fault_room];
  struct shape shape;
  PG_RETURN_BOOL(shape_from_text(text_to_cstring(PG_GETARG_TEXT_PP(0)), &shape, fault));
}

static Datum from_numbers(FunctionCallInfo fcinfo, int32_t kind) {
  double numbers[shape_numbers];
  char fault[shape_fault_room];
  struct shape* shape = palloc(sizeof *shape);
  for (int i = 0; i < PG_NARGS(); i++) numbers[i] = PG_GETARG_FLOAT8(i);
  if (!shape_from_numbers(kind, numbers, shape, fault))
    ereport(ERROR, (errcode(ERRCODE_INVALID_PARAMETER_VALUE), errmsg("vshape: %s", fault)));
  PG_RETURN_POINTER(shape);
}

#define CONSTRUCTOR(name, kind) \
  PG_FUNCTION_INFO_V1(name);    \
  Datum name(PG_FUNCTION_ARGS) { return from_numbers(fcinfo, kind); }

CONSTRUCTOR(vs_point, VESICA_POINT)
CONSTRUCTOR(vs_segment, VESICA_SEGMENT)
CONSTRUCTOR(vs_circle, VESICA_CIRCLE)
CONSTRUCTOR(vs_aabb, VESICA_AABB)
CONSTRUCTOR(vs_rect, VESICA_RECT)
CONSTRUCTOR(vs_ellipse, VESICA_ELLIPSE)
CONSTRUCTOR(vs_capsule, VESICA_CAPSULE)
CONSTRUCTOR(vs_round_rect, VESICA_ROUND_RECT)

// ---- Questions ----

// Returns the library's answer, or raises its error in SQL.
static int32_t checked(int32_t answer) {
  if (answer >= 0) return answer;
  ereport(ERROR,
          (errcode(answer == VESICA_E_RANGE ? ERRCODE_NUMERIC_VALUE_OUT_OF_RANGE : ERRCODE_INVALID_PARAMETER_VALUE),
           errmsg("vshape: %s", vesica_strerror(answer))));
}

PG_FUNCTION_INFO_V1(vs_overlap);
Datum vs_overlap(PG_FUNCTION_ARGS) {
  const struct shape *a = PG_GETARG_VSHAPE(0), *b = PG_GETARG_VSHAPE(1);
  PG_RETURN_BOOL(checked(vesica_overlap_f64(a->kind, a->numbers, b->kind, b->numbers)));
}

PG_FUNCTION_INFO_V1(vs_contains);
Datum vs_contains(PG_FUNCTION_ARGS) {
  const struct shape *a = PG_GETARG_VSHAPE(0), *b = PG_GETARG_VSHAPE(1);
  PG_RETURN_BOOL(checked(vesica_contains_f64(a->kind, a->numbers, b->kind, b->numbers)));
}

PG_FUNCTION_INFO_V1(vs_inside);
Datum vs_inside(PG_FUNCTION_ARGS) {
  const struct shape *a = PG_GETARG_VSHAPE(0), *b = PG_GETARG_VSHAPE(1);
  PG_RETURN_BOOL(checked(vesica_contains_f64(b->kind, b->numbers, a->kind, a->numbers)));
}

PG_FUNCTION_INFO_V1(vs_relation);
Datum vs_relation(PG_FUNCTION_ARGS) {
  const struct shape *a = PG_GETARG_VSHAPE(0), *b = PG_GETARG_VSHAPE(1);
  const int32_t relation = checked(vesica_relation_f64(a->kind, a->numbers, b->kind, b->numbers));
  PG_RETURN_TEXT_P(cstring_to_text(relation_name(relation)));
}

PG_FUNCTION_INFO_V1(vs_distance);
Datum vs_distance(PG_FUNCTION_ARGS) {
  const struct shape *a = PG_GETARG_VSHAPE(0), *b = PG_GETARG_VSHAPE(1);
  vesica_closest_points_f64 closest;
  checked(vesica_nearest_f64(a->kind, a->numbers, b->kind, b->numbers, &closest));
  PG_RETURN_FLOAT8(closest.distance);
}

PG_FUNCTION_INFO_V1(vs_shape_area);
Datum vs_shape_area(PG_FUNCTION_ARGS) {
  const struct shape* shape = PG_GETARG_VSHAPE(0);
  double area;
  checked(vesica_shape_area_f64(shape->kind, shape->numbers, &area));
  PG_RETURN_FLOAT8(area);
}

PG_FUNCTION_INFO_V1(vs_area);
Datum vs_area(PG_FUNCTION_ARGS) {
  const struct shape *a = PG_GETARG_VSHAPE(0), *b = PG_GETARG_VSHAPE(1);
  double area;
  checked(vesica_area_f64(a->kind, a->numbers, b->kind, b->numbers, &area));
  PG_RETURN_FLOAT8(area);
}

// Two shapes without area have no ratio: NULL.
PG_FUNCTION_INFO_V1(vs_iou);
Datum vs_iou(PG_FUNCTION_ARGS) {
  const struct shape *a = PG_GETARG_VSHAPE(0), *b = PG_GETARG_VSHAPE(1);
  double ratio;
  const int32_t code = vesica_iou_f64(a->kind, a->numbers, b->kind, b->numbers, &ratio);
  if (code == VESICA_E_ARGUMENT) PG_RETURN_NULL();
  checked(code);
  PG_RETURN_FLOAT8(ratio);
}

PG_FUNCTION_INFO_V1(vs_bounds);
Datum vs_bounds(PG_FUNCTION_ARGS) {
  const struct shape* shape = PG_GETARG_VSHAPE(0);
  vesica_aabb_f64 bounds;
  BOX* box = palloc(sizeof *box);
  checked(vesica_bounds_f64(shape->kind, shape->numbers, &bounds));
  box->low.x = bounds.min_x;
  box->low.y = bounds.min_y;
  box->high.x = bounds.max_x;
  box->high.y = bounds.max_y;
  PG_RETURN_BOX_P(box);
}
