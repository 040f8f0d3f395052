// SPDX-License-Identifier: Apache-2.0
/// The demo's output: a table of answers on request, every wrong answer, and a summary by query.
#ifndef REPORT_H
#define REPORT_H

#include "query.h"
#include "scene.h"

struct tally {
  long pairs, right, wrong, unknown;  ///< unknown: the scene names no answer to compare with
};

struct report {
  int table;    ///< print every answer, not only the wrong ones
  long faults;  ///< lines with errors
  struct tally tally[query_count];
};

/// The head of the table, when it is asked for.
void print_head(const struct report* report);

/// Counts an answer, and prints it when it is wrong or the table is asked for. Returns 1 when it is wrong.
int report_answer(struct report* report, const struct pair* pair, long number, double answer);

/// Counts a line with an error, and prints its number and the reason on standard error.
void report_fault(struct report* report, const char* path, long number, const char* reason);

/// How many of each query, right and wrong; then all together.
void print_summary(const struct report* report);

/// All queries together.
struct tally total(const struct report* report);

#endif
