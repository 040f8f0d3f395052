// SPDX-License-Identifier: Apache-2.0
using System;
using System.Runtime.InteropServices;

namespace Vesica
{
    /// <summary>A polygon: rings of vertices, each joined to a closed curve. What an odd number of them goes around is
    /// inside: a ring inside another is a hole, whatever their order and directions.</summary>
    public sealed class Polygon : Path
    {
        /// <summary>Copies vertices x y x y ..., and where each ring begins among them, with the end; none, if all are
        /// of one ring.</summary>
        public Polygon(double[] vertices, params int[] rings) : base(Kind.Polygon, vertices, rings) { }

        /// <summary>The same in float.</summary>
        public Polygon(float[] vertices, params int[] rings) : base(Kind.Polygon, vertices, rings) { }
    }

    /// <summary>A polyline: chains of vertices, which are not closed and have no inside.</summary>
    public sealed class Polyline : Path
    {
        /// <summary>Copies vertices x y x y ..., and where each chain begins among them, with the end; none, if all
        /// are of one chain.</summary>
        public Polyline(double[] vertices, params int[] chains) : base(Kind.Polyline, vertices, chains) { }

        /// <summary>The same in float.</summary>
        public Polyline(float[] vertices, params int[] chains) : base(Kind.Polyline, vertices, chains) { }
    }

    /// <summary>A Polygon or a Polyline.</summary>
    public abstract unsafe class Path : IShape
    {
        // The last two that a thread has written: their memory stays until its call about them is over.
#pragma warning disable 414
        [ThreadStatic] private static Path latest, previous;
#pragma warning restore 414

        private readonly PathBlock block;

        internal Path(Kind kind, Array vertices, int[] rings)
        {
            Kind = kind;
            IsDouble = vertices is double[];
            int count = PathBlock.CountOf(vertices);
            if (count == 0) throw new ArgumentException("no vertex, where one is needed");
            if (rings == null || rings.Length == 0) rings = new[] { 0, count };
            block = new PathBlock(vertices, rings, new[] { 0, rings.Length - 1 });
        }

        /// <inheritdoc/>
        public Kind Kind { get; private set; }

        /// <inheritdoc/>
        public bool IsDouble { get; private set; }

        void IShape.Write(void* to)
        {
            previous = latest;
            latest = this;
            *(PathStruct*)to = *block.Structs;
        }
    }

    /// <summary>What the library sees of a polygon or a polyline (vesica_polygon_f64 and _f32).</summary>
    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct PathStruct
    {
        internal byte* X, Y;
        internal IntPtr Stride;
        internal int* Rings;
        internal long Count;
    }

    /// <summary>Structs, and behind them the vertices and offsets that they lead to, where no collector moves
    /// them.</summary>
    internal sealed unsafe class PathBlock
    {
        internal readonly PathStruct* Structs;
        internal readonly int Count;

        /// <summary>Parts are where each shape begins among the rings; null, if a ring is a shape.</summary>
        internal PathBlock(Array vertices, int[] rings, int[] parts)
        {
            int vertexCount = CountOf(vertices), size = vertices is double[] ? sizeof(double) : sizeof(float);
            Ascend("ring", rings, vertexCount);
            if (parts != null) Ascend("part", parts, rings.Length - 1);
            Count = (parts ?? rings).Length - 1;
            long before = (long)Count * sizeof(PathStruct), numbers = 2L * size * vertexCount;
            Structs = (PathStruct*)Marshal.AllocHGlobal((IntPtr)(before + numbers + 4L * rings.Length));
            byte* first = (byte*)Structs + before;
            var offsets = (int*)(first + numbers);
            if (vertices is double[]) Marshal.Copy((double[])vertices, 0, (IntPtr)first, vertices.Length);
            else Marshal.Copy((float[])vertices, 0, (IntPtr)first, vertices.Length);
            Marshal.Copy(rings, 0, (IntPtr)offsets, rings.Length);
            for (int i = 0; i < Count; ++i)
            {
                byte* x = parts == null ? first + 2L * size * rings[i] : first;
                Structs[i] = new PathStruct
                {
                    X = x, Y = x + size, Stride = (IntPtr)(2 * size), Rings = parts == null ? null : offsets + parts[i],
                    Count = parts == null ? rings[i + 1] - rings[i] : parts[i + 1] - parts[i]
                };
            }
        }

        ~PathBlock()
        {
            Marshal.FreeHGlobal((IntPtr)Structs);
        }

        internal static int CountOf(Array vertices)
        {
            if (vertices == null) throw new ArgumentNullException("vertices");
            if (vertices.Length % 2 != 0) throw new ArgumentException(vertices.Length + " numbers are no pairs x y");
            return vertices.Length / 2;
        }

        private static void Ascend(string name, int[] offsets, int end)
        {
            if (offsets == null || offsets.Length == 0)
                throw new ArgumentException("no " + name + " offsets: one more is needed than there are parts");
            int before = 0;
            foreach (int offset in offsets)
            {
                if (offset < before || offset > end)
                    throw new ArgumentException(name + " offsets ascend from 0 to " + end + " at most: " + offset
                        + " follows " + before);
                before = offset;
            }
        }
    }
}
