// SPDX-License-Identifier: Apache-2.0
using System;
using System.Text;
using static System.Runtime.InteropServices.MemoryMarshal;

namespace Vesica
{
    /// <summary>How the parts of two shapes meet: nine-intersection matrices, and the region that they share.</summary>
    public static unsafe class Topology
    {
        private const int Characters = 9;
        private static readonly Query.Measures de9im = Native.De9im;

        /// <summary>The nine-intersection matrix, as geographic systems have it, such as "FF2F11212". Exact.</summary>
        public static string De9im<A, B>(A a, B b) where A : IShape where B : IShape
        {
            byte* letters = stackalloc byte[Characters + 1];
            Query.Measure(de9im, a, b, letters);
            return Encoding.ASCII.GetString(letters, Characters);
        }

        /// <summary>Does such a matrix fit a pattern of F, 0, 1, 2, T (any of 0, 1 and 2) and * (anything)?</summary>
        public static bool Matches(string matrix, string pattern)
        {
            fixed (byte* m = Text(matrix), p = Text(pattern))
                return Native.Checked(Native.vesica_de9im_match(m, p)) == 1;
        }

        /// <summary>Characters and a final 0; what has a 0 inside is passed on as no characters, which are no
        /// matrix.</summary>
        private static byte[] Text(string characters)
        {
            if (characters == null) throw new ArgumentNullException("matrix or pattern");
            return Encoding.ASCII.GetBytes((characters.IndexOf('\0') < 0 ? characters : "") + "\0");
        }

        /// <summary>The vertices of the region that two shapes share, counter-clockwise; none if they do not overlap.
        /// It is of points, segments, boxes, rectangles and convex polygons, or of a point or a segment and any shape. Of
        /// a segment and a polygon or a polyline it has two vertices for each piece, in order along the
        /// segment.</summary>
        public static Point[] Intersection<A, B>(A a, B b) where A : IShape where B : IShape
        {
            return Query.PointsOf(a, b, Native.Intersection);
        }
    }

    /// <summary>Distances that are asked about, and distances with a sign.</summary>
    public static unsafe class Distances
    {
        private static readonly Query.Measures signed = Native.SignedDistance;
        private static readonly Query.Bytes signedMany = Native.SignedDistanceMany;
        private static readonly Query.Matrices signedMatrix = Native.SignedDistanceMatrix;

        /// <summary>The distance of two shapes or, below 0, how deep they overlap.</summary>
        public static double Signed<A, B>(A a, B b) where A : IShape where B : IShape
        {
            double n;
            return Query.At(Query.Measure(signed, a, b, &n), &n, 0);
        }

        /// <summary>The signed distance of a[i] and b[i]. Returns how many overlap.</summary>
        public static long SignedMany(Shapes a, Shapes b, Span<double> output)
        {
            return Query.Many(signedMany, a, b, AsBytes(output), true);
        }

        /// <summary>The same in float.</summary>
        public static long SignedMany(Shapes a, Shapes b, Span<float> output)
        {
            return Query.Many(signedMany, a, b, AsBytes(output), false);
        }

        /// <summary>The signed distance of each of a and each of b: element i * b.Count + j.</summary>
        public static long SignedMatrix(Shapes a, Shapes b, Span<double> output)
        {
            return Query.Matrix(signedMatrix, a, b, AsBytes(output), true);
        }

        /// <summary>The same in float.</summary>
        public static long SignedMatrix(Shapes a, Shapes b, Span<float> output)
        {
            return Query.Matrix(signedMatrix, a, b, AsBytes(output), false);
        }

        /// <summary>Are two shapes at most so far apart? Exactly so far counts, and exact, but for ellipses. If it
        /// is negative: do they overlap at least that deep? With float shapes the distance is rounded to float first: 0.1
        /// is then 0.1f.</summary>
        public static Within Within<A, B>(A a, B b, double distance) where A : IShape where B : IShape
        {
            int found = 0;
            Query.Measures call = (wide, kindA, p, kindB, q, to) =>
                found = Native.Within(wide, kindA, p, kindB, q, distance);
            Query.Measure(call, a, b, null);
            return (Within)found;
        }

        /// <summary>Are a[i] and b[i] at most so far apart? Returns how many are, or nearly. With float shapes the
        /// distance is rounded to float first.</summary>
        public static long WithinMany(Shapes a, Shapes b, double distance, Span<Within> output)
        {
            fixed (Within* p = &output.GetPinnableReference())
                return Query.Many((wide, x, y, to) => Native.WithinMany(wide, x, y, distance, to), a, b, p,
                    output.Length, 1);
        }

