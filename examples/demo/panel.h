// SPDX-License-Identifier: Apache-2.0
/// One pair of a picture: its drawing, its inset if it needs one, its caption.
#ifndef PANEL_H
#define PANEL_H

#include <stdio.h>

#include "scene.h"

/// Pixels from one panel to the next.
enum { panel_width = 168, panel_height = 216 };

/// How a pair looks: plain to the eye, or too close to see whether the shapes are apart, overlap or touch.
enum look { look_apart_close, look_overlap_close, look_touch, look_plain, look_count };

struct panel {
  struct pair pair;  ///< as in the first question about it
  char answers[80];  ///< to all questions in words, but for yes and no
  int wrong;         ///< an answer differs from the known one
  int overlap;       ///< the two shapes share a point
  double size;       ///< distance if the shapes are apart, depth if they overlap
  enum look look;    ///< plain, unless the size is too small to see
};

/// A panel for a pair, without answers.
void fill_panel(struct panel* panel, const struct pair* pair);

/// Adds the answer to pair->query.
void add_answer(struct panel* panel, const struct pair* pair, double answer, int wrong);

/// Does the panel show the shapes of this pair, in either order?
int shows_pair(const struct panel* panel, const struct pair* pair);

/// Writes a panel as a group of SVG elements.
void write_panel(FILE* file, const struct panel* panel, int left, int top);

#endif
