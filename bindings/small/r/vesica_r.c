/* SPDX-License-Identifier: Apache-2.0 */
/* Functions for vesica.R. They return the library's error codes, and R turns these into conditions. */
#include <Rinternals.h>
#include <vesica.h>

SEXP vesica_r_version(void) { return Rf_ScalarInteger(vesica_version()); }

SEXP vesica_r_strerror(SEXP code) { return Rf_mkString(vesica_strerror(Rf_asInteger(code))); }

SEXP vesica_r_overlap(SEXP kind_a, SEXP a, SEXP kind_b, SEXP b) {
  const int32_t of_a = Rf_asInteger(kind_a), of_b = Rf_asInteger(kind_b);
  const int32_t need_a = vesica_field_count(of_a), need_b = vesica_field_count(of_b);
  if (Rf_xlength(a) < need_a || Rf_xlength(b) < need_b) return Rf_ScalarInteger(VESICA_E_ARGUMENT);
  return Rf_ScalarInteger(vesica_overlap_f64(of_a, REAL(a), of_b, REAL(b)));
}

/* Five numbers, or the code of an error, which is an integer. */
SEXP vesica_r_nearest(SEXP kind_a, SEXP a, SEXP kind_b, SEXP b) {
  const int32_t of_a = Rf_asInteger(kind_a), of_b = Rf_asInteger(kind_b);
  const int32_t need_a = vesica_field_count(of_a), need_b = vesica_field_count(of_b);
  if (Rf_xlength(a) < need_a || Rf_xlength(b) < need_b) return Rf_ScalarInteger(VESICA_E_ARGUMENT);
  vesica_closest_points_f64 points;
  const int32_t code = vesica_nearest_f64(of_a, REAL(a), of_b, REAL(b), &points);
  if (code < 0) return Rf_ScalarInteger(code);
  const SEXP numbers = Rf_allocVector(REALSXP, 5);
  const double all[] = {points.distance, points.ax, points.ay, points.bx, points.by};
  for (int i = 0; i < 5; ++i) REAL(numbers)[i] = all[i];
  return numbers;
}

/* A data frame, or a matrix with a shape a row: both are columns of numbers. */
static int32_t view(SEXP kind, SEXP shapes, vesica_shapes_f64* out) {
  const int32_t of = Rf_asInteger(kind), fields = vesica_field_count(of);
  if (fields < 0) return fields;
  *out = (vesica_shapes_f64){.kind = of, .stride = sizeof(double)};
  if (Rf_isMatrix(shapes)) {
    if (!Rf_isReal(shapes) || Rf_ncols(shapes) != fields) return VESICA_E_ARGUMENT;
    out->count = Rf_nrows(shapes);
    for (int k = 0; k < fields; ++k) out->field[k] = REAL(shapes) + k * out->count;
    return 0;
  }
  if (!Rf_isVectorList(shapes) || Rf_xlength(shapes) != fields) return VESICA_E_ARGUMENT;
  out->count = Rf_xlength(VECTOR_ELT(shapes, 0));
  for (int k = 0; k < fields; ++k) {
    const SEXP column = VECTOR_ELT(shapes, k);
    if (!Rf_isReal(column) || Rf_xlength(column) != out->count) return VESICA_E_ARGUMENT;
    out->field[k] = REAL(column);
  }
  return 0;
}

/* A list of the library's result and the answers. */
SEXP vesica_r_overlap_many(SEXP kind_a, SEXP a, SEXP kind_b, SEXP b) {
  vesica_shapes_f64 of_a, of_b;
  int64_t code = view(kind_a, a, &of_a);
  if (code == 0) code = view(kind_b, b, &of_b);
  int64_t count = 0;
  if (code == 0 && of_a.count > 0 && of_b.count > 0) count = of_a.count > of_b.count ? of_a.count : of_b.count;

  uint8_t* out = (uint8_t*)R_alloc((size_t)count, 1);
  if (code == 0) code = vesica_overlap_many_f64(&of_a, &of_b, out);
  const SEXP result = PROTECT(Rf_allocVector(VECSXP, 2)), hits = Rf_allocVector(LGLSXP, (R_xlen_t)count);
  SET_VECTOR_ELT(result, 1, hits);
  SET_VECTOR_ELT(result, 0, Rf_ScalarReal((double)code));
  const int answered = code >= 0 || code == VESICA_E_SHAPE;
  for (int64_t i = 0; i < count; ++i) LOGICAL(hits)[i] = answered ? out[i] : NA_LOGICAL;
  UNPROTECT(1);
  return result;
}
