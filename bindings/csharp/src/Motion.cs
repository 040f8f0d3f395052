// SPDX-License-Identifier: Apache-2.0
using System;
using static System.Runtime.InteropServices.MemoryMarshal;

namespace Vesica
{
    /// <summary>How a shape moves: by t times a velocity, t from 0 to an end. A ray is a point that moves. Whether
    /// there is contact is exact, and times are rounded down. With float shapes velocity and end are rounded to float
    /// first, in all calls that take a motion.</summary>
    public unsafe struct Motion
    {
        /// <summary>The velocity's x.</summary>
        public double VX;

        /// <summary>The velocity's y.</summary>
        public double VY;

        /// <summary>0 or more; infinity has no end.</summary>
        public double End;

        /// <summary>By a velocity, until an end.</summary>
        public Motion(double vx, double vy, double end = double.PositiveInfinity)
        {
            VX = vx;
            VY = vy;
            End = end;
        }

        private static Impact Of(bool wide, double* n)
        {
            return new Impact(Query.At(wide, n, 0), Query.At(wide, n, 1), Query.At(wide, n, 2), Query.At(wide, n, 3),
                Query.At(wide, n, 4));
        }

        /// <summary>Does b touch a while it moves, when first, and where? The normal is from a to b. After a miss the
        /// time is infinity and the rest NaN.</summary>
        public Cast Cast<A, B>(A a, B b, out Impact impact) where A : IShape where B : IShape
        {
            double* n = stackalloc double[5];
            double x = VX, y = VY, end = End;
            int found = 0;
            Query.Measures call = (isDouble, kindA, p, kindB, q, to) =>
                found = Native.Cast(isDouble, kindA, p, kindB, q, x, y, end, to);
            bool wide = Query.Measure(call, a, b, n);
            impact = Of(wide, n);
            return (Cast)found;
        }

        /// <summary>When do two shapes that move and turn touch first, t from 0 to 1? Proved: there is no contact
        /// before the impact's time t, however thin they are and however fast they turn. With float shapes turns and
        /// tolerance are rounded to float first.</summary>
        /// <param name="a">The first shape, in double or in float as the second.</param>
        /// <param name="turnA">What a does until t is 1: how far its centre moves, and by how much it turns about that,
        /// at most 2^20 radians; at t it has done t times that.</param>
        /// <param name="b">The second shape.</param>
        /// <param name="turnB">What b does.</param>
        /// <param name="tolerance">A length above 0, which the gap is not above, but for rounding and very long
        /// searches, as vesica_motion.h tells.</param>
        /// <param name="impact">The place at t: the point of a nearest to b, and the normal that separates
        /// them.</param>
        /// <param name="gap">How far apart they are at t, at most.</param>
        /// <returns>Miss: proved, no contact from 0 to 1; t is infinity, all else NaN. Hit: proved, contact after t.
        /// Near: they come as near as the gap, and there may be contact after t, or none; of a point and a segment, or
        /// two points, contact is never proved. Start: they overlap at t = 0, exactly; the gap is 0.</returns>
        public static Cast ImpactTime<A, B>(A a, Turn turnA, B b, Turn turnB, double tolerance, out Impact impact,
            out double gap) where A : IShape where B : IShape
        {
            double* n = stackalloc double[6];
            int found = 0;
            Query.Measures call = (isDouble, kindA, p, kindB, q, to) =>
            {
                Turn doubleA = turnA, doubleB = turnB;
                TurnF floatA = Narrow(turnA), floatB = Narrow(turnB);
                void* byA = isDouble ? (void*)&doubleA : &floatA, byB = isDouble ? (void*)&doubleB : &floatB;
                void* sixth = isDouble ? (void*)((double*)to + 5) : (float*)to + 5;
                return found = Native.ImpactTime(isDouble, kindA, p, byA, kindB, q, byB, tolerance, to, sixth);
            };
            bool wide = Query.Measure(call, a, b, n);
            impact = Of(wide, n);
            gap = Query.At(wide, n, 5);
            return (Cast)found;
        }

        private static TurnF Narrow(Turn turn)
        {
            return new TurnF((float)turn.VX, (float)turn.VY, (float)turn.Angle);
        }

        /// <summary>Which of many shapes at rest does one moving shape touch first? The lowest of several, or -1. The
        /// normal points to the one that moves.</summary>
        public long CastFirst<S>(S one, Shapes many, out Impact impact) where S : IShape
        {
            if (many == null) throw new ArgumentNullException("many");
            Query.Alike(one.IsDouble, many.IsDouble);
            double* numbers = stackalloc double[Query.MostNumbers], n = stackalloc double[5];
            View view = Query.ViewOf(one, numbers);
            using (var pinned = new Pinned(many))
                fixed (View* views = pinned.Views)
                {
                    long item = Native.Checked(Native.CastFirst(many.IsDouble, &view, views, VX, VY, End, n));
                    impact = Of(many.IsDouble, n);
                    return item == many.Count ? -1 : item;
                }
        }

