// SPDX-License-Identifier: Apache-2.0
using System;
using System.Runtime.InteropServices;

namespace Vesica
{
    /// <summary>One shape: the structs Point, Rect and the like in double, PointF and the like in float, a Polygon or
    /// a Polyline of either.</summary>
    /// <remarks>Capsules and rounded rectangles are for Check, Bounds, ShapeArea, Overlap, Relation, Contains,
    /// Nearest, Depth, Signed, Within, Area, Iou, ratios, suppression, Cast, ImpactTime, SweepBounds, and
    /// BoundaryDistance but with an ellipse; the same holds of arrays. An index of them has joins by overlap or distance,
    /// Select, Nearest and casts. Polygons and polylines are for the same but ImpactTime, and for BoundaryDistance with
    /// any kind; polylines have no area. Depth needs convex ones; so do Signed and Within where they ask for a depth.
    /// Other methods throw a VesicaException for them.</remarks>
    public interface IShape
    {
        /// <summary>Its kind.</summary>
        Kind Kind { get; }

        /// <summary>Whether its numbers are double, not float.</summary>
        bool IsDouble { get; }

        /// <summary>Writes its numbers.</summary>
        unsafe void Write(void* numbers);
    }

    /// <summary>A shape whose kind is known at run time.</summary>
    public struct AnyShape : IShape
    {
        private readonly double[] numbers;

        /// <summary>From a kind and as many numbers as it has, which the library gets as double or as float.</summary>
        public AnyShape(Kind kind, bool isDouble, params double[] numbers) : this()
        {
            if (numbers == null) throw new ArgumentNullException("numbers");
            if (numbers.Length != Shapes.Fields(kind))
                throw new ArgumentException(kind + " has " + Shapes.Fields(kind) + " numbers, not " + numbers.Length);
            Kind = kind;
            IsDouble = isDouble;
            this.numbers = (double[])numbers.Clone();
        }

        /// <inheritdoc/>
        public Kind Kind { get; private set; }

        /// <inheritdoc/>
        public bool IsDouble { get; private set; }

        unsafe void IShape.Write(void* to)
        {
            for (int i = 0; numbers != null && i < numbers.Length; ++i)
            {
                if (IsDouble) ((double*)to)[i] = numbers[i];
                else ((float*)to)[i] = (float)numbers[i];
            }
        }
    }

    /// <summary>What the library sees of an array (vesica_shapes_f64 and _f32).</summary>
    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct View
    {
        internal int Kind, Reserved;
        internal long Count;
        internal IntPtr Stride;
        internal byte* Field0, Field1, Field2, Field3, Field4, Field5, Field6, Field7;
        internal int* Rings, Polygons;
        internal long Each;
    }

    /// <summary>An array of shapes of one kind, however it lies in memory. Nothing is copied but the vertices of
    /// polygons and polylines, once.</summary>
    public sealed class Shapes
    {
        private static readonly int[] FieldCounts = { 2, 4, 3, 4, 6, 6, 5, 7 };

        private readonly Array array;
        private readonly IntPtr memory;
        private readonly long stride, step;
        private readonly PathBlock block;

        private Shapes(Kind kind, bool isDouble, long count, long stride, long step, Array array, IntPtr memory)
        {
            Kind = kind;
            IsDouble = isDouble;
            Count = count;
            this.stride = stride;
            this.step = step;
            this.array = array;
            this.memory = memory;
        }

        private unsafe Shapes(Kind kind, bool isDouble, PathBlock block)
            : this(kind, isDouble, block.Count, sizeof(PathStruct), 0, null, (IntPtr)block.Structs)
        {
            if (kind != Kind.Polygon && kind != Kind.Polyline) throw new ArgumentException("a " + kind + " has no rings");
            this.block = block;
        }

        /// <summary>Their kind.</summary>
        public Kind Kind { get; private set; }

        /// <summary>Whether their numbers are double, not float.</summary>
        public bool IsDouble { get; private set; }

        /// <summary>How many they are.</summary>
        public long Count { get; private set; }

