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

    /// <summary>A distance, and two points that are that far apart: (AX, AY) of a and (BX, BY) of b.</summary>
    public struct ClosestPoints { public double Distance, AX, AY, BX, BY; }

    /// <summary>An error of the library.</summary>
    public sealed class VesicaException : ArgumentException
    {
        public readonly int Code;

        internal VesicaException(int code) : base(Marshal.PtrToStringAnsi(Native.vesica_strerror(code)))
        {
            Code = code;
        }
    }

    /// <summary>Exact overlap queries between plain 2D shapes. Touching counts. Copy csharp/src/Native.cs, which
    /// declares every function, beside this file.</summary>
    public static unsafe class Shapes
    {
        public const int Point = 0, Segment = 1, Circle = 2, Aabb = 3, Rect = 4, Ellipse = 5;

        private static readonly Type[] Types =
            { typeof(Point), typeof(Segment), typeof(Circle), typeof(Aabb), typeof(Rect), typeof(Ellipse) };

        /// <summary>Do two shapes, given by their numbers, share a point?</summary>
        public static bool Overlap(int kindA, double[] a, int kindB, double[] b)
        {
            Need(kindA, a.Length);
            Need(kindB, b.Length);
            fixed (double* p = a, q = b) return Checked(Native.vesica_overlap_f64(kindA, p, kindB, q)) == 1;
        }

        /// <summary>The same in float.</summary>
        public static bool Overlap(int kindA, float[] a, int kindB, float[] b)
        {
            Need(kindA, a.Length);
            Need(kindB, b.Length);
            fixed (float* p = a, q = b) return Checked(Native.vesica_overlap_f32(kindA, p, kindB, q)) == 1;
        }

        /// <summary>How far apart are two shapes, given by their numbers, and which of their points are
        /// closest?</summary>
        public static ClosestPoints Nearest(int kindA, double[] a, int kindB, double[] b)
        {
            Need(kindA, a.Length);
            Need(kindB, b.Length);
            ClosestPoints points;
            fixed (double* p = a, q = b) Checked(Native.vesica_nearest_f64(kindA, p, kindB, q, &points));
            return points;
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
                fixed (byte* output = hits)
                    return Checked(Native.vesica_overlap_many_f64(&viewA, &viewB, output));
            }
            finally
            {
                pinnedA.Free();
                pinnedB.Free();
            }
        }

        private static View ViewOf<S>(int count, GCHandle pinned)
        {
            IntPtr first = pinned.AddrOfPinnedObject();
            return new View
            {
                Kind = Kind<S>(), Count = count, Stride = (IntPtr)Marshal.SizeOf(typeof(S)), Field0 = first,
                Field1 = first + 8, Field2 = first + 16, Field3 = first + 24, Field4 = first + 32, Field5 = first + 40
            };
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

    // The rest, with every function, is csharp/src/Native.cs.
    internal static unsafe partial class Native
    {
        private const string Library = "libvesica.so.0";

        static Native()
        {
            if (vesica_version() < Version)
                throw new DllNotFoundException("vesica " + vesica_version() + " is older than " + Version);
        }
    }
}
