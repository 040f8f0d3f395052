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

// ---- Values ----

static struct vertices vertices_of(int64 vertices, int64 rings) {
  return (struct vertices){
      .xy = MemoryContextAllocHuge(CurrentMemoryContext, (Size)(vertices + 1) * 2 * sizeof(double)),
      .room = vertices,
      .rings = palloc((Size)(rings + 1) * sizeof(int32_t)),
      .ring_room = rings + 1};
}

void vshape_read(Datum value, struct shape* out) {
  struct varlena* bytes = PG_DETOAST_DATUM_PACKED(value);
  const unsigned char* blob = (const unsigned char*)VARDATA_ANY(bytes);
  char fault[shape_fault_room];
  int64_t counts[2];
  struct vertices vertices = {0};
  // Room that suffices: it never grows.
  if (shape_blob_counts(blob, VARSIZE_ANY_EXHDR(bytes), counts)) vertices = vertices_of(counts[0], counts[1]);
  if (!shape_from_blob(blob, VARSIZE_ANY_EXHDR(bytes), &vertices, out, fault))
    ereport(ERROR, (errcode(ERRCODE_DATA_CORRUPTED), errmsg("vshape: %s", fault)));
  if ((Pointer)bytes != DatumGetPointer(value)) pfree(bytes);
}

const struct shape* vshape_get(Datum value) {
  struct shape* shape = palloc(sizeof *shape);
  vshape_read(value, shape);
  return shape;
}

static Datum value_of(const struct shape* shape) {
  const Size size = VARHDRSZ + shape_blob_size(shape);
  struct varlena* bytes = palloc(size);
  SET_VARSIZE(bytes, size);
  shape_to_blob(shape, (unsigned char*)VARDATA(bytes));
  return PointerGetDatum(bytes);
}

// ---- Input and output ----

PG_FUNCTION_INFO_V1(vshape_in);
Datum vshape_in(PG_FUNCTION_ARGS) {
  char fault[shape_fault_room];
  struct vertices vertices = {0};
  struct shape shape;
  const int good = shape_from_text(PG_GETARG_CSTRING(0), &vertices, &shape, fault);
  const Datum value = good ? value_of(&shape) : (Datum)0;
  free_vertices(&vertices);
  if (!good) ereport(ERROR, (errcode(ERRCODE_INVALID_TEXT_REPRESENTATION), errmsg("vshape: %s", fault)));
  return value;
}

PG_FUNCTION_INFO_V1(vs_from_wkb);
Datum vs_from_wkb(PG_FUNCTION_ARGS) {
  bytea* bytes = PG_GETARG_BYTEA_PP(0);
  char fault[shape_fault_room];
  struct vertices vertices = {0};
  struct shape shape;
  const int good =
      shape_from_wkb((const unsigned char*)VARDATA_ANY(bytes), VARSIZE_ANY_EXHDR(bytes), &vertices, &shape, fault);
  const Datum value = good ? value_of(&shape) : (Datum)0;
  free_vertices(&vertices);
  if (!good) ereport(ERROR, (errcode(ERRCODE_INVALID_BINARY_REPRESENTATION), errmsg("vshape: %s", fault)));
  return value;
}

PG_FUNCTION_INFO_V1(vshape_out);
Datum vshape_out(PG_FUNCTION_ARGS) {
  const struct shape* shape = PG_GETARG_VSHAPE(0);
  char* text = palloc(shape_text_room(shape));
  shape_to_text(shape, text);
  PG_RETURN_CSTRING(text);
}

static void bad_bytes(const char* fault) {
  ereport(ERROR, (errcode(ERRCODE_INVALID_BINARY_REPRESENTATION), errmsg("vshape: %s", fault)));
}

// The number of rings, where each ends among the vertices, the vertices.
static void receive_path(StringInfo message, struct shape* out) {
  const int64 left = message->len - message->cursor;
  const int64 rings = pq_getmsgint(message, 4);
  struct vertices vertices;
  int32_t code;
  if (rings < 1 || rings > left / 4) bad_bytes("a number of rings that cannot be");
  vertices = vertices_of(left / 16, rings);
  vertices.ring_count = rings;
  vertices.rings[0] = 0;
  for (int64 j = 1; j <= rings; j++) {
    vertices.rings[j] = (int32_t)pq_getmsgint(message, 4);
    if (vertices.rings[j] <= vertices.rings[j - 1] || vertices.rings[j] > vertices.room)
      bad_bytes("rings that cannot be");
  }
  vertices.count = vertices.rings[rings];
  for (int64 i = 0; i < 2 * vertices.count; i++) vertices.xy[i] = pq_getmsgfloat8(message);
  out->path = view_vertices(&vertices);
  code = vesica_check_f64(out->kind, &out->path);
  if (code < 0) bad_bytes(vesica_strerror(code));
}

PG_FUNCTION_INFO_V1(vshape_recv);
Datum vshape_recv(PG_FUNCTION_ARGS) {
  StringInfo message = (StringInfo)PG_GETARG_POINTER(0);
  struct shape shape = {.kind = (int32_t)pq_getmsgint(message, 4)};
  double numbers[shape_numbers];
  char fault[shape_fault_room] = "unknown kind";
  if (shape_has_path(shape.kind)) {
    receive_path(message, &shape);
    return value_of(&shape);
  }
  for (int i = 0; i < vesica_field_count(shape.kind) && i < shape_numbers; i++) numbers[i] = pq_getmsgfloat8(message);
  if (!shape_from_numbers(shape.kind, numbers, &shape, fault)) bad_bytes(fault);
  return value_of(&shape);
}

