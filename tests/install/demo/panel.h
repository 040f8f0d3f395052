// SPDX-License-Identifier: Apache-2.0
/// One pair of a picture: its drawing, its inset if it needs one, its caption.
#ifndef PANEL_H
#define PANEL_H

#include <stdio.h>

#include "scene.h"

/// Pixels from one panel to the next.
enum { panel_width = 168, panel_height = 204 };

struct panel {
  struct pair pair;
  double answer;
  int wrong;    ///< the answer differs from the known one
  int overlap;  ///< the two shapes share a point
  int close;    ///< what decides this is too small to see
  double size;  ///< distance if the shapes are apart, depth if they overlap
};

void fill_panel(struct panel* panel, const struct pair* pair, double answer, int wrong);

/// Writes a panel as a group of SVG elements.
void write_panel(FILE* file, const struct panel* panel, int left, int top);

#endif