        /// <summary>How many numbers a shape of a kind has.</summary>
        public static int Fields(Kind kind)
        {
            if (kind == Kind.Polygon || kind == Kind.Polyline)
                throw new ArgumentException("a " + kind + " has any number of vertices: Paths and EvenPaths take them");
            if (kind < Kind.Point || kind > Kind.RoundRect)
                throw new ArgumentException(kind + " is not a kind of shapes");
            return FieldCounts[(int)kind];
        }

        private static int Size(bool isDouble)
        {
            return isDouble ? sizeof(double) : sizeof(float);
        }

        /// <summary>An array of structs: Rect and the like, or others that are just the numbers of a shape, in the
        /// order of its kind.</summary>
        public static Shapes Of<S>(S[] shapes) where S : struct, IShape
        {
            if (shapes == null) throw new ArgumentNullException("shapes");
            if (typeof(S) == typeof(AnyShape))
                throw new ArgumentException("an array is of shapes of one kind, as Rect[]");
            S one = default(S);
            Kind kind = one.Kind;
            bool isDouble = one.IsDouble;
            int size = Size(isDouble), stride = Fields(kind) * size, given = BytesOf<S>();
            if (given != stride)
                throw new ArgumentException(typeof(S).Name + " has " + given + " bytes, where the numbers of a " + kind
                    + " have " + stride);
            return new Shapes(kind, isDouble, shapes.Length, stride, size, shapes, IntPtr.Zero);
        }

        /// <summary>How large a struct is in an array; an exception if it has references.</summary>
        private static int BytesOf<S>() where S : struct
        {
            return MemoryMarshal.AsBytes(new Span<S>(new S[1])).Length;
        }

        /// <summary>Shapes whose numbers follow one another, or records of so many numbers, of which the first are a
        /// shape's.</summary>
        public static Shapes Of(Kind kind, double[] numbers, int record = 0)
        {
            return Records(kind, true, numbers, record);
        }

        /// <summary>The same in float.</summary>
        public static Shapes Of(Kind kind, float[] numbers, int record = 0)
        {
            return Records(kind, false, numbers, record);
        }

        private static Shapes Records(Kind kind, bool isDouble, Array numbers, int record)
        {
            if (numbers == null) throw new ArgumentNullException("numbers");
            int fields = Fields(kind), size = Size(isDouble);
            if (record == 0) record = fields;
            if (record < fields || numbers.Length % record != 0)
                throw new ArgumentException(numbers.Length + " numbers are no records of " + record + ", of which "
                    + fields + " are a " + kind + "'s");
            return new Shapes(kind, isDouble, numbers.Length / record, (long)record * size, size, numbers, IntPtr.Zero);
        }

        /// <summary>A column for each number of the kind, one after the other.</summary>
        public static Shapes Columns(Kind kind, double[] numbers)
        {
            return Columns(kind, true, numbers);
        }

        /// <summary>The same in float.</summary>
        public static Shapes Columns(Kind kind, float[] numbers)
        {
            return Columns(kind, false, numbers);
        }

        private static Shapes Columns(Kind kind, bool isDouble, Array numbers)
        {
            if (numbers == null) throw new ArgumentNullException("numbers");
            int fields = Fields(kind), size = Size(isDouble);
            if (numbers.Length % fields != 0)
                throw new ArgumentException(numbers.Length + " numbers are no " + fields + " columns of a " + kind);
            int count = numbers.Length / fields;
            return new Shapes(kind, isDouble, count, size, (long)count * size, numbers, IntPtr.Zero);
        }

        /// <summary>Records in memory of the caller's, which must stay: so many bytes from one to the next.</summary>
        public static Shapes At(Kind kind, bool isDouble, IntPtr memory, long count, long stride)
        {
            if (count < 0 || (memory == IntPtr.Zero && count > 0))
                throw new ArgumentException("no memory for " + count + " shapes");
            Fields(kind);
            return new Shapes(kind, isDouble, count, stride, Size(isDouble), null, memory);
        }

