// SPDX-License-Identifier: Apache-2.0
using System;
using System.Runtime.InteropServices;
using static System.Runtime.InteropServices.MemoryMarshal;

namespace Vesica
{
    // Arrays in step, or one of a single shape, which is repeated; every pair; choices among many. Results go to spans
    // of the caller's.
    public static unsafe partial class Query
    {
        internal delegate long Bytes(bool wide, void* a, void* b, void* output);

        internal delegate long Matrices(bool wide, void* a, void* b, void* output, IntPtr row);

        internal delegate long Closests(
            bool wide, void* a, void* b, void* distance, void* ax, void* ay, void* bx, void* by);

        private delegate long Selection(bool wide, void* one, void* many, void* output, long capacity);

        private static readonly Selection overlapSelect = Native.OverlapSelect;
        private static readonly Selection interiorsOverlapSelect = Native.InteriorsOverlapSelect;
        private static readonly Bytes overlapMany = Native.OverlapMany, relationMany = Native.RelationMany;
        private static readonly Bytes interiorsOverlapMany = Native.InteriorsOverlapMany;
        private static readonly Bytes containsMany = Native.ContainsMany, areaMany = Native.AreaMany;
        private static readonly Bytes iouMany = Native.IouMany;
        private static readonly Matrices overlapMatrix = Native.OverlapMatrix, relationMatrix = Native.RelationMatrix;
        private static readonly Matrices interiorsOverlapMatrix = Native.InteriorsOverlapMatrix;
        private static readonly Matrices containsMatrix = Native.ContainsMatrix, areaMatrix = Native.AreaMatrix;
        private static readonly Matrices iouMatrix = Native.IouMatrix, nearestMatrix = Native.NearestMatrix;
        private static readonly Matrices boundaryDistanceMatrix = Native.BoundaryDistanceMatrix;
        private static readonly Matrices depthMatrix = Native.DepthMatrix;
        private static readonly Closests nearestMany = Native.NearestMany;
        private static readonly Closests boundaryDistanceMany = Native.BoundaryDistanceMany;

        internal static long InStep(Shapes a, Shapes b)
        {
            Both(a, b);
            if (a.Count == b.Count || b.Count == 1) return a.Count;
            if (a.Count == 1) return b.Count;
            throw new ArgumentException(
                "a has " + a.Count + " shapes and b " + b.Count + ": as many are needed, or one of either");
        }

        private static long Pairs(Shapes a, Shapes b)
        {
            Both(a, b);
            return checked(a.Count * b.Count);
        }

        private static void Both(Shapes a, Shapes b)
        {
            if (a == null) throw new ArgumentNullException("a");
            if (b == null) throw new ArgumentNullException("b");
            Alike(a.IsDouble, b.IsDouble);
        }

        internal static void Room(Shapes a, Shapes b, void* output, long given, long needed, int size)
        {
            if (given < needed)
                throw new ArgumentException("output has " + given + " elements, where " + needed + " are needed");
            if (a.Meets(output, needed * size) || b.Meets(output, needed * size))
                throw new ArgumentException("output overlaps an input: results need memory of their own");
        }

        internal static long Many(Bytes function, Shapes a, Shapes b, void* output, long given, int size)
        {
            Room(a, b, output, given, InStep(a, b), size);
            return Ask(function, a, b, output);
        }

        internal static long Ask(Bytes function, Shapes a, Shapes b, void* output)
        {
            View viewA, viewB;
            GCHandle pinA = a.Pin(out viewA), pinB = default(GCHandle);
            try
            {
                pinB = b.Pin(out viewB);
                return Native.Checked(function(a.IsDouble, &viewA, &viewB, output));
            }
            finally
            {
                if (pinA.IsAllocated) pinA.Free();
                if (pinB.IsAllocated) pinB.Free();
            }
        }

        internal static long Matrix(Matrices function, Shapes a, Shapes b, void* output, long given, int size)
        {
            Room(a, b, output, given, Pairs(a, b), size);
            return Ask((wide, x, y, z) => function(wide, x, y, z, (IntPtr)b.Count), a, b, output);
        }

        /// <summary>Do a[i] and b[i] share a point? Returns how many do.</summary>
        public static long OverlapMany(Shapes a, Shapes b, Span<bool> output)
        {
            fixed (bool* p = &output.GetPinnableReference()) return Many(overlapMany, a, b, p, output.Length, 1);
        }

        /// <summary>Do the insides of a[i] and b[i] share a point? Returns how many do.</summary>
        public static long InteriorsOverlapMany(Shapes a, Shapes b, Span<bool> output)
        {
            fixed (bool* p = &output.GetPinnableReference())
                return Many(interiorsOverlapMany, a, b, p, output.Length, 1);
        }

