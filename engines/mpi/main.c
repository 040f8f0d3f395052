// SPDX-License-Identifier: Apache-2.0
/// All pairs of shapes that overlap, of two files, by the ranks of MPI: mpirun -n 4 join_mpi A.npy B.npy PAIRS
///
/// Each rank reads a run of each file. A plan of cells, one a rank, is made from a sample, and each shape goes to the
/// rank of its cell. All ranks know the bounds of all pieces of A. Each sends its shapes of B to pieces whose bounds
/// they meet. A shape of A is in one place, so each pair is found once. Rank r writes its pairs, as lines `a,b` of
/// places in the files from 0, to PAIRS.r.csv, which is there only when all ranks have ended well.
#define _POSIX_C_SOURCE 200809L
#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>

#include "piece.h"
#include "plan.h"

static int rank, ranks;

/// Records for each rank, side by side.
struct parcel {
  int *counts, *starts;
  struct record* records;
};

static struct parcel new_parcel(void) {
  struct parcel parcel = {memory(ranks * (int64_t)sizeof(int)), memory((ranks + 1) * (int64_t)sizeof(int)), NULL};
  memset(parcel.counts, 0, (size_t)ranks * sizeof(int));
  return parcel;
}

// Places for the records, once they have been counted.
static void make_room(struct parcel* parcel) {
  parcel->starts[0] = 0;
  for (int i = 0; i < ranks; i++) parcel->starts[i + 1] = parcel->starts[i] + parcel->counts[i];
  parcel->records = memory(parcel->starts[ranks] * (int64_t)sizeof(struct record));
}

static void free_parcel(struct parcel* parcel) {
  free(parcel->counts);
  free(parcel->starts);
  free(parcel->records);
}

// Sends each rank its records, and returns those from all. What goes to other ranks is added to `bytes`.
static struct piece exchange(struct parcel* out, int64_t* bytes) {
  struct parcel in = new_parcel();
  struct piece piece = {.count = 0};
  MPI_Datatype record;
  MPI_Type_contiguous(sizeof(struct record), MPI_BYTE, &record);
  MPI_Type_commit(&record);
  MPI_Alltoall(out->counts, 1, MPI_INT, in.counts, 1, MPI_INT, MPI_COMM_WORLD);
  make_room(&in);
  MPI_Alltoallv(out->records, out->counts, out->starts, record, in.records, in.counts, in.starts, record,
                MPI_COMM_WORLD);
  *bytes += (int64_t)sizeof(struct record) * (out->starts[ranks] - out->counts[rank]);
  MPI_Type_free(&record);
  piece.count = in.starts[ranks];
  piece.records = in.records;
  in.records = NULL;
  free_parcel(&in);
  free_parcel(out);
  return piece;
}

// The shapes whose cell is this rank's.
static struct piece shuffle(struct piece* run, const struct plan* plan, int64_t* bytes) {
  struct parcel out = new_parcel();
  int* used = memory(ranks * (int64_t)sizeof(int));
  for (int64_t i = 0; i < run->count; i++) out.counts[rank_of(plan, &run->records[i])]++;
  make_room(&out);
  memcpy(used, out.starts, (size_t)ranks * sizeof(int));
  for (int64_t i = 0; i < run->count; i++) out.records[used[rank_of(plan, &run->records[i])]++] = run->records[i];
  free(used);
  free(run->records);
  return exchange(&out, bytes);
}

// Which items of a piece meet a box? Their number, and the items if `out` is not NULL. An empty box is inverted.
static int64_t meet(const struct piece* piece, const vesica_aabb_f64* box, int64_t* out, int64_t room) {
  vesica_shapes_f64 window;
  int64_t state[4] = {0, 0, 0, 0};
  const int64_t all = vesica_index_order(piece->index, NULL, 0);
  if (box->min_x > box->max_x) return 0;
  if (vesica_check_f64(VESICA_AABB, &box->min_x) < 0)  // infinite bounds: all of them
    return out ? vesica_index_order(piece->index, out, room) : all;
  vesica_shapes_from_records_f64(VESICA_AABB, 1, box, sizeof *box, &window);
  return vesica_index_select_f64(piece->index, piece->sets, kind_count, &window, out, out ? room : 0, state);
}

