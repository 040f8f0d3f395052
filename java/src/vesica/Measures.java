// SPDX-License-Identifier: Apache-2.0
package vesica;

import static vesica.VesicaException.checked;

import java.util.Arrays;

/** Ratios of shared area, by which detections are compared, and suppression by them. */
public final class Measures {
  private Measures() {}

  /** A ratio of two shapes. An exception, if the shape whose area divides has none, or neither has. */
  public static double ratio(Ratio ratio, Shape a, Shape b) {
    double[] out = new double[1];
    checked(Native.ratioF64(ratio.value, a.kind().value, a.numbers(), b.kind().value, b.numbers(), out));
    return out[0];
  }

  /**
   * A ratio of a[i] and b[i]; arrays in step are those of {@link Vesica#iouMany}. Where there is none the result is
   * NaN, all others are written, and there is an exception.
   *
   * @return how many are above 0
   */
  public static long ratioMany(Ratio ratio, Shapes a, Shapes b, Object out) {
    Vesica.output("out", out, a, b, Vesica.inStep(a, b));
    return checked(Native.ratioMany(a.wide, ratio.value, a, b, out));
  }

  /** A ratio of each of a with each of b: element i * b.count() + j. Returns how many are above 0. */
  public static long ratioMatrix(Ratio ratio, Shapes a, Shapes b, Object out) {
    Vesica.output("out", out, a, b, Vesica.pairs(a, b));
    return checked(Native.ratioMatrix(a.wide, ratio.value, a, b, out, b.count));
  }

  /**
   * How {@link #suppress} chooses.
   *
   * @param threshold each shape kept has at most this ratio with every better one that was kept
   * @param ratio any but OVER_FIRST and OVER_SECOND
   * @param labels one for each shape, only those of the same suppress one another; null, if all are alike
   * @param leastScore shapes below it are not looked at
   * @param most how many are kept at most
   */
  public record Suppression(double threshold, Ratio ratio, int[] labels, double leastScore, long most) {
    /** By intersection over union, all alike, without a least score or a greatest number. */
    public Suppression(double threshold) {
      this(threshold, Ratio.OVER_UNION, null, Double.NEGATIVE_INFINITY, Long.MAX_VALUE);
    }
  }

  /**
   * Greedy suppression: the indices of the shapes kept, best score first.
   *
   * @param scores a double[], float[] or direct buffer, as the shapes' numbers
   */
  public static long[] suppress(Shapes shapes, Object scores, Suppression how) {
    long count = Vesica.scores(shapes, scores);
    if (how.labels != null && how.labels.length != count) {
      throw new IllegalArgumentException(count + " shapes need as many labels, not " + how.labels.length);
    }
    byte[] scratch = new byte[Math.toIntExact(checked(Native.nmsScratch(count)))];
    long[] keep = new long[(int) count], kept = new long[1];
    int code =
        Native.suppress(shapes.wide, shapes, scores, how.labels, how.ratio.value, how.threshold, how.leastScore,
            Math.min(how.most, count), scratch, scratch.length, keep, kept);
    return VesicaException.finished(code, Arrays.copyOf(keep, (int) kept[0]));
  }
}
