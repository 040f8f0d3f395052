// SPDX-License-Identifier: Apache-2.0
#include "plan.h"

#include <math.h>
#include <mpi.h>
#include <stdlib.h>

enum { sample_a_piece = 512 };

struct place {
  double x, y;
};

static int by_x(const void* a, const void* b) {
  const double x = ((const struct place*)a)->x, y = ((const struct place*)b)->x;
  return (x > y) - (x < y);
}

static int by_y(const void* a, const void* b) {
  const double x = ((const struct place*)a)->y, y = ((const struct place*)b)->y;
  return (x > y) - (x < y);
}

// Some places of a piece, at equal strides.
static int sample(const struct piece* piece, struct place* out) {
  int count = 0;
  for (int i = 0; i < sample_a_piece && piece->count > 0; i++) {
    const double* numbers = piece->records[piece->count * i / sample_a_piece].numbers;
    if (isfinite(numbers[0]) && isfinite(numbers[1])) out[count++] = (struct place){numbers[0], numbers[1]};
  }
  return count;
}

// The samples of all ranks; where one has fewer the rest repeats a place of some rank, or the origin.
static struct place* gather(const struct piece pieces[2], int ranks, int* count) {
  const int room = 2 * sample_a_piece;
  struct place* mine = memory(room * (int64_t)sizeof *mine);
  struct place* all = memory((int64_t)ranks * room * (int64_t)sizeof *all);
  int used = sample(&pieces[0], mine);
  used += sample(&pieces[1], mine + used);
  for (int i = used; i < room; i++) mine[i] = used > 0 ? mine[i % used] : (struct place){0, 0};
  MPI_Allgather(mine, 2 * room, MPI_DOUBLE, all, 2 * room, MPI_DOUBLE, MPI_COMM_WORLD);
  free(mine);
  *count = ranks * room;
  return all;
}

static int first_rank(const struct plan* plan, int column) { return plan->ranks * column / plan->columns; }

struct plan make_plan(const struct piece pieces[2], int ranks) {
  struct plan plan = {ranks, (int)sqrt((double)ranks), NULL, NULL};
  int count;
  struct place* places = gather(pieces, ranks, &count);
  const int each = count / ranks;
  plan.column_ends = memory(plan.columns * (int64_t)sizeof(double));
  plan.cell_ends = memory(ranks * (int64_t)sizeof(double));
  qsort(places, (size_t)count, sizeof *places, by_x);
  for (int column = 0; column < plan.columns; column++) {
    const int begin = first_rank(&plan, column), end = first_rank(&plan, column + 1);
    plan.column_ends[column] = places[end * each - 1].x;
    qsort(places + begin * each, (size_t)((end - begin) * each), sizeof *places, by_y);
    for (int cell = begin; cell < end; cell++) plan.cell_ends[cell] = places[(cell + 1) * each - 1].y;
  }
  free(places);
  return plan;
}

int rank_of(const struct plan* plan, const struct record* record) {
  int column = 0, cell;
  while (column + 1 < plan->columns && record->numbers[0] > plan->column_ends[column]) column++;
  cell = first_rank(plan, column);
  while (cell + 1 < first_rank(plan, column + 1) && record->numbers[1] > plan->cell_ends[cell]) cell++;
  return cell;
}
