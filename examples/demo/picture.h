// SPDX-License-Identifier: Apache-2.0
/// An SVG picture of answered pairs: a grid of panels, each as large as its pair, in the pair's own units. Pairs
/// whose answer the eye cannot see come first, with the deciding place magnified. Consecutive questions about one pair
/// share a panel.
#ifndef PICTURE_H
#define PICTURE_H

#include <stdio.h>

#include "panel.h"

/// The pairs a picture shows; a long scene's later ones are left out.
enum { picture_capacity = 400 };

struct picture {
  long questions;                             ///< all that were answered
  long pairs;                                 ///< those of them about another pair than the one before, drawn or not
  struct panel panels[picture_capacity + 1];  ///< the last is for the newest pair that is not drawn
};

/// Adds an answered question.
void add_question(struct picture* picture, const struct pair* pair, double answer, int wrong);

/// Writes the picture. Check ferror for a failure.
void write_picture(FILE* file, const struct picture* picture);

#endif
