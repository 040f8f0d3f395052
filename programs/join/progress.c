// SPDX-License-Identifier: Apache-2.0
#define _POSIX_C_SOURCE 200809L
#include "progress.h"

#include <stdio.h>
#include <time.h>
#include <unistd.h>

static double due = 0;  // when the terminal is next written to; 0 before anything is shown
static int shown = 0, hidden = 0;

double seconds(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

void show_progress(const char* what, double share) {
  const double now = seconds();
  if (due == 0) due = now + 0.5;
  if (now < due || hidden || !isatty(STDERR_FILENO)) return;
  fprintf(stderr, "\r\033[K%s: %.0f%%", what, 100 * share);
  fflush(stderr);
  due = now + 0.1;
  shown = 1;
}

void hide_progress(void) { hidden = 1; }

void end_progress(void) {
  if (shown) fputs("\r\033[K", stderr);
  shown = 0;
}
