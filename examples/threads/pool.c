// SPDX-License-Identifier: Apache-2.0
/// A pool: threads that are started once, and wait for the next question.
#include <threads.h>

#include "each_part.h"

static struct {
  mtx_t lock;
  cnd_t begun, ended;
  int threads; /* in the pool, and the caller */
  void (*task)(int64_t part, void* user);
  void* user;
  int64_t parts, next, done;
} pool;

/* With the lock held: works on parts until none is left to begin. */
static void do_parts(void) {
  while (pool.next < pool.parts) {
    const int64_t part = pool.next++;
    mtx_unlock(&pool.lock);
    pool.task(part, pool.user);
    mtx_lock(&pool.lock);
    if (++pool.done == pool.parts) cnd_signal(&pool.ended);
  }
}

static int wait_for_parts(void* unused) {
  (void)unused;
  mtx_lock(&pool.lock);
  do do_parts();
  while (cnd_wait(&pool.begun, &pool.lock) == thrd_success);
  mtx_unlock(&pool.lock);
  return 0;
}

static void init_pool(void) {
  mtx_init(&pool.lock, mtx_plain);
  cnd_init(&pool.begun);
  cnd_init(&pool.ended);
  pool.threads = 1;
}

/* For one caller at a time. */
void each_part(int threads, int64_t parts, void (*task)(int64_t part, void* user), void* user) {
  static once_flag once = ONCE_FLAG_INIT;
  call_once(&once, init_pool);
  for (thrd_t thread; pool.threads < threads && thrd_create(&thread, wait_for_parts, NULL) == thrd_success;) {
    thrd_detach(thread);
    pool.threads++;
  }
  mtx_lock(&pool.lock);
  pool.task = task;
  pool.user = user;
  pool.parts = parts;
  pool.next = pool.done = 0;
  cnd_broadcast(&pool.begun);
  do_parts();
  while (pool.done < pool.parts) cnd_wait(&pool.ended, &pool.lock);
  mtx_unlock(&pool.lock);
}