// The shapes of b, of all ranks, that meet this rank's piece of a.
static struct piece gather_neighbours(const struct piece* a, const struct piece* b, int64_t* bytes) {
  struct parcel out = new_parcel();
  vesica_aabb_f64 mine, *all = memory(ranks * (int64_t)sizeof *all);
  int64_t* items = memory((b->count + 1) * (int64_t)sizeof *items);
  vesica_index_bounds(a->index, &mine);
  MPI_Allgather(&mine, 4, MPI_DOUBLE, all, 4, MPI_DOUBLE, MPI_COMM_WORLD);
  for (int to = 0; to < ranks; to++) out.counts[to] = (int)meet(b, &all[to], NULL, 0);
  make_room(&out);
  for (int to = 0; to < ranks; to++) {
    struct record* records = out.records + out.starts[to];
    const int64_t found = meet(b, &all[to], items, out.counts[to] + 1);
    for (int64_t i = 0; i < found; i++) records[i] = b->records[items[i]];
  }
  free(items);
  free(all);
  return exchange(&out, bytes);
}

static int64_t write_pairs(const struct piece* a, const struct piece* b, const char* path) {
  enum { room = 4096 };
  static int64_t first[room], second[room];
  int64_t state[4] = {0, 0, 0, 0}, pairs = 0;
  void* scratch = memory(vesica_join_scratch());
  FILE* file = fopen(path, "w");
  if (!file) give_up(path, "cannot be written");
  while (state[0] != -1) {
    const int64_t found = vesica_join_f64(VESICA_JOIN_OVERLAP, a->index, a->sets, kind_count, b->index, b->sets,
                                          kind_count, 0, 1, scratch, vesica_join_scratch(), first, second, room, state);
    for (int64_t i = 0; i < found; i++)
      fprintf(file, "%lld,%lld\n", (long long)a->records[first[i]].id, (long long)b->records[second[i]].id);
    pairs += found;
  }
  if (fflush(file) != 0 || ferror(file) || fclose(file) != 0) give_up(path, "cannot be written");
  free(scratch);
  return pairs;
}

// Rank 0 prints the sums over all ranks, the longest time and the largest memory.
static void report(int64_t sums[5], double seconds) {
  struct rusage usage;
  double most[2] = {seconds, 0}, all[2];
  int64_t total[5];
  getrusage(RUSAGE_SELF, &usage);
  most[1] = (double)usage.ru_maxrss / 1024;
  MPI_Reduce(most, all, 2, MPI_DOUBLE, MPI_MAX, 0, MPI_COMM_WORLD);
  MPI_Reduce(sums, total, 5, MPI_INT64_T, MPI_SUM, 0, MPI_COMM_WORLD);
  if (rank != 0) return;
  if (total[4] > 0) fprintf(stderr, "join_mpi: %lld invalid shapes have no pairs\n", (long long)total[4]);
  printf("ranks %d shapes %lld pairs %lld seconds %.3f MiB %.0f shuffled %lld neighbours %lld\n", ranks,
         (long long)total[0], (long long)total[1], all[0], all[1], (long long)total[2], (long long)total[3]);
}

int main(int count, char** arguments) {
  struct piece runs[2], a, b, near_a;
  struct plan plan;
  char path[4096], unfinished[4200];
  int64_t shapes, pairs, shuffled = 0, neighbours = 0, sums[5];
  double begin;
  MPI_Init(&count, &arguments);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  if (count != 4 || strlen(arguments[3]) > 4000) give_up("usage", "mpirun -n RANKS join_mpi A.npy B.npy PAIRS");
  for (int i = 0; i < 2; i++) runs[i] = read_run(arguments[1 + i], rank, ranks);
  shapes = runs[0].count + runs[1].count;
  MPI_Barrier(MPI_COMM_WORLD);
  begin = MPI_Wtime();
  plan = make_plan(runs, ranks);
  a = shuffle(&runs[0], &plan, &shuffled);
  b = shuffle(&runs[1], &plan, &shuffled);
  index_piece(&a);
  index_piece(&b);
  near_a = gather_neighbours(&a, &b, &neighbours);
  index_piece(&near_a);
  snprintf(path, sizeof path, "%s.%d.csv", arguments[3], rank);
  snprintf(unfinished, sizeof unfinished, "%s.part", path);
  pairs = write_pairs(&a, &near_a, unfinished);
  MPI_Barrier(MPI_COMM_WORLD);
  if (rename(unfinished, path) != 0) give_up(path, "cannot be written");
  memcpy(sums, (const int64_t[5]){shapes, pairs, shuffled, neighbours, a.invalid + b.invalid}, sizeof sums);
  report(sums, MPI_Wtime() - begin);
  free_piece(&a);
  free_piece(&b);
  free_piece(&near_a);
  free(plan.column_ends);
  free(plan.cell_ends);
  MPI_Finalize();
  return 0;
}