        /// <summary>How does a[i] relate to b[i]? Returns how many are not disjoint.</summary>
        public static long RelationMany(Shapes a, Shapes b, Span<Relation> output)
        {
            fixed (Relation* p = &output.GetPinnableReference()) return Many(relationMany, a, b, p, output.Length, 1);
        }

        /// <summary>Does a[i] hold all of b[i]? Returns how many do.</summary>
        public static long ContainsMany(Shapes a, Shapes b, Span<bool> output)
        {
            fixed (bool* p = &output.GetPinnableReference()) return Many(containsMany, a, b, p, output.Length, 1);
        }

        /// <summary>Does each of a overlap each of b? Element i * b.Count + j is of a[i] and b[j].</summary>
        public static long OverlapMatrix(Shapes a, Shapes b, Span<bool> output)
        {
            fixed (bool* p = &output.GetPinnableReference()) return Matrix(overlapMatrix, a, b, p, output.Length, 1);
        }

        /// <summary>Do the insides of each of a and each of b share a point?</summary>
        public static long InteriorsOverlapMatrix(Shapes a, Shapes b, Span<bool> output)
        {
            fixed (bool* p = &output.GetPinnableReference())
                return Matrix(interiorsOverlapMatrix, a, b, p, output.Length, 1);
        }

        /// <summary>How does each of a relate to each of b?</summary>
        public static long RelationMatrix(Shapes a, Shapes b, Span<Relation> output)
        {
            fixed (Relation* p = &output.GetPinnableReference())
                return Matrix(relationMatrix, a, b, p, output.Length, 1);
        }

        /// <summary>Does each of a hold all of each of b?</summary>
        public static long ContainsMatrix(Shapes a, Shapes b, Span<bool> output)
        {
            fixed (bool* p = &output.GetPinnableReference()) return Matrix(containsMatrix, a, b, p, output.Length, 1);
        }

        // ---- Numbers, in double or float as the shapes have them ----

        /// <summary>The area that a[i] and b[i] share. Returns how many are above 0.</summary>
        public static long AreaMany(Shapes a, Shapes b, Span<double> output)
        {
            return Many(areaMany, a, b, AsBytes(output), true);
        }

        /// <summary>The same in float.</summary>
        public static long AreaMany(Shapes a, Shapes b, Span<float> output)
        {
            return Many(areaMany, a, b, AsBytes(output), false);
        }

        /// <summary>Intersection over union of a[i] and b[i]. Returns how many are above 0.</summary>
        public static long IouMany(Shapes a, Shapes b, Span<double> output)
        {
            return Many(iouMany, a, b, AsBytes(output), true);
        }

        /// <summary>The same in float.</summary>
        public static long IouMany(Shapes a, Shapes b, Span<float> output)
        {
            return Many(iouMany, a, b, AsBytes(output), false);
        }

        /// <summary>The area that each of a shares with each of b.</summary>
        public static long AreaMatrix(Shapes a, Shapes b, Span<double> output)
        {
            return Matrix(areaMatrix, a, b, AsBytes(output), true);
        }

        /// <summary>The same in float.</summary>
        public static long AreaMatrix(Shapes a, Shapes b, Span<float> output)
        {
            return Matrix(areaMatrix, a, b, AsBytes(output), false);
        }

        /// <summary>Intersection over union of each of a with each of b.</summary>
        public static long IouMatrix(Shapes a, Shapes b, Span<double> output)
        {
            return Matrix(iouMatrix, a, b, AsBytes(output), true);
        }

        /// <summary>The same in float.</summary>
        public static long IouMatrix(Shapes a, Shapes b, Span<float> output)
        {
            return Matrix(iouMatrix, a, b, AsBytes(output), false);
        }

        /// <summary>The distance of each of a from each of b. Returns how many pairs overlap.</summary>
        public static long NearestMatrix(Shapes a, Shapes b, Span<double> output)
        {
            return Matrix(nearestMatrix, a, b, AsBytes(output), true);
        }

        /// <summary>The same in float.</summary>
        public static long NearestMatrix(Shapes a, Shapes b, Span<float> output)
        {
            return Matrix(nearestMatrix, a, b, AsBytes(output), false);
        }

        /// <summary>The distance of the outline of each of a from that of each of b. Returns how many meet.</summary>
        public static long BoundaryDistanceMatrix(Shapes a, Shapes b, Span<double> output)
        {
            return Matrix(boundaryDistanceMatrix, a, b, AsBytes(output), true);
        }

        /// <summary>The same in float.</summary>
        public static long BoundaryDistanceMatrix(Shapes a, Shapes b, Span<float> output)
        {
            return Matrix(boundaryDistanceMatrix, a, b, AsBytes(output), false);
        }

        /// <summary>How deep each of a and each of b overlap. Returns how many depths are above 0.</summary>
        public static long DepthMatrix(Shapes a, Shapes b, Span<double> output)
        {
            return Matrix(depthMatrix, a, b, AsBytes(output), true);
        }

