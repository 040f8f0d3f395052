// SPDX-License-Identifier: Apache-2.0
/// The type vshape: what the server holds is `struct shape`, 64 bytes, always valid.
#ifndef VESICA_VSHAPE_H
#define VESICA_VSHAPE_H

#include "postgres.h"
#include "fmgr.h"

#include "shape.h"

#define PG_GETARG_VSHAPE(n) ((const struct shape*)PG_GETARG_POINTER(n))

#endif
