// SPDX-License-Identifier: Apache-2.0
/// The join of two operands, or of one with itself, written as it is found.
#ifndef JOIN_H
#define JOIN_H

#include <stdio.h>

#include "operand.h"

struct join {
  const struct operand *a, *b;  ///< the same one: pairs of two different shapes of it
  int32_t query;                ///< VESICA_JOIN_OVERLAP ...
  FILE* out;                    ///< NULL to count alone
  int64_t pairs;                ///< found
  double seconds;               ///< spent in finding them
  int32_t error;                ///< of the library, or 0
};

/// Finds all pairs and writes each as a line of the two numbers in the files. Of one operand, of pairs that have no
/// order the lower number is first. Returns 1, or 0 where memory is short or `out` cannot be written.
int run_join(struct join* join);

#endif
