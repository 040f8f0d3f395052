// SPDX-License-Identifier: Apache-2.0
using System;
using static System.Runtime.InteropServices.MemoryMarshal;

namespace Vesica
{
    /// <summary>How Measures.Suppress chooses. Made by its constructor, it is by intersection over union alone. With
    /// float shapes threshold and least score are rounded to float first.</summary>
    public sealed class Suppression
    {
        /// <summary>Each shape kept has at most this ratio with every better one that was kept.</summary>
        public double Threshold;

        /// <summary>Any but OverFirst and OverSecond.</summary>
        public Ratio Ratio = Ratio.OverUnion;

        /// <summary>One for each shape: only those of the same suppress one another. Null, if all are alike.</summary>
        public int[] Labels;

        /// <summary>Shapes below it are not looked at.</summary>
        public double LeastScore = double.NegativeInfinity;

        /// <summary>How many are kept at most.</summary>
        public long Most = long.MaxValue;

        /// <summary>By a threshold.</summary>
        public Suppression(double threshold)
        {
            Threshold = threshold;
        }
    }

    /// <summary>Ratios of shared area, by which detections are compared, and suppression by them.</summary>
    public static unsafe class Measures
    {
        /// <summary>A ratio of two shapes. An exception, if the shape whose area divides has none, or neither has.
        /// </summary>
        public static double Ratio<A, B>(Ratio ratio, A a, B b) where A : IShape where B : IShape
        {
            double n;
            var which = (int)ratio;
            Query.Measures call = (wide, kindA, p, kindB, q, output) =>
                Native.Ratio(wide, which, kindA, p, kindB, q, output);
            return Query.At(Query.Measure(call, a, b, &n), &n, 0);
        }

        /// <summary>A ratio of a[i] and b[i]. Where there is none the result is NaN, all others are written, and there
        /// is an exception. Returns how many are above 0.</summary>
        public static long RatioMany(Ratio ratio, Shapes a, Shapes b, Span<double> output)
        {
            return Query.Many((wide, p, q, to) => Native.RatioMany(wide, (int)ratio, p, q, to), a, b,
                AsBytes(output), true);
        }

        /// <summary>The same in float.</summary>
        public static long RatioMany(Ratio ratio, Shapes a, Shapes b, Span<float> output)
        {
            return Query.Many((wide, p, q, to) => Native.RatioMany(wide, (int)ratio, p, q, to), a, b,
                AsBytes(output), false);
        }

        /// <summary>A ratio of each of a with each of b: element i * b.Count + j.</summary>
        public static long RatioMatrix(Ratio ratio, Shapes a, Shapes b, Span<double> output)
        {
            return RatioMatrix(ratio, a, b, AsBytes(output), true);
        }

        /// <summary>The same in float.</summary>
        public static long RatioMatrix(Ratio ratio, Shapes a, Shapes b, Span<float> output)
        {
            return RatioMatrix(ratio, a, b, AsBytes(output), false);
        }

        private static long RatioMatrix(Ratio ratio, Shapes a, Shapes b, Span<byte> output, bool isDouble)
        {
            Query.Matrices call = (wide, p, q, to, row) => Native.RatioMatrix(wide, (int)ratio, p, q, to, row);
            return Query.Matrix(call, a, b, output, isDouble);
        }

        /// <summary>Greedy suppression: the indices of the shapes kept, best score first.</summary>
        public static long[] Suppress(Shapes shapes, ReadOnlySpan<double> scores, Suppression how)
        {
            fixed (double* p = &scores.GetPinnableReference()) return Suppress(shapes, p, scores.Length, true, how);
        }

        /// <summary>The same in float.</summary>
        public static long[] Suppress(Shapes shapes, ReadOnlySpan<float> scores, Suppression how)
        {
            fixed (float* p = &scores.GetPinnableReference()) return Suppress(shapes, p, scores.Length, false, how);
        }

        private static long[] Suppress(Shapes shapes, void* scores, long given, bool wide, Suppression how)
        {
            if (shapes == null) throw new ArgumentNullException("shapes");
            if (how == null) throw new ArgumentNullException("how");
            Query.Alike(shapes.IsDouble, wide);
            if (given != shapes.Count || (how.Labels != null && how.Labels.Length != given))
                throw new ArgumentException(shapes.Count + " shapes need as many scores, and labels or none");
            var scratch = new byte[Native.Checked(Native.vesica_nms_scratch(given))];
            var keep = new long[given];
            long kept = 0, most = Math.Min(how.Most, given);
            int code;
            using (var pinned = new Pinned(shapes))
                fixed (View* view = pinned.Views)
                fixed (int* labels = how.Labels)
                fixed (byte* room = scratch)
                fixed (long* to = keep)
                    code = Native.Suppress(wide, view, scores, labels, (int)how.Ratio, how.Threshold, how.LeastScore,
                        most,
                        room, scratch.Length, to, &kept);
            Array.Resize(ref keep, (int)kept);
            if (code < 0) throw new VesicaException(code, code == (int)ErrorCode.Shape ? keep : null);
            return keep;
        }
    }

