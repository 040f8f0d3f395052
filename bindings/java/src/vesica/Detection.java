// SPDX-License-Identifier: Apache-2.0
package vesica;

import static vesica.VesicaException.checked;

import java.util.Arrays;

/** What is done around detectors: assignment, fusion of boxes, average precision. */
public final class Detection {
  private Detection() {}

  /** Pairs of an item a[k] and an item b[k] with values[k], as {@link Index#joinRatio} gives them. */
  public record Pairs(long[] a, long[] b, double[] values) {
    /** There must be as many of each. */
    public Pairs {
      if (a.length != values.length || b.length != values.length) {
        throw new IllegalArgumentException(
            "pairs have as many a, b and values, not " + a.length + ", " + b.length + " and " + values.length);
      }
    }
  }

  /** Scratch of so many bytes, at a multiple of 8. */
  private static long[] scratch(long bytes) {
    return new long[Vesica.length((checked(bytes) + 7) / 8)];
  }

  private static long size(long[] scratch) {
    return 8L * scratch.length;
  }

  private static long end(long[] items) {
    return Arrays.stream(items).max().orElse(-1) + 1;
  }

  /**
   * Greedy assignment, as of tracks to detections: takes the pair with the highest value whose two items are both free,
   * until there is none. Which of the pairs, the best first; of equal values the one with the lower a, then b.
   */
  public static long[] assignGreedy(Pairs pairs) {
    int count = pairs.values.length;
    long countA = end(pairs.a), countB = end(pairs.b);
    long[] scratch = scratch(Native.assignGreedyScratch(count, countA, countB)), chosen = new long[count];
    return Arrays.copyOf(chosen, (int) checked(Native.assignGreedyF64(
        pairs.a, pairs.b, pairs.values, count, countA, countB, scratch, size(scratch), chosen)));
  }

  /**
   * How {@link #fuse} works. With float boxes the threshold is rounded to float first.
   *
   * @param threshold a box joins the cluster whose mean it has the highest IoU with, if that exceeds this
   * @param weights one for each box, such as that of its model, of the scores' type; null, if all are 1
   * @param labels one for each box, only those of the same are fused; null, if all are alike
   * @param score of a cluster
   */
  public record Fusion(double threshold, Object weights, int[] labels, FusedScore score) {
    /** Without weights and labels, by the mean score. */
    public Fusion(double threshold) {
      this(threshold, null, null, FusedScore.MEAN);
    }
  }

  /**
   * What boxes became.
   *
   * @param boxes the mean of each cluster
   * @param numbers those of boxes, a double[] or float[]
   * @param scores of each cluster
   * @param clusters of each box that was given; -1 if the box, its score or its weight is invalid
   */
  public record Fused(Shapes boxes, Object numbers, double[] scores, long[] clusters) {}

  /**
   * Weighted boxes fusion: boxes of one object, of kind AABB or RECT, become their mean by score times weight. If a
   * box, its score or its weight is invalid, the exception has the result of all others.
   *
   * @param scores a double[], float[] or direct buffer, as the boxes' numbers
   */
  public static Fused fuse(Shapes boxes, Object scores, Fusion how) {
    int count = Vesica.length(Vesica.scores(boxes, scores));
    if (how.weights != null) Vesica.scores(boxes, how.weights);
    if (how.labels != null && how.labels.length != count) {
      throw new IllegalArgumentException(count + " shapes need as many labels, not " + how.labels.length);
    }
    if (boxes.kind != Kind.AABB.value && boxes.kind != Kind.RECT.value) checked(ErrorCode.KIND.value);
    int fields = boxes.kind == Kind.AABB.value ? 4 : 6;
    long[] scratch = scratch(Native.fuseScratch(count)), clusters = new long[count], found = new long[1];
    Object numbers = numbers(boxes.wide, Vesica.length((long) fields * count)), means = numbers(boxes.wide, count);
    int code = Native.fuse(boxes.wide, boxes, scores, how.weights, how.labels, how.threshold, how.score.value, scratch,
        size(scratch), numbers, means, clusters, found);
    Object own = first(numbers, fields * (int) found[0]);
    Shapes fused = Shapes.of(boxes.kind == Kind.AABB.value ? Kind.AABB : Kind.RECT, own);
    double[] fusedScores = Index.doubles(first(means, (int) found[0]));
    return VesicaException.finished(code, new Fused(fused, own, fusedScores, clusters));
  }

  private static Object numbers(boolean wide, int count) {
    return wide ? new double[count] : new float[count];
  }

  private static Object first(Object numbers, int count) {
    if (numbers instanceof double[] doubles) return Arrays.copyOf(doubles, count);
    return Arrays.copyOf((float[]) numbers, count);
  }

  /** Rows, one for each threshold, of the {@link Outcome} of each detection, and of the truth it took, or -1. */
  public record Matches(byte[] outcomes, long[] taken) {
    /** The outcome of a detection in the row of a threshold. */
    public Outcome outcome(int i) {
      return Outcome.of(outcomes[i]);
    }
  }

  /**
   * Which detections hit a truth, at each of some thresholds? In a pair, a is a detection and b a truth.
   *
   * @param scores one for each detection
   * @param truths one for each truth
   */
  public static Matches matchTruths(
      MatchRule rule, Pairs pairs, double[] scores, Truth[] truths, double... thresholds) {
    byte[] flags = new byte[truths.length];
    for (int i = 0; i < flags.length; i++) flags[i] = (byte) truths[i].value;
    int count = pairs.values.length, results = Vesica.length((long) scores.length * thresholds.length);
    long[] scratch = scratch(Native.matchTruthsScratch(count, scores.length, flags.length));
    Matches out = new Matches(new byte[results], new long[results]);
    checked(Native.matchTruthsF64(rule.value, pairs.a, pairs.b, pairs.values, count, scores, scores.length, flags,
        flags.length, thresholds, thresholds.length, scratch, size(scratch), out.outcomes, out.taken));
    return out;
  }

  /**
   * The average precision of detections of one class, or NaN without truths.
   *
   * @param outcomes one for each score, as in {@link Matches}
   * @param truths how many of them count
   */
  public static double averagePrecision(PrecisionRule rule, double[] scores, byte[] outcomes, long truths) {
    if (scores.length != outcomes.length) {
      throw new IllegalArgumentException(scores.length + " scores need as many outcomes, not " + outcomes.length);
    }
    long[] scratch = scratch(Native.averagePrecisionScratch(scores.length));
    double[] out = new double[1];
    checked(Native.averagePrecisionF64(
        rule.value, scores, outcomes, scores.length, truths, scratch, size(scratch), out));
    return out[0];
  }
}
