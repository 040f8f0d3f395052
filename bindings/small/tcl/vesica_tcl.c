/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Exact overlap queries between plain 2D shapes, from Tcl: `load libvesica_tcl.so Vesica`. A kind is 0 (point) to 7
 * (rounded rectangle), as in vesica.h.
 *
 *   vesica::overlap KIND LIST KIND LIST            1 where two shapes, lists of their numbers, share a point, else 0
 *   vesica::overlap_float KIND LIST KIND LIST      the same of floats
 *   vesica::nearest KIND LIST KIND LIST            the distance of two shapes, x and y of the first's closest point, x
 *                                                  and y of the second's
 *   vesica::overlap_many KIND BYTES KIND BYTES OUT two arrays of shapes in step, doubles as by `binary format d*`, not
 *                                                  copied; an array of one shape is repeated. The variable OUT gets a
 *                                                  byte for each, 1 or 0; the result is how many overlap
 *
 * Errors have the code {VESICA number}. Where a shape of an array is invalid, OUT has 0 for it and every other answer.
 */
#include <tcl.h>
#include <vesica.h>

static int fail(Tcl_Interp* interp, int64_t code) {
  Tcl_SetObjResult(interp, Tcl_NewStringObj(vesica_strerror((int32_t)code), -1));
  Tcl_Obj* const words[] = {Tcl_NewStringObj("VESICA", -1), Tcl_NewWideIntObj(code)};
  Tcl_SetObjErrorCode(interp, Tcl_NewListObj(2, words));
  return TCL_ERROR;
}

static int result(Tcl_Interp* interp, int64_t answer) {
  if (answer < 0) return fail(interp, answer);
  Tcl_SetObjResult(interp, Tcl_NewWideIntObj(answer));
  return TCL_OK;
}

static int read_number(Tcl_Interp* interp, Tcl_Obj* word, double* number) {
  const int status = Tcl_GetDoubleFromObj(interp, word, number);
  if (status == TCL_OK || word->typePtr != Tcl_GetObjType("double")) return status;
  /* NaN, which Tcl reads and then refuses: the library's answer to it is wanted. */
  *number = word->internalRep.doubleValue;
  return TCL_OK;
}

/* Reads a kind and as many numbers as it has. */
static int read_shape(Tcl_Interp* interp, Tcl_Obj* const words[2], int* kind, double numbers[7]) {
  Tcl_Obj** items;
  int length;
  if (Tcl_GetIntFromObj(interp, words[0], kind) != TCL_OK) return TCL_ERROR;
  if (Tcl_ListObjGetElements(interp, words[1], &length, &items) != TCL_OK) return TCL_ERROR;
  const int fields = vesica_field_count(*kind);
  if (fields < 0) return fail(interp, fields);
  if (length < fields) return fail(interp, VESICA_E_ARGUMENT);
  for (int i = 0; i < fields; ++i) {
    if (read_number(interp, items[i], &numbers[i]) != TCL_OK) return TCL_ERROR;
  }
  return TCL_OK;
}

static int overlap(ClientData in_float, Tcl_Interp* interp, int objc, Tcl_Obj* const objv[]) {
  double a[7] = {0}, b[7] = {0};
  float float_a[7], float_b[7];
  int kind_a, kind_b;
  if (objc != 5) {
    Tcl_WrongNumArgs(interp, 1, objv, "kindA numbersA kindB numbersB");
    return TCL_ERROR;
  }
  if (read_shape(interp, objv + 1, &kind_a, a) != TCL_OK || read_shape(interp, objv + 3, &kind_b, b) != TCL_OK) {
    return TCL_ERROR;
  }
  if (in_float == NULL) return result(interp, vesica_overlap_f64(kind_a, a, kind_b, b));
  for (int i = 0; i < 7; ++i) {
    float_a[i] = (float)a[i];
    float_b[i] = (float)b[i];
  }
  return result(interp, vesica_overlap_f32(kind_a, float_a, kind_b, float_b));
}