    /// <summary>
    /// Arrays of boxes as detectors write them, five numbers each: centre x, centre y, width along the angle, height
    /// across it, angle. Multiples of 90 degrees turn exactly, and Angle.Degrees | Angle.Reversed turns the other way.
    /// An invalid box or shape gives NaN throughout, all others are written, and there is an exception.
    /// </summary>
    public static unsafe class Boxes
    {
        private delegate long Maker(bool wide, void* boxes, long count, IntPtr stride, int angle, void* output);

        private static readonly Maker rects = Native.RectsFromBoxes, ellipses = Native.EllipsesFromBoxes;

        /// <summary>Rectangles from rows of so many numbers, of which the first five are a box.</summary>
        public static Rect[] Rects(ReadOnlySpan<double> boxes, Angle angle, int record = 5)
        {
            var made = new Rect[CountOf(boxes.Length, record)];
            fixed (double* from = &boxes.GetPinnableReference())
            fixed (Rect* to = made) Make(rects, true, from, made.Length, record, angle, to, made);
            return made;
        }

        /// <summary>The same in float.</summary>
        public static RectF[] Rects(ReadOnlySpan<float> boxes, Angle angle, int record = 5)
        {
            var made = new RectF[CountOf(boxes.Length, record)];
            fixed (float* from = &boxes.GetPinnableReference())
            fixed (RectF* to = made) Make(rects, false, from, made.Length, record, angle, to, made);
            return made;
        }

        /// <summary>Ellipses from the boxes about them, whose sides they touch in the middle.</summary>
        public static Ellipse[] Ellipses(ReadOnlySpan<double> boxes, Angle angle, int record = 5)
        {
            var made = new Ellipse[CountOf(boxes.Length, record)];
            fixed (double* from = &boxes.GetPinnableReference())
            fixed (Ellipse* to = made) Make(ellipses, true, from, made.Length, record, angle, to, made);
            return made;
        }

        /// <summary>The same in float.</summary>
        public static EllipseF[] Ellipses(ReadOnlySpan<float> boxes, Angle angle, int record = 5)
        {
            var made = new EllipseF[CountOf(boxes.Length, record)];
            fixed (float* from = &boxes.GetPinnableReference())
            fixed (EllipseF* to = made) Make(ellipses, false, from, made.Length, record, angle, to, made);
            return made;
        }

        private static int CountOf(int length, int record)
        {
            if (record >= 5 && length % record == 0) return length / record;
            throw new ArgumentException(length + " numbers are no rows of " + record + ", of which 5 are a box's");
        }

        private static void Make(Maker maker, bool wide, void* boxes, int count, int record, Angle angle, void* output,
            object made)
        {
            var stride = (IntPtr)((long)record * (wide ? sizeof(double) : sizeof(float)));
            long code = maker(wide, boxes, count, stride, (int)angle, output);
            bool isWritten = code == (long)ErrorCode.Shape || code == (long)ErrorCode.Range;
            if (code < 0) throw new VesicaException((int)code, isWritten ? made : null);
        }

        private static long Rows(Query.Bytes function, Shapes shapes, int width, Span<byte> output, bool wide)
        {
            Query.Numbers(shapes, wide);
            int size = wide ? sizeof(double) : sizeof(float);
            fixed (byte* p = &output.GetPinnableReference())
            {
                Query.Room(shapes, shapes, p, output.Length / size, width * shapes.Count, size);
                return Query.Ask(function, shapes, shapes, p);
            }
        }

        /// <summary>The way back: five numbers of each rectangle, or of the box about each ellipse.</summary>
        public static void Of(Shapes shapes, Angle angle, Span<double> output)
        {
            Rows((wide, p, q, to) => Native.BoxesFromShapes(wide, p, (int)angle, to), shapes, 5, AsBytes(output), true);
        }

        /// <summary>The same in float.</summary>
        public static void Of(Shapes shapes, Angle angle, Span<float> output)
        {
            Rows((wide, p, q, to) => Native.BoxesFromShapes(wide, p, (int)angle, to), shapes, 5, AsBytes(output),
                false);
        }

        /// <summary>The corners x0 y0 ... x3 y3 of each rectangle, or of the box about each ellipse.</summary>
        public static void Corners(Shapes shapes, Span<double> output)
        {
            Rows((wide, p, q, to) => Native.CornersOfShapes(wide, p, to), shapes, 8, AsBytes(output), true);
        }

        /// <summary>The same in float.</summary>
        public static void Corners(Shapes shapes, Span<float> output)
        {
            Rows((wide, p, q, to) => Native.CornersOfShapes(wide, p, to), shapes, 8, AsBytes(output), false);
        }

        /// <summary>The smallest boxes along the axes of representable numbers that contain shapes.</summary>
        public static void Bounds(Shapes shapes, Span<Aabb> output)
        {
            Rows((wide, p, q, to) => Native.BoundsMany(wide, p, to), shapes, 4, AsBytes(output), true);
        }

        /// <summary>The same in float.</summary>
        public static void Bounds(Shapes shapes, Span<AabbF> output)
        {
            Rows((wide, p, q, to) => Native.BoundsMany(wide, p, to), shapes, 4, AsBytes(output), false);
        }
    }
}
