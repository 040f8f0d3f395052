// SPDX-License-Identifier: Apache-2.0
/// The type vshape: what the server holds are the bytes of shape_to_blob, of a shape that was valid when it came.
#ifndef VESICA_VSHAPE_H
#define VESICA_VSHAPE_H

#include "postgres.h"
#include "fmgr.h"

#include "shape.h"

/// The shape of a value; its vertices are in memory of the current context.
void vshape_read(Datum value, struct shape* out);
const struct shape* vshape_get(Datum value);

#define PG_GETARG_VSHAPE(n) vshape_get(PG_GETARG_DATUM(n))

#endif
