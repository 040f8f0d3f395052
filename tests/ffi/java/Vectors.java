// SPDX-License-Identifier: Apache-2.0
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.LongSupplier;

/** Vectors FILE: the shared vectors (../vectors.txt) by Vesica.java. Exit status 0 when all answers are right. */
public final class Vectors {
  private final List<Integer> lines = new ArrayList<>(), expected = new ArrayList<>();
  private final List<double[]> rects = new ArrayList<>(), ellipses = new ArrayList<>();
  private boolean allRight = true;
  private int calls = 0;

  private void check(int line, long answer, int expected) {
    if (answer == expected) return;
    System.out.println("line " + line + ": " + answer + ", not " + expected);
    allRight = false;
  }

  /** What the call returns, or the code of its error. */
  private static long answer(LongSupplier call) {
    try {
      return call.getAsLong();
    } catch (Vesica.VesicaException e) {
      return e.code;
    }
  }

  private static double[] numbers(String[] words, int first) {
    final double[] result = new double[6];
    Arrays.setAll(result, i -> Double.longBitsToDouble(Long.parseUnsignedLong(words[first + i], 16)));
    return result;
  }

  private static float[] narrow(double[] numbers) {
    final float[] result = new float[numbers.length];
    for (int i = 0; i < numbers.length; ++i) result[i] = (float) numbers[i];
    return result;
  }

  private void read(int line, String[] words) {
    final int code = Integer.parseInt(words[1]), kindA = Integer.parseInt(words[2]), kindB = Integer.parseInt(words[9]);
    final double[] a = numbers(words, 3), b = numbers(words, 10);
    switch (words[0]) {
      case "f64" -> check(line, answer(() -> Vesica.overlap(kindA, a, kindB, b) ? 1 : 0), code);
      case "f32" -> check(line, answer(() -> Vesica.overlap(kindA, narrow(a), kindB, narrow(b)) ? 1 : 0), code);
      default -> {
        lines.add(line);
        expected.add(code);
        rects.add(a);
        ellipses.add(b);
        return;
      }
    }
    ++calls;
  }

  private static double[] flat(List<double[]> shapes) {
    return shapes.stream().flatMapToDouble(Arrays::stream).toArray();
  }

  private long many(int count, boolean[] out) {
    final double[] a = flat(rects.subList(0, count)), b = flat(ellipses.subList(0, count));
    return answer(() -> Vesica.overlapMany(Vesica.RECT, a, Vesica.ELLIPSE, b, out));
  }

  private void checkBatch() {
    final boolean[] out = new boolean[lines.size()];
    int valid = 0, hits = 0;
    for (; expected.get(valid) >= 0; ++valid) hits += expected.get(valid);
    allRight &= many(valid, out) == hits;
    // With an invalid element, an error: and yet every valid one has its answer.
    allRight &= many(lines.size(), out) == -2;
    for (int i = 0; i < out.length; ++i) check(lines.get(i), out[i] ? 1 : 0, Math.max(expected.get(i), 0));
  }

  public static void main(String[] arguments) throws IOException {
    final Vectors vectors = new Vectors();
    int line = 0;
    for (String text : Files.readAllLines(Path.of(arguments[0]))) {
      ++line;
      if (!text.startsWith("#")) vectors.read(line, text.split(" "));
    }
    vectors.checkBatch();
    try {
      Vesica.overlap(Vesica.POINT, new double[] {Double.NaN, 0}, Vesica.CIRCLE, new double[] {0, 0, 1});
    } catch (Vesica.VesicaException e) {
      System.out.println("NaN: " + e.getMessage());
    }
    double[] closest = Vesica.nearest(Vesica.AABB, new double[] {0, 0, 2, 2}, Vesica.CIRCLE, new double[] {6, 1, 1});
    if (Arrays.equals(closest, new double[] {3, 2, 1, 5, 1})) System.out.println("nearest: as in C");
    System.out.println(vectors.calls + " calls, " + vectors.lines.size() + " in a batch");
    if (!vectors.allRight) System.exit(1);
  }
}
