// SPDX-License-Identifier: Apache-2.0
import java.util.Locale;
import java.util.function.IntConsumer;
import vesica.Kind;
import vesica.Rect;
import vesica.Shapes;
import vesica.Vesica;

/** What calls cost from Java: as bench/hosts/overhead.c does, with the same rectangles. */
public final class Overhead {
  private static final int COUNT = 1_000_000;
  private static double sum;

  private static Rect rect(long i) {
    boolean odd = i % 2 == 1;
    return new Rect(
        (i * 7919 % 4001) / 1000.0, (i * 104729 % 4003) / 1000.0, odd ? 5.0 / 13 : 0.8, odd ? 12.0 / 13 : 0.6,
        0.5 + (i % 100) / 200.0, 0.5 + (i % 70) / 140.0);
  }

  private static double least(int repeats, int calls, IntConsumer call) {
    double best = 1e300;
    for (int repeat = 0; repeat < repeats; repeat++) {
      long start = System.nanoTime();
      for (int i = 0; i < calls; i++) call.accept(i);
      best = Math.min(best, (double) (System.nanoTime() - start) / calls);
    }
    return best;
  }

  private static void row(String question, IntConsumer one, IntConsumer many) {
    System.out.printf(Locale.ROOT, "Java %s %.4g %.4g %.4g%n", question, least(100, 1000, one),
        least(100, 1, i -> many.accept(1000)) / 1e3, least(7, 1, i -> many.accept(COUNT)) / COUNT);
  }

  public static void main(String[] arguments) {
    double[][] numbers = new double[2][6 * COUNT];
    Rect[] a = new Rect[1000], b = new Rect[1000];
    for (int i = 0; i < COUNT; i++) {
      Rect first = rect(i), second = rect(3L * i + 1);
      System.arraycopy(first.numbers(), 0, numbers[0], 6 * i, 6);
      System.arraycopy(second.numbers(), 0, numbers[1], 6 * i, 6);
      if (i < 1000) a[i] = first;
      if (i < 1000) b[i] = second;
    }
    boolean[] hits = new boolean[COUNT];
    double[][] c = new double[5][COUNT];
    Shapes[] all = {Shapes.of(Kind.RECT, numbers[0]), Shapes.of(Kind.RECT, numbers[1])};
    Shapes[] some = {Shapes.of(Kind.RECT, a), Shapes.of(Kind.RECT, b)};
    row("overlap", i -> sum += Vesica.overlap(a[i % 1000], b[i % 1000]) ? 1 : 0,
        n -> Vesica.overlapMany((n == COUNT ? all : some)[0], (n == COUNT ? all : some)[1], hits));
    row("nearest", i -> sum += Vesica.nearest(a[i % 1000], b[i % 1000]).distance(),
        n -> {
          Shapes[] of = n == COUNT ? all : some;
          Vesica.nearestMany(of[0], of[1], c[0], c[1], c[2], c[3], c[4]);
        });
    row("iou", i -> sum += Vesica.iou(a[i % 1000], b[i % 1000]),
        n -> Vesica.iouMany((n == COUNT ? all : some)[0], (n == COUNT ? all : some)[1], c[0]));
  }
}
