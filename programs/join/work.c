// SPDX-License-Identifier: Apache-2.0
#define _GNU_SOURCE
#include "work.h"

#include <pthread.h>
#ifdef __linux__
#include <sched.h>
#endif
#include <unistd.h>

#include "progress.h"

enum { most_threads = 256, stack_bytes = 1 << 20 };

int usable_processors(void) {
  long count = sysconf(_SC_NPROCESSORS_ONLN);
#ifdef __linux__
  cpu_set_t usable;
  if (sched_getaffinity(0, sizeof usable, &usable) == 0) count = CPU_COUNT(&usable);
#endif
  return count < 1 ? 1 : count > most_threads ? most_threads : (int)count;
}

struct work {
  pthread_mutex_t lock;
  int64_t next, count;
  void (*run)(void* context, int64_t part);
  void* context;
};

// Returns the next part, or -1.
static int64_t take_part(struct work* work) {
  int64_t part;
  pthread_mutex_lock(&work->lock);
  part = work->next < work->count ? work->next++ : -1;
  pthread_mutex_unlock(&work->lock);
  return part;
}

static void* take_parts(void* shared) {
  struct work* const work = shared;
  int64_t part;
  while ((part = take_part(work)) >= 0) work->run(work->context, part);
  return NULL;
}

void run_parts(int threads, const char* what, int64_t count, void (*run)(void* context, int64_t part), void* context) {
  struct work work = {PTHREAD_MUTEX_INITIALIZER, 0, count, run, context};
  pthread_t others[most_threads];
  pthread_attr_t attributes;
  int64_t part;
  int started = 0;
  // The library takes up to 176 KiB of stack, more than some C libraries give a thread.
  if (pthread_attr_init(&attributes) == 0) {
    pthread_attr_setstacksize(&attributes, stack_bytes);
    while (started + 1 < threads && started + 1 < count && started < most_threads &&
           pthread_create(&others[started], &attributes, take_parts, &work) == 0)
      started++;
    pthread_attr_destroy(&attributes);
  }
  while ((part = take_part(&work)) >= 0) {
    show_progress(what, (double)part / (double)count);
    run(context, part);
  }
  while (started > 0) pthread_join(others[--started], NULL);
}
