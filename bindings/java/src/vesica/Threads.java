// SPDX-License-Identifier: Apache-2.0
package vesica;

import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.ForkJoinTask;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.IntConsumer;
import java.util.stream.IntStream;

/** Calls that are divided among threads. */
final class Threads {
  /** With fewer elements each, starting a thread takes longer than it saves. */
  private static final int LEAST = 50_000;

  private Threads() {}

  /** How many threads work on so many elements, if the caller asks for {@code threads}. */
  static int count(int threads, long elements) {
    if (threads < 0) throw new IllegalArgumentException(threads + " threads");
    if (threads > 0) return threads;
    return (int) Math.min(Runtime.getRuntime().availableProcessors(), 1 + elements / LEAST);
  }

  /** The task of each part once, by at most so many threads at the same time. The first part's exception is thrown. */
  static void eachPart(int threads, int parts, IntConsumer task) {
    AtomicInteger next = new AtomicInteger();
    RuntimeException[] thrown = new RuntimeException[parts];
    Runnable work = () -> {
      for (int part = next.getAndIncrement(); part < parts; part = next.getAndIncrement()) {
        try {
          task.accept(part);
        } catch (RuntimeException e) {
          thrown[part] = e;
        }
      }
    };
    // One that starts late finds no part; if the pool is busy, this thread does all.
    ForkJoinTask<?>[] others = IntStream.range(1, Math.min(threads, parts))
        .mapToObj(i -> ForkJoinPool.commonPool().submit(work)).toArray(ForkJoinTask<?>[]::new);
    work.run();
    for (ForkJoinTask<?> other : others) other.join();
    for (RuntimeException e : thrown) if (e != null) throw e;
  }
}
