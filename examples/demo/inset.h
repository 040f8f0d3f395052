// SPDX-License-Identifier: Apache-2.0
/// The place that decides, magnified, where it is too small to see.
#ifndef INSET_H
#define INSET_H

#include "view.h"

/// Writes the inset of a pair, whose shapes overlap or not, into a corner of its view.
void write_inset(FILE* file, const struct pair* pair, int overlap, const struct view* view);

#endif
