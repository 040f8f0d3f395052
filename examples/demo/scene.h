// SPDX-License-Identifier: Apache-2.0
/// Scene files: one pair of shapes a line, with what is asked and, where known, the answer. The demo has its own reader
/// of cases.csv: it is a user's program, built from outside against the installed library alone.
///
/// Two forms, which may be mixed. Blank lines, lines that begin with #, and the table's header are skipped.
///  - A table row as in tests/corpus/cases.csv: 20 fields between commas, id,source,kind_a,a0..a5,kind_b,b0..b5,
///    query,expected,tolerance,note. Columns a kind does not use are empty; no quoting. A rounded rectangle has more
///    numbers than columns.
///  - Short: a query (overlap if none is named); two shapes, each a kind and its numbers, between spaces or commas;
///    then `=` and the answer, if known. `rect 0 0 1 0 2 1  ellipse 3 0 1 0 1 0.5 = 1  # touching`
#ifndef SCENE_H
#define SCENE_H

#include <stdint.h>

struct query;

enum { most_numbers = 7 };

struct shape {
  int32_t kind;
  double numbers[most_numbers];  ///< in the order of vesica.h
};

struct pair {
  char id[48];  ///< a row's id, cut to fit, or "line N"
  struct shape a, b;
  const struct query* query;
  int has_known;
  double known;      ///< the known answer
  double tolerance;  ///< largest allowed difference from it
};

struct fault {
  char text[160];  ///< what is wrong with a line
};

enum line_meaning { line_empty, line_pair, line_fault };

/// Reads one line, which it cuts into pieces, into a pair of two valid shapes; or says in `fault` what is wrong.
enum line_meaning parse_line(char* text, long number, struct pair* pair, struct fault* fault);

#endif
