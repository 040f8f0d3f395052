// SPDX-License-Identifier: Apache-2.0
/// The operator class of GiST. Keys are boxes of the server's own, with sides that shape_bounds gives: floats, so that
/// the server's functions on boxes, which multiply sides, neither overflow nor underflow. What a key cannot decide, the
/// question itself does: each answer is rechecked.
#include "vshape.h"

#include "access/gist.h"

#include <float.h>
#include <math.h>

#include "access/stratnum.h"
#include "utils/geo_decls.h"

static BOX bounds_of(const struct shape* shape) {
  vesica_aabb_f64 bounds;
  BOX box;
  shape_bounds(shape, &bounds);
  box.low.x = bounds.min_x;
  box.low.y = bounds.min_y;
  box.high.x = bounds.max_x;
  box.high.y = bounds.max_y;
  return box;
}

static bool meet(const BOX* a, const BOX* b) {
  return a->low.x <= b->high.x && b->low.x <= a->high.x && a->low.y <= b->high.y && b->low.y <= a->high.y;
}

static bool holds(const BOX* a, const BOX* b) {
  return a->low.x <= b->low.x && b->high.x <= a->high.x && a->low.y <= b->low.y && b->high.y <= a->high.y;
}

PG_FUNCTION_INFO_V1(vshape_gist_compress);
Datum vshape_gist_compress(PG_FUNCTION_ARGS) {
  GISTENTRY* entry = (GISTENTRY*)PG_GETARG_POINTER(0);
  GISTENTRY* out;
  BOX* box;
  if (!entry->leafkey) PG_RETURN_POINTER(entry);
  out = palloc(sizeof *out);
  box = palloc(sizeof *box);
  *box = bounds_of(vshape_get(entry->key));
  gistentryinit(*out, BoxPGetDatum(box), entry->rel, entry->page, entry->offset, false);
  PG_RETURN_POINTER(out);
}

// Can this key belong to a shape, or a group of shapes, for which the operator holds?
PG_FUNCTION_INFO_V1(vshape_gist_consistent);
Datum vshape_gist_consistent(PG_FUNCTION_ARGS) {
  const GISTENTRY* entry = (const GISTENTRY*)PG_GETARG_POINTER(0);
  const BOX* key = DatumGetBoxP(entry->key);
  const BOX query = bounds_of(PG_GETARG_VSHAPE(1));
  const StrategyNumber strategy = PG_GETARG_UINT16(2);
  *(bool*)PG_GETARG_POINTER(4) = true;
  switch (strategy) {
    case RTOverlapStrategyNumber:
      PG_RETURN_BOOL(meet(key, &query));
    case RTContainsStrategyNumber:
      PG_RETURN_BOOL(holds(key, &query));
    case RTContainedByStrategyNumber:
      PG_RETURN_BOOL(GIST_LEAF(entry) ? holds(&query, key) : meet(&query, key));
    default:
      elog(ERROR, "vshape: no strategy %d", strategy);
  }
}

static double gap(double low_a, double high_a, double low_b, double high_b) {
  return Max(0.0, Max(low_a - high_b, low_b - high_a));
}

static double span(double low_a, double high_a, double low_b, double high_b) {
  return Max(high_a, high_b) - Min(low_a, low_b);
}

static bool at_rim(const BOX* box) {
  return Min(box->low.x, box->low.y) <= -(double)FLT_MAX || Max(box->high.x, box->high.y) >= (double)FLT_MAX;
}

// A number that no shape under the key is nearer than, as vs_distance computes it: that may be 4 u scale below the true
// distance, u = 2^-53, and the scale is at most what both boxes span, across and up together. 2^-48 of this covers it
// and the roundings here. At the rim of the floats the span is unknown.
PG_FUNCTION_INFO_V1(vshape_gist_distance);
Datum vshape_gist_distance(PG_FUNCTION_ARGS) {
  const GISTENTRY* entry = (const GISTENTRY*)PG_GETARG_POINTER(0);
  const BOX* key = DatumGetBoxP(entry->key);
  const BOX query = bounds_of(PG_GETARG_VSHAPE(1));
  const double x = gap(key->low.x, key->high.x, query.low.x, query.high.x);
  const double y = gap(key->low.y, key->high.y, query.low.y, query.high.y);
  const double across = span(key->low.x, key->high.x, query.low.x, query.high.x) +
                        span(key->low.y, key->high.y, query.low.y, query.high.y);
  *(bool*)PG_GETARG_POINTER(4) = true;
  PG_RETURN_FLOAT8(at_rim(key) || at_rim(&query) ? 0.0 : Max(0.0, sqrt(x * x + y * y) - ldexp(across, -48)));
}
