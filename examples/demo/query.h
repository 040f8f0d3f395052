// SPDX-License-Identifier: Apache-2.0
/// The questions a scene may ask. A new query of the library is one row more in query.c.
#ifndef QUERY_H
#define QUERY_H

#include <stdint.h>

struct pair;

struct query {
  const char* name;  ///< as in the scene file's query column
  /// Writes the answer and returns 0, or returns a VESICA_E_ code.
  int32_t (*answer)(const struct pair* pair, double* out);
  int yes_no;  ///< the answer is 1 or 0
};

enum { query_count = 9 };
extern const struct query queries[query_count];

/// The query of that name, or NULL.
const struct query* find_query(const char* name);

#endif
