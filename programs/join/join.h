// SPDX-License-Identifier: Apache-2.0
/// The join of two operands, or of one with itself, written as it is found.
#ifndef JOIN_H
#define JOIN_H

#include "operand.h"
#include "output.h"

struct question {
  int32_t query;       ///< VESICA_JOIN_OVERLAP ..., without a distance
  int has_distance;    ///< pairs within the distance
  double distance;     ///< or the largest of neighbours
  int64_t neighbours;  ///< of each shape of A, or 0
};

struct join {
  const struct operand *a, *b;  ///< the same one: pairs of two different shapes of it
  struct question question;
  int threads;
  struct output* output;  ///< NULL to count alone
  pthread_mutex_t lock;
  int64_t pairs;  ///< found
  int32_t error;  ///< of the library, or 0
  int short_of_memory;
};

/// Finds all pairs and writes each as a row. Of one operand, of pairs that have no order the lower number is first.
/// Neighbours have their distance as well. Returns 1, or 0 with join->error, with memory that is short, or with
/// output->failed.
int run_join(struct join* join);

#endif
