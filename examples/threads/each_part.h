/* SPDX-License-Identifier: Apache-2.0 */
/* How parts of a question are handed to threads. c11.c, openmp.c and pool.c each have one way. */
#ifndef EACH_PART_H
#define EACH_PART_H

#include <stdint.h>

/** Calls task(part, user) for each part once, by so many threads at the same time, and returns when all are done. */
void each_part(int threads, int64_t parts, void (*task)(int64_t part, void* user), void* user);

#endif