        internal long[] CastAt(bool wide, View* one, byte* index, View* sets, int count)
        {
            long* state = stackalloc long[4];
            for (int i = 0; i < 4; ++i) state[i] = 0;
            var items = new long[Native.Checked(
                Native.IndexCast(wide, index, sets, count, one, VX, VY, End, null, 0, null))];
            fixed (long* p = items)
                if (items.Length > 0)
                    Native.Checked(Native.IndexCast(wide, index, sets, count, one, VX, VY, End, p, items.Length,
                        state));
            return items;
        }

        internal long CastFirstAt(bool wide, View* one, byte* index, View* sets, int count, out Impact impact)
        {
            double* n = stackalloc double[5];
            long item = Native.Checked(Native.IndexCastFirst(wide, index, sets, count, one, VX, VY, End, n));
            impact = Of(wide, n);
            return item;
        }

        /// <summary>A box that holds a shape throughout its motion.</summary>
        public Aabb Bounds<S>(S shape) where S : IShape
        {
            double* n = stackalloc double[4], numbers = stackalloc double[Query.MostNumbers];
            shape.Write(numbers);
            bool wide = shape.IsDouble;
            Native.Checked(Native.SweepBounds(wide, (int)shape.Kind, numbers, VX, VY, End, n));
            return new Aabb(Query.At(wide, n, 0), Query.At(wide, n, 1), Query.At(wide, n, 2), Query.At(wide, n, 3));
        }

        /// <summary>When, and where, does b[i] touch a[i]? There are as many velocities as shapes in step, or one.
        /// Empty spans are not written, but one must be. Of an invalid shape or velocity the numbers are NaN, all
        /// others are written, and there is an exception. Returns how many touch.</summary>
        public static long CastMany(Shapes a, Shapes b, ReadOnlySpan<double> vx, ReadOnlySpan<double> vy, double end,
            Span<double> t, Span<double> x, Span<double> y, Span<double> nx, Span<double> ny)
        {
            return CastMany(a, b, true, AsBytes(vx), AsBytes(vy), end, AsBytes(t), AsBytes(x), AsBytes(y), AsBytes(nx),
                AsBytes(ny));
        }

        /// <summary>The same in float, to which the end is rounded first.</summary>
        public static long CastMany(Shapes a, Shapes b, ReadOnlySpan<float> vx, ReadOnlySpan<float> vy, double end,
            Span<float> t, Span<float> x, Span<float> y, Span<float> nx, Span<float> ny)
        {
            return CastMany(a, b, false, AsBytes(vx), AsBytes(vy), end, AsBytes(t), AsBytes(x), AsBytes(y), AsBytes(nx),
                AsBytes(ny));
        }

        private static long CastMany(Shapes a, Shapes b, bool wide, ReadOnlySpan<byte> vx, ReadOnlySpan<byte> vy,
            double end, Span<byte> t, Span<byte> x, Span<byte> y, Span<byte> nx, Span<byte> ny)
        {
            int size = wide ? sizeof(double) : sizeof(float);
            long needed = Query.InStep(a, b), given = vx.Length / size;
            if (vx.Length != vy.Length || (given != needed && given != 1))
                throw new ArgumentException("1 or " + needed + " velocities are needed, not " + given);
            if (Meet(vx, vy, t) || Meet(vx, vy, x) || Meet(vx, vy, y) || Meet(vx, vy, nx) || Meet(vx, vy, ny))
                throw new ArgumentException("output overlaps the velocities: results need memory of their own");
            var stride = (IntPtr)(given == 1 ? 0 : size);
            fixed (byte* fromX = &vx.GetPinnableReference(), fromY = &vy.GetPinnableReference())
            {
                void* p = fromX, q = fromY;
                return Query.Closest((isDouble, first, second, c0, c1, c2, c3, c4) => Native.CastMany(
                    isDouble, first, second, p, q, stride, end, c0, c1, c2, c3, c4), a, b, wide, t, x, y, nx, ny);
            }
        }

        private static bool Meet(ReadOnlySpan<byte> vx, ReadOnlySpan<byte> vy, Span<byte> output)
        {
            return MemoryExtensions.Overlaps(vx, output) || MemoryExtensions.Overlaps(vy, output);
        }
    }
}
