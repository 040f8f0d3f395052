// SPDX-License-Identifier: Apache-2.0
/// Work in parts, on several threads.
#ifndef WORK_H
#define WORK_H

#include <stdint.h>

/// How many processors this process may use.
int usable_processors(void);

/// Runs all parts, 0 ... count - 1, on so many threads or fewer, and returns when all have ended. They begin in order.
/// Meanwhile shows progress.
void run_parts(int threads, const char* what, int64_t count, void (*run)(void* context, int64_t part), void* context);

#endif
