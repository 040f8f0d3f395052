// SPDX-License-Identifier: Apache-2.0
using System;
using System.Runtime.InteropServices;

namespace Vesica
{
    // Laid out as the library's structs. Axes are the cosine and sine of the angle.
    public struct Point { public double X, Y; }
    public struct Segment { public double X0, Y0, X1, Y1; }
    public struct Circle { public double CX, CY, R; }
    public struct Aabb { public double MinX, MinY, MaxX, MaxY; }
    public struct Rect { public double CX, CY, UX, UY, HX, HY; }
    public struct Ellipse { public double CX, CY, UX, UY, A, B; }

    /// <summary>An error of the library.</summary>
    public sealed class VesicaException : ArgumentException
    {
        public readonly int Code;

        internal VesicaException(int code) : base(Marshal.PtrToStringAnsi(Native.vesica_strerror(code)))
        {
            Code = code;
        }
    }

    /// <summary>Exact overlap queries between plain 2D shapes. Touching counts.</summary>
    public static class Shapes
    {
        public const int Point = 0, Segment = 1, Circle = 2, Aabb = 3, Rect = 4, Ellipse = 5;

        private static readonly Type[] Types =
            { typeof(Point), typeof(Segment), typeof(Circle), typeof(Aabb), typeof(Rect), typeof(Ellipse) };

        /// <summary>Do two shapes, given by their numbers, share a point?</summary>
        public static bool Overlap(int kindA, double[] a, int kindB, double[] b)
        {
            Need(kindA, a.Length);
            Need(kindB, b.Length);
            return Checked(Native.vesica_overlap_f64(kindA, a, kindB, b)) == 1;
        }

        /// <summary>The same in float.</summary>
        public static bool Overlap(int kindA, float[] a, int kindB, float[] b)
        {
            Need(kindA, a.Length);
            Need(kindB, b.Length);
            return Checked(Native.vesica_overlap_f32(kindA, a, kindB, b)) == 1;
        }

        /// <summary>Two arrays of the structs above in step; one of a single shape is repeated. Nothing is copied.
        /// hits is 1 for each where they overlap, else 0; the result is how many do.</summary>
        /// <exception cref="VesicaException">A shape is invalid: hits has 0 for it and every other answer.</exception>
        public static long OverlapMany<A, B>(A[] a, B[] b, byte[] hits) where A : struct where B : struct
        {
            if (a.Length > 0 && b.Length > 0 && hits.Length < Math.Max(a.Length, b.Length))
                throw new ArgumentException("hits is too short");
            GCHandle pinnedA = GCHandle.Alloc(a, GCHandleType.Pinned), pinnedB = GCHandle.Alloc(b, GCHandleType.Pinned);
            try
            {
                View viewA = ViewOf<A>(a.Length, pinnedA), viewB = ViewOf<B>(b.Length, pinnedB);
                return Checked(Native.vesica_overlap_many_f64(ref viewA, ref viewB, hits));
            }
            finally
            {
                pinnedA.Free();
                pinnedB.Free();
            }
        }

        private static View ViewOf<S>(int count, GCHandle pinned)
        {
            View view;
            IntPtr first = pinned.AddrOfPinnedObject(), size = (IntPtr)Marshal.SizeOf(typeof(S));
            Checked(Native.vesica_shapes_from_records_f64(Kind<S>(), count, first, size, out view));
            return view;
        }

        private static int Kind<S>()
        {
            return Array.IndexOf(Types, typeof(S));
        }

        private static void Need(int kind, int length)
        {
            if (length < Checked(Native.vesica_field_count(kind)))
                throw new ArgumentException("too few numbers for a shape");
        }

        private static long Checked(long answer)
        {
            if (answer < 0) throw new VesicaException((int)answer);
            return answer;
        }
    }

    /// <summary>What the library sees of an array (vesica_shapes_f64).</summary>
    internal struct View
    {
        public int Kind, Reserved;
        public long Count;
        public IntPtr Stride, Field0, Field1, Field2, Field3, Field4, Field5;
    }

    internal static class Native
    {
        /// <summary>Of these declarations.</summary>
        private const int Version = 100;
        private const string Library = "libvesica.so.0";

        static Native()
        {
            if (vesica_version() < Version)
                throw new DllNotFoundException("vesica " + vesica_version() + " is older than " + Version);
        }

        [DllImport(Library)] private static extern int vesica_version();
        [DllImport(Library)] internal static extern IntPtr vesica_strerror(int code);
        [DllImport(Library)] internal static extern int vesica_field_count(int kind);
        [DllImport(Library)] internal static extern int vesica_overlap_f64(
            int kindA, double[] a, int kindB, double[] b);
        [DllImport(Library)] internal static extern int vesica_overlap_f32(
            int kindA, float[] a, int kindB, float[] b);
        [DllImport(Library)] internal static extern int vesica_shapes_from_records_f64(
            int kind, long count, IntPtr first, IntPtr stride, out View view);
        [DllImport(Library)] internal static extern long vesica_overlap_many_f64(ref View a, ref View b, byte[] hits);
    }
}