static int nearest(ClientData unused, Tcl_Interp* interp, int objc, Tcl_Obj* const objv[]) {
  double a[7] = {0}, b[7] = {0};
  int kind_a, kind_b;
  vesica_closest_points_f64 points;
  (void)unused;
  if (objc != 5) {
    Tcl_WrongNumArgs(interp, 1, objv, "kindA numbersA kindB numbersB");
    return TCL_ERROR;
  }
  if (read_shape(interp, objv + 1, &kind_a, a) != TCL_OK || read_shape(interp, objv + 3, &kind_b, b) != TCL_OK) {
    return TCL_ERROR;
  }
  const int32_t code = vesica_nearest_f64(kind_a, a, kind_b, b, &points);
  if (code < 0) return fail(interp, code);
  const double numbers[] = {points.distance, points.ax, points.ay, points.bx, points.by};
  Tcl_Obj* words[5];
  for (int i = 0; i < 5; ++i) words[i] = Tcl_NewDoubleObj(numbers[i]);
  Tcl_SetObjResult(interp, Tcl_NewListObj(5, words));
  return TCL_OK;
}

static int read_array(Tcl_Interp* interp, Tcl_Obj* const words[2], vesica_shapes_f64* out) {
  int kind, length;
  if (Tcl_GetIntFromObj(interp, words[0], &kind) != TCL_OK) return TCL_ERROR;
  const unsigned char* bytes = Tcl_GetByteArrayFromObj(words[1], &length);
  const int size = vesica_field_count(kind) * (int)sizeof(double);
  if (size < 0) return fail(interp, VESICA_E_KIND);
  if (length % size != 0) return fail(interp, VESICA_E_ARGUMENT);
  const int32_t code = vesica_shapes_from_records_f64(kind, length / size, bytes, size, out);
  return code < 0 ? fail(interp, code) : TCL_OK;
}

static int overlap_many(ClientData unused, Tcl_Interp* interp, int objc, Tcl_Obj* const objv[]) {
  vesica_shapes_f64 a, b;
  (void)unused;
  if (objc != 6) {
    Tcl_WrongNumArgs(interp, 1, objv, "kindA bytesA kindB bytesB out");
    return TCL_ERROR;
  }
  if (read_array(interp, objv + 1, &a) != TCL_OK || read_array(interp, objv + 3, &b) != TCL_OK) return TCL_ERROR;
  const int64_t count = a.count == 0 || b.count == 0 ? 0 : a.count > b.count ? a.count : b.count;
  Tcl_Obj* const out = Tcl_NewByteArrayObj(NULL, 0);
  const int64_t answer = vesica_overlap_many_f64(&a, &b, Tcl_SetByteArrayLength(out, (int)count));
  if (Tcl_ObjSetVar2(interp, objv[5], NULL, out, TCL_LEAVE_ERR_MSG) == NULL) return TCL_ERROR;
  return result(interp, answer);
}

int Vesica_Init(Tcl_Interp* interp);
int Vesica_Init(Tcl_Interp* interp) {
  if (Tcl_InitStubs(interp, "8.6", 0) == NULL) return TCL_ERROR;
  if (vesica_version() < VESICA_VERSION) {
    Tcl_SetObjResult(interp, Tcl_ObjPrintf("vesica %d is older than %d", (int)vesica_version(), VESICA_VERSION));
    return TCL_ERROR;
  }
  Tcl_CreateObjCommand(interp, "vesica::overlap", overlap, NULL, NULL);
  Tcl_CreateObjCommand(interp, "vesica::overlap_float", overlap, (ClientData) "float", NULL);
  Tcl_CreateObjCommand(interp, "vesica::nearest", nearest, NULL, NULL);
  Tcl_CreateObjCommand(interp, "vesica::overlap_many", overlap_many, NULL, NULL);
  return Tcl_PkgProvide(interp, "vesica", "0.1");
}