        /// <summary>The same in float.</summary>
        public static long DepthMatrix(Shapes a, Shapes b, Span<float> output)
        {
            return Matrix(depthMatrix, a, b, AsBytes(output), false);
        }

        /// <summary>How far are a[i] and b[i] apart, and where? Empty spans are not written, but one must be. Returns
        /// how many overlap.</summary>
        public static long NearestMany(
            Shapes a, Shapes b, Span<double> distance, Span<double> ax, Span<double> ay, Span<double> bx,
                Span<double> by)
        {
            return Closest(nearestMany, a, b, true, AsBytes(distance), AsBytes(ax), AsBytes(ay), AsBytes(bx),
                AsBytes(by));
        }

        /// <summary>The same in float.</summary>
        public static long NearestMany(
            Shapes a, Shapes b, Span<float> distance, Span<float> ax, Span<float> ay, Span<float> bx, Span<float> by)
        {
            return Closest(nearestMany, a, b, false, AsBytes(distance), AsBytes(ax), AsBytes(ay), AsBytes(bx),
                AsBytes(by));
        }

        /// <summary>How far are the outlines of a[i] and b[i] apart? Spans as in NearestMany. Returns how many
        /// meet.</summary>
        public static long BoundaryDistanceMany(
            Shapes a, Shapes b, Span<double> distance, Span<double> ax, Span<double> ay, Span<double> bx,
                Span<double> by)
        {
            return Closest(boundaryDistanceMany, a, b, true, AsBytes(distance), AsBytes(ax), AsBytes(ay), AsBytes(bx),
                AsBytes(by));
        }

        /// <summary>The same in float.</summary>
        public static long BoundaryDistanceMany(
            Shapes a, Shapes b, Span<float> distance, Span<float> ax, Span<float> ay, Span<float> bx, Span<float> by)
        {
            return Closest(boundaryDistanceMany, a, b, false, AsBytes(distance), AsBytes(ax), AsBytes(ay), AsBytes(bx),
                AsBytes(by));
        }

        /// <summary>How deep do a[i] and b[i] overlap? Spans as in NearestMany. Returns how many depths are above
        /// 0.</summary>
        public static long DepthMany(Shapes a, Shapes b, Span<double> depth, Span<double> x, Span<double> y)
        {
            return Deep(a, b, true, AsBytes(depth), AsBytes(x), AsBytes(y));
        }

        /// <summary>The same in float.</summary>
        public static long DepthMany(Shapes a, Shapes b, Span<float> depth, Span<float> x, Span<float> y)
        {
            return Deep(a, b, false, AsBytes(depth), AsBytes(x), AsBytes(y));
        }

        /// <summary>Greedy suppression: the indices of the shapes kept, best score first. Each has an intersection over
        /// union of at most threshold with every better one that was kept.</summary>
        public static long[] Nms(Shapes shapes, ReadOnlySpan<double> scores, double threshold)
        {
            fixed (double* p = &scores.GetPinnableReference()) return Nms(shapes, p, scores.Length, true, threshold);
        }

        /// <summary>The same in float, to which the threshold is rounded first.</summary>
        public static long[] Nms(Shapes shapes, ReadOnlySpan<float> scores, double threshold)
        {
            fixed (float* p = &scores.GetPinnableReference()) return Nms(shapes, p, scores.Length, false, threshold);
        }

        private static int Size(bool wide)
        {
            return wide ? sizeof(double) : sizeof(float);
        }

        internal static long Many(Bytes function, Shapes a, Shapes b, Span<byte> output, bool wide)
        {
            Numbers(a, wide);
            fixed (byte* p = &output.GetPinnableReference())
                return Many(function, a, b, p, output.Length / Size(wide), Size(wide));
        }

        internal static long Matrix(Matrices function, Shapes a, Shapes b, Span<byte> output, bool wide)
        {
            Numbers(a, wide);
            fixed (byte* p = &output.GetPinnableReference())
                return Matrix(function, a, b, p, output.Length / Size(wide), Size(wide));
        }

        internal static long Closest(Closests function, Shapes a, Shapes b, bool wide, Span<byte> distance,
            Span<byte> ax,
            Span<byte> ay, Span<byte> bx, Span<byte> by)
        {
            Numbers(a, wide);
            fixed (byte* d = &distance.GetPinnableReference(), px = &ax.GetPinnableReference())
            fixed (byte* py = &ay.GetPinnableReference(), qx = &bx.GetPinnableReference())
            fixed (byte* qy = &by.GetPinnableReference())
            {
                Columns(a, b, wide, new Column(d, distance), new Column(px, ax), new Column(py, ay), new Column(qx, bx),
                    new Column(qy, by));
                void* v1 = px, v2 = py, v3 = qx, v4 = qy;
                return Ask((isDouble, x, y, z) => function(isDouble, x, y, z, v1, v2, v3, v4), a, b, d);
            }
        }

