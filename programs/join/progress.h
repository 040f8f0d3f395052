// SPDX-License-Identifier: Apache-2.0
/// Shows progress on a terminal after half a second.
#ifndef PROGRESS_H
#define PROGRESS_H

/// Seconds since some moment.
double seconds(void);

/// Says on standard error what is being done, and how much of it is done, from 0 to 1. To be called often.
void show_progress(const char* what, double share);

/// Shows none from now on.
void hide_progress(void);

/// Wipes that away, before anything else is written.
void end_progress(void);

#endif
