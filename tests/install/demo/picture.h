// SPDX-License-Identifier: Apache-2.0
/// An SVG picture of answered pairs: a grid of panels, each as large as its pair, in the pair's own units.
#ifndef PICTURE_H
#define PICTURE_H

#include <stdio.h>

#include "scene.h"

/// The pairs a picture shows; a long scene's later ones are left out.
enum { picture_capacity = 400 };

struct panel {
  struct pair pair;
  int overlap;  ///< the two shapes share a point
  int wrong;    ///< the answer differs from the known one
};

struct picture {
  long pairs;  ///< answered pairs, drawn or not
  struct panel panels[picture_capacity];
};

/// Adds an answered pair, the drawing of which is red when the shapes overlap and blue when not.
void add_panel(struct picture* picture, const struct pair* pair, int overlap, int wrong);

/// Writes the picture. The file's ferror tells of a failure.
void write_picture(FILE* file, const struct picture* picture);

#endif
