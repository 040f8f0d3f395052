// SPDX-License-Identifier: Apache-2.0
using System;
using System.Linq;

namespace Vesica
{
    /// <summary>An item of one index and an item of another, with a ratio of them.</summary>
    public struct RatioPair
    {
        /// <summary>The item of the first index.</summary>
        public long A;

        /// <summary>The item of the second index.</summary>
        public long B;

        /// <summary>Their ratio.</summary>
        public double Value;
    }

    /// <summary>How Detection.Fuse works. With float boxes its numbers are rounded to float first.</summary>
    public sealed class Fusion
    {
        /// <summary>A box joins the cluster whose mean it has the highest IoU with, if that exceeds this.</summary>
        public double Threshold = 0.55;

        /// <summary>One for each box, such as that of its model; null, if all are 1.</summary>
        public double[] Weights;

        /// <summary>One for each box, only those of the same are fused; null, if all are alike.</summary>
        public int[] Labels;

        /// <summary>The score of a cluster.</summary>
        public FusedScore Score = FusedScore.Mean;
    }

    /// <summary>What boxes became.</summary>
    public sealed class Fused
    {
        /// <summary>The mean of each cluster: four or six numbers, as the boxes have them.</summary>
        public double[] Numbers;

        /// <summary>The score of each cluster.</summary>
        public double[] Scores;

        /// <summary>The cluster of each box that was given; -1 if the box, its score or its weight is
        /// invalid.</summary>
        public long[] Clusters;
    }

    /// <summary>What is done around detectors: assignment, fusion of boxes, average precision.</summary>
    public static unsafe class Detection
    {
        // Of 8 bytes each, as the library wants it aligned.
        private static long[] Scratch(long bytes)
        {
            return new long[(Native.Checked(bytes) + 7) / 8];
        }

        private static long End(long[] items)
        {
            return items.Length == 0 ? 0 : items.Max() + 1;
        }

        /// <summary>Greedy assignment, as of tracks to detections: takes the pair with the highest value whose two items
        /// are both free, until there is none. Which of the pairs, the best first; of equal values the one with the
        /// lower A, then B.</summary>
        public static long[] AssignGreedy(RatioPair[] pairs)
        {
            if (pairs == null) throw new ArgumentNullException("pairs");
            long[] a = pairs.Select(pair => pair.A).ToArray(), b = pairs.Select(pair => pair.B).ToArray();
            double[] values = pairs.Select(pair => pair.Value).ToArray();
            long countA = End(a), countB = End(b);
            long[] scratch = Scratch(Native.vesica_assign_greedy_scratch(pairs.Length, countA, countB));
            var chosen = new long[pairs.Length];
            long taken;
            fixed (long* p = a, q = b, room = scratch, to = chosen)
            fixed (double* v = values)
                taken = Native.Checked(Native.vesica_assign_greedy_f64(
                    p, q, v, pairs.Length, countA, countB, room, 8L * scratch.Length, to));
            Array.Resize(ref chosen, (int)taken);
            return chosen;
        }

        /// <summary>Weighted boxes fusion: boxes of one object, of kind Aabb or Rect, become their mean by score times
        /// weight. Where a box, its score or its weight is invalid, the exception has the result of all
        /// others.</summary>
        public static Fused Fuse(Shapes boxes, double[] scores, Fusion how = null)
        {
            if (boxes == null) throw new ArgumentNullException("boxes");
            if (scores == null) throw new ArgumentNullException("scores");
            how = how ?? new Fusion();
            long n = boxes.Count;
            if (scores.Length != n || (how.Weights != null && how.Weights.Length != n)
                || (how.Labels != null && how.Labels.Length != n))
                throw new ArgumentException(n + " boxes need as many scores, and weights and labels or none");
            if (boxes.Kind != Kind.Aabb && boxes.Kind != Kind.Rect) Native.Checked((long)ErrorCode.Kind);
            return boxes.IsDouble ? Fuse(boxes, scores, how.Weights, how) : FuseFloats(boxes, scores, how);
        }

        private static Fused Fuse(Shapes boxes, double[] scores, double[] weights, Fusion how)
        {
            double[] numbers = new double[boxes.Count * Shapes.Fields(boxes.Kind)], means = new double[boxes.Count];
            fixed (double* s = scores, w = weights, to = numbers, mean = means)
                return Fuse(boxes, s, w, how, to, mean, found => numbers.Take(found), found => means.Take(found));
        }