        private static long Deep(Shapes a, Shapes b, bool wide, Span<byte> depth, Span<byte> x, Span<byte> y)
        {
            Numbers(a, wide);
            fixed (byte* d = &depth.GetPinnableReference(), px = &x.GetPinnableReference())
            fixed (byte* py = &y.GetPinnableReference())
            {
                Columns(a, b, wide, new Column(d, depth), new Column(px, x), new Column(py, y));
                void* v1 = px, v2 = py;
                return Ask((isDouble, p, q, z) => Native.DepthMany(isDouble, p, q, z, v1, v2), a, b, d);
            }
        }

        internal static void Numbers(Shapes shapes, bool isDouble)
        {
            if (shapes == null) throw new ArgumentNullException("a");
            string numbers = shapes.IsDouble ? "double" : "float";
            if (shapes.IsDouble != isDouble)
                throw new ArgumentException("the shapes have " + numbers + " numbers: the output must have them too");
        }

        /// <summary>Memory for a column of results, which is not written if it is empty.</summary>
        private struct Column
        {
            internal readonly byte* Start;
            internal readonly long Bytes;

            internal Column(byte* start, Span<byte> bytes)
            {
                Start = start;
                Bytes = bytes.Length;
            }
        }

        /// <summary>Refuses columns that are too short, or that share memory with the shapes or with one
        /// another.</summary>
        private static void Columns(Shapes a, Shapes b, bool wide, params Column[] columns)
        {
            long needed = InStep(a, b), bytes = needed * Size(wide);
            for (int i = 0; i < columns.Length; ++i)
            {
                if (columns[i].Bytes == 0) continue;
                Room(a, b, columns[i].Start, columns[i].Bytes / Size(wide), needed, Size(wide));
                for (int k = 0; k < i; ++k)
                    if (columns[k].Bytes > 0 && Math.Abs(columns[i].Start - columns[k].Start) < bytes)
                        throw new ArgumentException("output overlaps another one: results need memory of their own");
            }
        }

        /// <summary>The indices of those of many that overlap one, in ascending order.</summary>
        public static long[] OverlapSelect<S>(S one, Shapes many) where S : IShape
        {
            return Selected(overlapSelect, one, many);
        }

        /// <summary>The indices of those of many whose insides share a point with that of one, ascending.</summary>
        public static long[] InteriorsOverlapSelect<S>(S one, Shapes many) where S : IShape
        {
            return Selected(interiorsOverlapSelect, one, many);
        }

        private static long[] Selected<S>(Selection function, S one, Shapes many) where S : IShape
        {
            if (many == null) throw new ArgumentNullException("many");
            Alike(one.IsDouble, many.IsDouble);
            var indices = new long[many.Count + 1];
            double* numbers = stackalloc double[MostNumbers];
            View viewOne = ViewOf(one, numbers), viewMany;
            var pin = many.Pin(out viewMany);
            try
            {
                long code;
                fixed (long* p = indices)
                    code = function(one.IsDouble, &viewOne, &viewMany, p, indices.Length);
                if (code < 0 && code != (long)ErrorCode.Shape) Native.Checked(code);
                Array.Resize(ref indices, (int)(code < 0 ? Array.IndexOf(indices, -1) : code));
                if (code < 0) throw new VesicaException((int)code, indices);
                return indices;
            }
            finally
            {
                if (pin.IsAllocated) pin.Free();
            }
        }

        /// <summary>An array of one shape, whose numbers are written to where it is told.</summary>
        internal static View ViewOf<S>(S one, double* numbers) where S : IShape
        {
            one.Write(numbers);
            return Shapes.One(one.Kind, one.IsDouble, (IntPtr)numbers);
        }

        private static long[] Nms(Shapes shapes, void* scores, long given, bool wide, double threshold)
        {
            if (shapes == null) throw new ArgumentNullException("shapes");
            Alike(shapes.IsDouble, wide);
            if (given != shapes.Count)
                throw new ArgumentException(shapes.Count + " shapes need as many scores, not " + given);
            var scratch = new byte[Native.Checked(Native.vesica_nms_scratch(given))];
            var keep = new long[given];
            long kept = 0;
            View view;
            var pin = shapes.Pin(out view);
            try
            {
                int code;
                fixed (byte* room = scratch)
                fixed (long* to = keep)
                    code = Native.Nms(wide, &view, scores, threshold, room, scratch.Length, to, &kept);
                Array.Resize(ref keep, (int)kept);
                if (code < 0) throw new VesicaException(code, code == (int)ErrorCode.Shape ? keep : null);
                return keep;
            }
            finally
            {
                if (pin.IsAllocated) pin.Free();
            }
        }
    }
}
