// SPDX-License-Identifier: Apache-2.0
/// Which rank a place of the map belongs to: columns of cells, a cell a rank, each with as many of the sampled shapes.
#ifndef PLAN_H
#define PLAN_H

#include "piece.h"

struct plan {
  int ranks, columns;
  double *column_ends, *cell_ends;  ///< a column ends at an x, a cell of it at a y
};

/// The same on all ranks, from a sample of both pieces of each.
struct plan make_plan(const struct piece pieces[2], int ranks);

/// A shape's first two numbers are a point of it, for every kind: this point's rank.
int rank_of(const struct plan* plan, const struct record* record);

#endif