PG_FUNCTION_INFO_V1(vshape_send);
Datum vshape_send(PG_FUNCTION_ARGS) {
  const struct shape* shape = PG_GETARG_VSHAPE(0);
  const vesica_polygon_f64* path = &shape->path;
  StringInfoData message;
  pq_begintypsend(&message);
  pq_sendint32(&message, (uint32)shape->kind);
  if (shape_has_path(shape->kind)) {
    pq_sendint32(&message, (uint32)path->count);
    for (int64 j = 1; j <= path->count; j++) pq_sendint32(&message, (uint32)path->rings[j]);
    for (int64 i = 0; i < 2 * (int64)path->rings[path->count]; i++) pq_sendfloat8(&message, path->x[i]);
  } else {
    for (int i = 0; i < vesica_field_count(shape->kind); i++) pq_sendfloat8(&message, shape->numbers[i]);
  }
  PG_RETURN_BYTEA_P(pq_endtypsend(&message));
}

PG_FUNCTION_INFO_V1(vs_valid);
Datum vs_valid(PG_FUNCTION_ARGS) {
  char fault[shape_fault_room];
  struct vertices vertices = {0};
  struct shape shape;
  const bool valid = shape_from_text(text_to_cstring(PG_GETARG_TEXT_PP(0)), &vertices, &shape, fault);
  free_vertices(&vertices);
  PG_RETURN_BOOL(valid);
}

static Datum from_numbers(FunctionCallInfo fcinfo, int32_t kind) {
  double numbers[shape_numbers];
  char fault[shape_fault_room];
  struct shape shape;
  for (int i = 0; i < PG_NARGS(); i++) numbers[i] = PG_GETARG_FLOAT8(i);
  if (!shape_from_numbers(kind, numbers, &shape, fault))
    ereport(ERROR, (errcode(ERRCODE_INVALID_PARAMETER_VALUE), errmsg("vshape: %s", fault)));
  return value_of(&shape);
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
  PG_RETURN_BOOL(checked(vesica_overlap_f64(a->kind, shape_data(a), b->kind, shape_data(b))));
}

PG_FUNCTION_INFO_V1(vs_contains);
Datum vs_contains(PG_FUNCTION_ARGS) {
  const struct shape *a = PG_GETARG_VSHAPE(0), *b = PG_GETARG_VSHAPE(1);
  PG_RETURN_BOOL(checked(vesica_contains_f64(a->kind, shape_data(a), b->kind, shape_data(b))));
}

PG_FUNCTION_INFO_V1(vs_inside);
Datum vs_inside(PG_FUNCTION_ARGS) {
  const struct shape *a = PG_GETARG_VSHAPE(0), *b = PG_GETARG_VSHAPE(1);
  PG_RETURN_BOOL(checked(vesica_contains_f64(b->kind, shape_data(b), a->kind, shape_data(a))));
}

PG_FUNCTION_INFO_V1(vs_relation);
Datum vs_relation(PG_FUNCTION_ARGS) {
  const struct shape *a = PG_GETARG_VSHAPE(0), *b = PG_GETARG_VSHAPE(1);
  const int32_t relation = checked(vesica_relation_f64(a->kind, shape_data(a), b->kind, shape_data(b)));
  PG_RETURN_TEXT_P(cstring_to_text(relation_name(relation)));
}

PG_FUNCTION_INFO_V1(vs_distance);
Datum vs_distance(PG_FUNCTION_ARGS) {
  const struct shape *a = PG_GETARG_VSHAPE(0), *b = PG_GETARG_VSHAPE(1);
  vesica_closest_points_f64 closest;
  checked(vesica_nearest_f64(a->kind, shape_data(a), b->kind, shape_data(b), &closest));
  PG_RETURN_FLOAT8(closest.distance);
}

PG_FUNCTION_INFO_V1(vs_shape_area);
Datum vs_shape_area(PG_FUNCTION_ARGS) {
  const struct shape* shape = PG_GETARG_VSHAPE(0);
  double area;
  checked(vesica_shape_area_f64(shape->kind, shape_data(shape), &area));
  PG_RETURN_FLOAT8(area);
}

PG_FUNCTION_INFO_V1(vs_area);
Datum vs_area(PG_FUNCTION_ARGS) {
  const struct shape *a = PG_GETARG_VSHAPE(0), *b = PG_GETARG_VSHAPE(1);
  double area;
  checked(vesica_area_f64(a->kind, shape_data(a), b->kind, shape_data(b), &area));
  PG_RETURN_FLOAT8(area);
}

// Two shapes without area have no ratio: NULL.
PG_FUNCTION_INFO_V1(vs_iou);
Datum vs_iou(PG_FUNCTION_ARGS) {
  const struct shape *a = PG_GETARG_VSHAPE(0), *b = PG_GETARG_VSHAPE(1);
  double ratio;
  const int32_t code = vesica_iou_f64(a->kind, shape_data(a), b->kind, shape_data(b), &ratio);
  if (code == VESICA_E_ARGUMENT) PG_RETURN_NULL();
  checked(code);
  PG_RETURN_FLOAT8(ratio);
}

PG_FUNCTION_INFO_V1(vs_bounds);
Datum vs_bounds(PG_FUNCTION_ARGS) {
  const struct shape* shape = PG_GETARG_VSHAPE(0);
  vesica_aabb_f64 bounds;
  BOX* box = palloc(sizeof *box);
  checked(vesica_bounds_f64(shape->kind, shape_data(shape), &bounds));
  box->low.x = bounds.min_x;
  box->low.y = bounds.min_y;
  box->high.x = bounds.max_x;
  box->high.y = bounds.max_y;
  PG_RETURN_BOX_P(box);
}
