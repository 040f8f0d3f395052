// SPDX-License-Identifier: Apache-2.0
package vesica;

import static vesica.VesicaException.checked;

import java.util.Arrays;

/** Ratios of shared area, by which detections are compared, suppression by them, and distances that are asked about. */
public final class Measures {
  private Measures() {}

  /** A ratio of two shapes. An exception, if the shape whose area divides has none, or neither has. */
  public static double ratio(Ratio ratio, Shape a, Shape b) {
    double[] out = new double[1];
    checked(Native.ratioF64(ratio.value, a.kind().value, Path.lent(a), b.kind().value, Path.lent(b), out));
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
   * How {@link #suppress} chooses. With float shapes threshold and least score are rounded to float first.
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
    byte[] scratch = new byte[Vesica.length(checked(Native.nmsScratch(count)))];
    long[] keep = new long[(int) count], kept = new long[1];
    int code =
        Native.suppress(shapes.wide, shapes, scores, how.labels, how.ratio.value, how.threshold, how.leastScore,
            Math.min(how.most, count), scratch, scratch.length, keep, kept);
    return VesicaException.finished(code, Arrays.copyOf(keep, (int) kept[0]));
  }

  /**
   * How {@link #suppressSoft} chooses. With float shapes parameter and least score are rounded to float first.
   *
   * @param decay LINEAR: what has a ratio r above the parameter keeps its score times 1 - r; GAUSSIAN: times exp(-r^2 /
   *     parameter)
   * @param parameter a threshold from 0 to 1, or what r^2 is divided by
   * @param ratio any but OVER_FIRST and OVER_SECOND
   * @param labels one for each shape, only those of the same lower one another; null, if all are alike
   * @param leastScore it ends when no score is left that is at least this, from 0
   * @param most how many are kept at most
   */
  public record SoftSuppression(
      Decay decay, double parameter, Ratio ratio, int[] labels, double leastScore, long most) {
    /** By intersection over union, all alike, all that are left. */
    public SoftSuppression(Decay decay, double parameter) {
      this(decay, parameter, Ratio.OVER_UNION, null, 0, Long.MAX_VALUE);
    }
  }

  /**
   * What soft suppression keeps.
   *
   * @param items the indices of shapes as they are taken
   * @param scores what was left of their scores then
   */
  public record Kept(long[] items, double[] scores) {}

  /** Soft suppression: each shape that is taken lowers the scores of those that it has a ratio with. */
  public static Kept suppressSoft(Shapes shapes, Object scores, SoftSuppression how) {
    long count = Vesica.scores(shapes, scores);
    if (how.labels != null && how.labels.length != count) {
      throw new IllegalArgumentException(count + " shapes need as many labels, not " + how.labels.length);
    }
    long[] scratch = new long[Vesica.length(checked(Native.suppressSoftScratch(count)) / 8)];
    long[] keep = new long[(int) count], kept = new long[1];
    Object left = shapes.wide ? new double[(int) count] : new float[(int) count];
    int code =
        Native.suppressSoft(shapes.wide, shapes, scores, how.labels, how.ratio.value, how.decay.value, how.parameter,
            how.leastScore, Math.min(how.most, count), scratch, 8L * scratch.length, keep, left, kept);
    int n = (int) kept[0];
    return VesicaException.finished(
        code, new Kept(Arrays.copyOf(keep, n), Arrays.copyOf(Index.doubles(left), n)));
  }

  // ---- Distances ----

  /** The distance of two shapes or, below 0, how deep they overlap. */
  public static double signedDistance(Shape a, Shape b) {
    double[] out = new double[1];
    checked(Native.signedDistanceF64(a.kind().value, Path.lent(a), b.kind().value, Path.lent(b), out));
    return out[0];
  }

  /** The signed distance of a[i] and b[i]. Returns how many overlap. */
  public static long signedDistanceMany(Shapes a, Shapes b, Object out) {
    Vesica.output("out", out, a, b, Vesica.inStep(a, b));
    return checked(Native.signedDistanceMany(a.wide, a, b, out));
  }

  /** The signed distance of each of a and each of b: element i * b.count() + j. Returns how many pairs overlap. */
  public static long signedDistanceMatrix(Shapes a, Shapes b, Object out) {
    Vesica.output("out", out, a, b, Vesica.pairs(a, b));
    return checked(Native.signedDistanceMatrix(a.wide, a, b, out, b.count));
  }

  /**
   * Are two shapes at most {@code distance} apart? Exactly so far counts, and exact, but for ellipses. If it is negative:
   * do they overlap at least that deep?
   */
  public static Within within(Shape a, Shape b, double distance) {
    int kindA = a.kind().value, kindB = b.kind().value;
    return Within.of((int) checked(Native.withinF64(kindA, Path.lent(a), kindB, Path.lent(b), distance)));
  }

  /**
   * Are a[i] and b[i] so near? The values of {@link Within}. Returns how many are, or nearly. With float shapes {@code
   * distance} is rounded to float first: 0.1 is then 0.1f.
   */
  public static long withinMany(Shapes a, Shapes b, double distance, byte[] out) {
    Vesica.room("out", out.length, Vesica.inStep(a, b));
    return checked(Native.withinMany(a.wide, a, b, distance, out));
  }

  /**
   * Is each of a so near to each of b? Element i * b.count() + j is of a[i] and b[j]. With float shapes {@code
   * distance} is rounded to float first.
   */
  public static long withinMatrix(Shapes a, Shapes b, double distance, byte[] out) {
    Vesica.room("out", out.length, Vesica.pairs(a, b));
    return checked(Native.withinMatrix(a.wide, a, b, distance, out, b.count));
  }
}
