// SPDX-License-Identifier: Apache-2.0
/// Threads of C11, started for each question.
#include <stdatomic.h>
#include <threads.h>

#include "each_part.h"

enum { most_threads = 256 };

struct work {
  void (*task)(int64_t part, void* user);
  void* user;
  int64_t parts;
  atomic_int_fast64_t next;
};

/* Takes the next part until none is left: some take longer than others. */
static int do_parts(void* work) {
  struct work* w = work;
  for (int64_t part; (part = atomic_fetch_add(&w->next, 1)) < w->parts;) w->task(part, w->user);
  return 0;
}

void each_part(int threads, int64_t parts, void (*task)(int64_t part, void* user), void* user) {
  struct work w = {task, user, parts, 0};
  thrd_t others[most_threads];
  int started = 0;
  /* If the system has no more threads, those that there are do the work. */
  while (started < threads - 1 && started < most_threads && thrd_create(&others[started], do_parts, &w) == thrd_success)
    started++;
  do_parts(&w);
  while (started > 0) thrd_join(others[--started], NULL);
}