        private static Fused FuseFloats(Shapes boxes, double[] scores, Fusion how)
        {
            float[] narrow = scores.Select(score => (float)score).ToArray();
            float[] weights = how.Weights == null ? null : how.Weights.Select(weight => (float)weight).ToArray();
            float[] numbers = new float[boxes.Count * Shapes.Fields(boxes.Kind)], means = new float[boxes.Count];
            fixed (float* s = narrow, w = weights, to = numbers, mean = means)
                return Fuse(boxes, s, w, how, to, mean, found => numbers.Take(found).Select(x => (double)x),
                    found => means.Take(found).Select(x => (double)x));
        }

        private static Fused Fuse(Shapes boxes, void* scores, void* weights, Fusion how, void* numbers, void* means,
            Func<int, System.Collections.Generic.IEnumerable<double>> numbersOf,
            Func<int, System.Collections.Generic.IEnumerable<double>> meansOf)
        {
            long[] scratch = Scratch(Native.vesica_fuse_scratch(boxes.Count)), clusters = new long[boxes.Count];
            long found = 0;
            int code;
            using (var pinned = new Pinned(boxes))
                fixed (View* view = pinned.Views)
                fixed (int* labels = how.Labels)
                fixed (long* room = scratch, cluster = clusters)
                    code = Native.Fuse(boxes.IsDouble, view, scores, weights, labels, how.Threshold, (int)how.Score,
                        room, 8L * scratch.Length, numbers, means, cluster, &found);
            if (code < 0 && code != (int)ErrorCode.Shape) Native.Checked(code);
            var result = new Fused
            {
                Numbers = numbersOf((int)found * Shapes.Fields(boxes.Kind)).ToArray(),
                Scores = meansOf((int)found).ToArray(),
                Clusters = clusters,
            };
            if (code < 0) throw new VesicaException(code, result);
            return result;
        }

        /// <summary>Which detections hit a truth, at each of some thresholds? Rows, one for each threshold, of the
        /// outcome of each detection, and of the truth it took, or -1. In a pair, A is a detection and B a truth; there
        /// is a score for each detection.</summary>
        public static Outcome[] MatchTruths(MatchRule rule, RatioPair[] pairs, double[] scores, Truth[] truths,
            double[] thresholds, out long[] taken)
        {
            if (pairs == null) throw new ArgumentNullException("pairs");
            if (scores == null) throw new ArgumentNullException("scores");
            if (truths == null) throw new ArgumentNullException("truths");
            if (thresholds == null) throw new ArgumentNullException("thresholds");
            long[] a = pairs.Select(pair => pair.A).ToArray(), b = pairs.Select(pair => pair.B).ToArray();
            double[] values = pairs.Select(pair => pair.Value).ToArray();
            byte[] flags = truths.Select(truth => (byte)truth).ToArray();
            long[] scratch = Scratch(Native.vesica_match_truths_scratch(pairs.Length, scores.Length, flags.Length));
            var outcomes = new byte[(long)scores.Length * thresholds.Length];
            var took = new long[outcomes.Length];
            fixed (long* p = a, q = b, room = scratch, to = took)
            fixed (double* v = values, s = scores, rows = thresholds)
            fixed (byte* marks = flags, codes = outcomes)
                Native.Checked(Native.vesica_match_truths_f64((int)rule, p, q, v, pairs.Length, s, scores.Length, marks,
                    flags.Length, rows, thresholds.Length, room, 8L * scratch.Length, codes, to));
            taken = took;
            return outcomes.Select(outcome => (Outcome)outcome).ToArray();
        }

        /// <summary>The average precision of detections of one class, or NaN without truths; truths is how many of them
        /// count.</summary>
        public static double AveragePrecision(PrecisionRule rule, double[] scores, Outcome[] outcomes, long truths)
        {
            if (scores == null) throw new ArgumentNullException("scores");
            if (outcomes == null) throw new ArgumentNullException("outcomes");
            if (scores.Length != outcomes.Length)
                throw new ArgumentException(scores.Length + " scores need as many outcomes, not " + outcomes.Length);
            byte[] codes = outcomes.Select(outcome => (byte)outcome).ToArray();
            long[] scratch = Scratch(Native.vesica_average_precision_scratch(scores.Length));
            double result;
            fixed (double* s = scores)
            fixed (byte* o = codes)
            fixed (long* room = scratch)
                Native.Checked(Native.vesica_average_precision_f64(
                    (int)rule, s, o, scores.Length, truths, room, 8L * scratch.Length, &result));
            return result;
        }
    }
}