        /// <summary>Polygons or polylines of any number of vertices x y x y ..., which are copied, by the offsets of
        /// GeoArrow: where each ring begins among the vertices, with the end, and where each shape begins among the
        /// rings, with the end. If the latter are left out, a ring is a shape.</summary>
        public static Shapes Paths(Kind kind, double[] vertices, int[] rings, int[] parts = null)
        {
            return new Shapes(kind, true, new PathBlock(vertices, rings, parts));
        }

        /// <summary>The same in float.</summary>
        public static Shapes Paths(Kind kind, float[] vertices, int[] rings, int[] parts = null)
        {
            return new Shapes(kind, false, new PathBlock(vertices, rings, parts));
        }

        /// <summary>Polygons or polylines of as many vertices each, in one ring or chain: 4 of quads, 3 of
        /// triangles.</summary>
        public static Shapes EvenPaths(Kind kind, double[] vertices, int each)
        {
            return Paths(kind, vertices, Even(vertices, each));
        }

        /// <summary>The same in float.</summary>
        public static Shapes EvenPaths(Kind kind, float[] vertices, int each)
        {
            return Paths(kind, vertices, Even(vertices, each));
        }

        private static int[] Even(Array vertices, int each)
        {
            int count = PathBlock.CountOf(vertices);
            if (each < 1 || count % each != 0) throw new ArgumentException(count + " vertices are no paths of " + each);
            var rings = new int[count / each + 1];
            for (int i = 0; i < rings.Length; ++i) rings[i] = i * each;
            return rings;
        }

        /// <summary>An array of one shape at an address, which must stay.</summary>
        internal static View One(Kind kind, bool isDouble, IntPtr memory)
        {
            View view;
            new Shapes(kind, isDouble, 1, 0, Size(isDouble), null, memory).Pin(out view);
            return view;
        }

        /// <summary>Whether numbers of this array lie where so many bytes of output do.</summary>
        internal unsafe bool Meets(void* output, long bytes)
        {
            if (Count == 0 || bytes == 0 || block != null) return false;
            View view;
            GCHandle handle = Pin(out view);
            try
            {
                long last = (Count - 1) * stride, number = (Fields(Kind) - 1) * step + Size(IsDouble);
                byte* from = view.Field0 + Math.Min(last, 0), to = view.Field0 + Math.Max(last, 0) + number;
                return output < to && from < (byte*)output + bytes;
            }
            finally
            {
                if (handle.IsAllocated) handle.Free();
            }
        }

        /// <summary>Keeps the array where it is until the handle is freed.</summary>
        internal unsafe GCHandle Pin(out View view)
        {
            var handle = default(GCHandle);
            var first = (byte*)memory;
            if (block != null) handle = GCHandle.Alloc(block);
            if (array != null && array.Length > 0)
            {
                handle = GCHandle.Alloc(array, GCHandleType.Pinned);
                first = (byte*)handle.AddrOfPinnedObject();
            }
            view = new View
            {
                Kind = (int)Kind, Count = Count, Stride = (IntPtr)stride, Field0 = first, Field1 = first + step,
                Field2 = first + 2 * step, Field3 = first + 3 * step, Field4 = first + 4 * step,
                Field5 = first + 5 * step, Field6 = first + 6 * step
            };
            return handle;
        }
    }

    /// <summary>Arrays that stay where they are for the time of a call.</summary>
    internal unsafe struct Pinned : IDisposable
    {
        private readonly GCHandle[] handles;
        internal readonly View[] Views;

        internal Pinned(params Shapes[] shapes)
        {
            handles = new GCHandle[shapes.Length];
            Views = new View[shapes.Length];
            try
            {
                for (int i = 0; i < shapes.Length; ++i) handles[i] = shapes[i].Pin(out Views[i]);
            }
            catch
            {
                Dispose();
                throw;
            }
        }

        public void Dispose()
        {
            foreach (GCHandle handle in handles)
                if (handle.IsAllocated) handle.Free();
        }
    }
}
