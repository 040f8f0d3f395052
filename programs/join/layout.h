// SPDX-License-Identifier: Apache-2.0
/// Which columns of a table make a shape, and how.
#ifndef LAYOUT_H
#define LAYOUT_H

#include "shapes.h"

/// The columns of a table are numbers by these names, or one of well-known text.
struct form {
  int32_t kind;
  int count;  ///< 0 of well-known text
  const char* fields[most_numbers];
};

struct layout {
  const struct form* form;
  int columns[most_numbers];  ///< of each field, or of well-known text
};

/// Finds the layout of a table. `wanted` is NULL, or the option --shape: a column of well-known text, or FIELD or
/// FIELD=COLUMN between commas. `kind` is that of the shapes, or -1. Without names the columns are in the order of
/// `wanted`, or of the kind's numbers. Returns 1, or 0 with the reason in `fault`.
int find_layout(const char* wanted, int32_t kind, const char* const names[], int count, struct layout* out,
                struct fault* fault);

/// The number of the column of that name, or -1.
int find_column(const char* name, const char* const names[], int count);

/// Makes a shape of the numbers in a row. Whether it is valid is not looked at.
void make_shape(const struct form* form, const double* values, struct shape* out);

#endif