        /// <summary>Is each of a at most so far from each of b? Element i * b.Count + j is of a[i] and b[j]. With float
        /// shapes the distance is rounded to float first.</summary>
        public static long WithinMatrix(Shapes a, Shapes b, double distance, Span<Within> output)
        {
            Query.Matrices call = (wide, x, y, to, row) => Native.WithinMatrix(wide, x, y, distance, to, row);
            fixed (Within* p = &output.GetPinnableReference()) return Query.Matrix(call, a, b, p, output.Length, 1);
        }
    }

    /// <summary>How Soft.Suppress chooses. Made by its constructor, it is by intersection over union alone. With float
    /// shapes parameter and least score are rounded to float first.</summary>
    public sealed class SoftSuppression
    {
        /// <summary>Linear: what has a ratio r above the parameter keeps 1 - r; Gaussian: exp(-r^2 /
        /// parameter).</summary>
        public Decay Decay;

        /// <summary>A threshold from 0 to 1, or what r^2 is divided by.</summary>
        public double Parameter;

        /// <summary>Any but OverFirst and OverSecond.</summary>
        public Ratio Ratio = Ratio.OverUnion;

        /// <summary>One for each shape: only those of the same lower one another. Null, if all are alike.</summary>
        public int[] Labels;

        /// <summary>It ends when no score is left that is at least this, from 0.</summary>
        public double LeastScore;

        /// <summary>How many are kept at most.</summary>
        public long Most = long.MaxValue;

        /// <summary>By a decay.</summary>
        public SoftSuppression(Decay decay, double parameter)
        {
            Decay = decay;
            Parameter = parameter;
        }
    }

    /// <summary>A shape that soft suppression keeps.</summary>
    public struct Kept
    {
        /// <summary>Its number.</summary>
        public long Item;

        /// <summary>What was left of its score when it was taken.</summary>
        public double Score;
    }

    /// <summary>Soft suppression: each shape that is taken lowers the scores of those that it has a ratio
    /// with.</summary>
    public static unsafe class Soft
    {
        /// <summary>The shapes as they are taken, best score first.</summary>
        public static Kept[] Suppress(Shapes shapes, ReadOnlySpan<double> scores, SoftSuppression how)
        {
            fixed (double* p = &scores.GetPinnableReference()) return Suppress(shapes, p, scores.Length, true, how);
        }

        /// <summary>The same in float.</summary>
        public static Kept[] Suppress(Shapes shapes, ReadOnlySpan<float> scores, SoftSuppression how)
        {
            fixed (float* p = &scores.GetPinnableReference()) return Suppress(shapes, p, scores.Length, false, how);
        }

        private static Kept[] Suppress(Shapes shapes, void* scores, long given, bool wide, SoftSuppression how)
        {
            if (shapes == null) throw new ArgumentNullException("shapes");
            if (how == null) throw new ArgumentNullException("how");
            Query.Alike(shapes.IsDouble, wide);
            if (given != shapes.Count || (how.Labels != null && how.Labels.Length != given))
                throw new ArgumentException(shapes.Count + " shapes need as many scores, and labels or none");
            var scratch = new long[Native.Checked(Native.vesica_suppress_soft_scratch(given)) / sizeof(long)];
            var keep = new long[given];
            var left = new double[given];
            long kept = 0, most = Math.Min(how.Most, given), size = scratch.Length * sizeof(long);
            int code;
            using (var pinned = new Pinned(shapes))
                fixed (View* view = pinned.Views)
                fixed (int* labels = how.Labels)
                fixed (long* room = scratch, to = keep)
                fixed (double* scoresTo = left)
                {
                    code = Native.SuppressSoft(wide, view, scores, labels, (int)how.Ratio, (int)how.Decay,
                        how.Parameter,
                        how.LeastScore, most, room, size, to, scoresTo, &kept);
                    var found = new Kept[kept];
                    for (int i = 0; i < found.Length; ++i)
                        found[i] = new Kept { Item = to[i], Score = Query.At(wide, scoresTo, i) };
                    if (code < 0) throw new VesicaException(code, code == (int)ErrorCode.Shape ? found : null);
                    return found;
                }
        }
    }
}
