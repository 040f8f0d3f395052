// SPDX-License-Identifier: Apache-2.0
using System;
using System.Collections.Generic;
using System.Linq;
using System.Runtime.InteropServices;

namespace Vesica
{
    /// <summary>An item and its distance; item -1 where there is none.</summary>
    public struct Neighbour
    {
        /// <summary>The item's number.</summary>
        public long Item;

        /// <summary>How far it is.</summary>
        public double Distance;
    }

    /// <summary>A pair of items of two indexes.</summary>
    public struct Pair
    {
        /// <summary>The item of the first index.</summary>
        public long A;

        /// <summary>The item of the second index.</summary>
        public long B;
    }

    /// <summary>
    /// An index over arrays of shapes laid end to end: item i is shape i of the first array, and the next array's items
    /// follow. It holds bounds: the numbers must stay as they were.
    /// </summary>
    public sealed unsafe class ShapeIndex : IDisposable
    {
        private const int Alignment = 64, Most = 64, PairsACall = 1 << 14;

        private readonly Shapes[] sets;
        private readonly bool wide;
        private readonly Memory memory;

        // The handle itself takes further calls until the last one is over.
        private volatile bool disposed;

        /// <summary>Memory at an address that the library takes. It is freed once, and not while a call holds
        /// it.</summary>
        private sealed class Memory : SafeHandle
        {
            internal readonly long Size;

            internal Memory(long size) : base(IntPtr.Zero, true)
            {
                Size = size;
                SetHandle(Marshal.AllocHGlobal((IntPtr)(size + Alignment)));
            }

            public override bool IsInvalid
            {
                get { return handle == IntPtr.Zero; }
            }

            internal byte* Address
            {
                get { return (byte*)(((long)handle + Alignment - 1) & -Alignment); }
            }

            protected override bool ReleaseHandle()
            {
                Marshal.FreeHGlobal(handle);
                return true;
            }
        }

        /// <summary>An index's memory, which stays for the time of a call.</summary>
        private struct Held : IDisposable
        {
            private readonly Memory memory;
            internal readonly byte* Address;

            internal Held(ShapeIndex index)
            {
                bool held = false;
                if (index.disposed) throw new ObjectDisposedException("ShapeIndex");
                memory = index.memory;
                memory.DangerousAddRef(ref held);
                Address = memory.Address;
            }

            public void Dispose()
            {
                memory.DangerousRelease();
            }
        }

        /// <summary>Invalid shapes are left out; Incomplete tells.</summary>
        public ShapeIndex(params Shapes[] sets) : this(sets, 1)
        {
        }

        /// <summary>An index built by so many threads of the pool; 0 stands for all processors, as far as that pays.
        /// The bytes are the same.</summary>
        public static ShapeIndex BuildParallel(int threads, params Shapes[] sets)
        {
            if (threads < 0) throw new ArgumentException(threads + " threads");
            return new ShapeIndex(sets, threads);
        }

        private ShapeIndex(Shapes[] sets, int threads)
        {
            this.sets = sets = Sets(sets);
            wide = sets[0].IsDouble;
            Count = sets.Sum(set => set.Count);
            memory = new Memory(Native.Checked(Native.vesica_index_size(Count)));
            using (var scratch = new Memory(Native.Checked(Native.vesica_index_scratch(Count))))
            using (var held = new Held(this))
            using (var pinned = new Pinned(sets))
                fixed (View* views = pinned.Views)
                {
                    long code = Build(Threads.Count(threads, Count), views, held.Address, scratch);
                    Incomplete = code == (long)ErrorCode.Shape;
                    if (!Incomplete) Native.Checked(code);
                }
        }

        private long Build(int threads, View* views, byte* index, Memory scratch)
        {
            byte* with = scratch.Address;
            if (threads == 1)
                return Native.IndexBuild(wide, views, sets.Length, index, memory.Size, with, scratch.Size);
            long code = 0;
            for (int step = 0; step <= 4 && code >= 0; ++step)
            {
                int now = step, parts = step == 0 || step == 4 ? 1 : threads;
                var codes = new long[parts];
                Threads.EachPart(threads, parts, part => codes[part] = Native.IndexStep(
                    wide, now, part, parts, views, sets.Length, index, memory.Size, with, scratch.Size));
                code = codes.Any(each => each < 0) ? codes.First(each => each < 0) : codes[0];
            }
            return code;
        }

        private ShapeIndex(byte[] bytes, Shapes[] sets)
        {
            if (bytes == null) throw new ArgumentNullException("bytes");
            this.sets = sets = Sets(sets);
            wide = sets[0].IsDouble;
            Count = sets.Sum(set => set.Count);
            memory = new Memory(bytes.Length);
            using (var held = new Held(this))
            {
                Marshal.Copy(bytes, 0, (IntPtr)held.Address, bytes.Length);
                Native.Checked(Native.vesica_index_check(held.Address, bytes.Length));
                long builtOf = Native.Checked(Native.vesica_index_count(held.Address));
                if (builtOf != Count)
                    throw new ArgumentException("an index of " + builtOf + " shapes cannot be that of " + Count);
            }
        }

        /// <summary>The index whose bytes were saved, over the same shapes. They are checked.</summary>
        public static ShapeIndex FromBytes(byte[] bytes, params Shapes[] sets)
        {
            return new ShapeIndex(bytes, sets);
        }

        private static Shapes[] Sets(Shapes[] sets)
        {
            if (sets == null || sets.Length == 0 || sets.Length > Most)
                throw new ArgumentException("1 to " + Most + " arrays of shapes are needed; one may be empty");
            foreach (Shapes set in sets)
            {
                if (set == null) throw new ArgumentNullException("sets");
                Query.Alike(sets[0].IsDouble, set.IsDouble);
            }
            return (Shapes[])sets.Clone();
        }

        /// <summary>Gives the memory back now, not when it is collected; after calls of other threads that use
        /// it.</summary>
        public void Dispose()
        {
            disposed = true;
            memory.Dispose();
        }

        /// <summary>How many items there are, invalid shapes included.</summary>
        public long Count { get; private set; }

        /// <summary>Whether invalid shapes were left out. Bytes that were saved do not tell.</summary>
        public bool Incomplete { get; private set; }

        /// <summary>A copy of the bytes, to be saved.</summary>
        public byte[] ToBytes()
        {
            using (var held = new Held(this))
            {
                var bytes = new byte[Native.Checked(Native.vesica_index_bytes(held.Address))];
                Marshal.Copy((IntPtr)held.Address, bytes, 0, bytes.Length);
                return bytes;
            }
        }

        /// <summary>A box around all valid shapes, a little larger than the smallest one.</summary>
        public Aabb Bounds()
        {
            Aabb box;
            using (var held = new Held(this)) Native.Checked(Native.vesica_index_bounds(held.Address, &box));
            return box;
        }

        /// <summary>The items in spatial order: arrays that are laid so are joined quicker.</summary>
        public long[] Order()
        {
            var items = new long[Count];
            long valid;
            using (var held = new Held(this))
                fixed (long* p = items)
                    valid = Native.Checked(Native.vesica_index_order(held.Address, p, items.Length));
            Array.Resize(ref items, (int)valid);
            return items;
        }

        /// <summary>The items that a single shape overlaps, in the index's order.</summary>
        public long[] Select<S>(S one) where S : IShape
        {
            Query.Alike(wide, one.IsDouble);
            double* numbers = stackalloc double[Query.MostNumbers];
            View view = Query.ViewOf(one, numbers);
            long* state = stackalloc long[4];
            for (int i = 0; i < 4; ++i) state[i] = 0;
            using (var held = new Held(this))
            using (var pinned = new Pinned(sets))
                fixed (View* views = pinned.Views)
                {
                    var items = new long[Native.Checked(
                        Native.IndexSelect(wide, held.Address, views, sets.Length, &view, null, 0, null))];
                    fixed (long* p = items)
                        if (items.Length > 0)
                            Native.Checked(Native.IndexSelect(
                                wide, held.Address, views, sets.Length, &view, p, items.Length, state));
                    return items;
                }
        }

        /// <summary>The items that a single shape touches while it moves, in the index's order. With float shapes the
        /// motion is rounded to float first.</summary>
        public long[] Cast<S>(S one, Motion motion) where S : IShape
        {
            Query.Alike(wide, one.IsDouble);
            double* numbers = stackalloc double[Query.MostNumbers];
            View view = Query.ViewOf(one, numbers);
            using (var held = new Held(this))
            using (var pinned = new Pinned(sets))
                fixed (View* views = pinned.Views)
                    return motion.CastAt(wide, &view, held.Address, views, sets.Length);
        }

        /// <summary>The item that a single moving shape touches first, the lowest of several, or -1. With float shapes
        /// the motion is rounded to float first.</summary>
        public long CastFirst<S>(S one, Motion motion, out Impact impact) where S : IShape
        {
            Query.Alike(wide, one.IsDouble);
            double* numbers = stackalloc double[Query.MostNumbers];
            View view = Query.ViewOf(one, numbers);
            using (var held = new Held(this))
            using (var pinned = new Pinned(sets))
                fixed (View* views = pinned.Views)
                {
                    long item = motion.CastFirstAt(wide, &view, held.Address, views, sets.Length, out impact);
                    return item == Count ? -1 : item;
                }
        }

        /// <summary>The k items nearest to a single shape, at most within away; infinity asks for any. With float
        /// shapes within is rounded to float first.</summary>
        public Neighbour[] Nearest<S>(S one, int k, double within) where S : IShape
        {
            Query.Alike(wide, one.IsDouble);
            if (k < 0) throw new ArgumentException("k is " + k + ", not a count");
            k = (int)Math.Min(k, Count);
            double* numbers = stackalloc double[Query.MostNumbers];
            View view = Query.ViewOf(one, numbers);
            long[] items = new long[k];
            double[] distances = new double[k];
            using (var held = new Held(this))
            using (var pinned = new Pinned(sets))
                fixed (View* views = pinned.Views)
                fixed (long* p = items)
                fixed (double* d = distances)
                {
                    long found = Native.Checked(
                        Native.IndexNearest(wide, held.Address, views, sets.Length, &view, k, within, p, d));
                    return Neighbours(p, d, (int)Math.Min(found, k));
                }
        }

        private Neighbour[] Neighbours(long* items, double* distances, int count)
        {
            var all = new Neighbour[count];
            for (int i = 0; i < count; ++i)
                all[i] = new Neighbour { Item = items[i], Distance = wide ? distances[i] : ((float*)distances)[i] };
            return all;
        }

        /// <summary>Of each shape of some arrays, the k nearest items: rows of k, one after the other, filled up by -1
        /// at distance infinity. Where a shape is invalid its row holds -1, and the exception has the result. With
        /// float shapes within is rounded to float first.</summary>
        public Neighbour[] NearestOfEach(int k, double within, params Shapes[] asked)
        {
            asked = Sets(asked);
            Query.Alike(wide, asked[0].IsDouble);
            if (k < 1) throw new ArgumentException("k is " + k + ", not 1 or more");
            long count = asked.Sum(set => set.Count);
            if (count > int.MaxValue / k)
                throw new ArgumentException("rows of " + k + " for " + count + " shapes are more than an array has");
            int rows = (int)count * k;
            var items = new long[rows];
            var distances = new double[rows];
            using (var held = new Held(this))
            using (Pinned pinned = new Pinned(sets), pinnedAsked = new Pinned(asked))
                fixed (View* views = pinned.Views)
                fixed (View* viewsAsked = pinnedAsked.Views)
                fixed (long* p = items)
                fixed (double* d = distances)
                {
                    long code = Native.JoinNearest(wide, viewsAsked, asked.Length, held.Address, views, sets.Length, k,
                        within, 0, 1, p, d);
                    if (code < 0 && code != (long)ErrorCode.Shape) Native.Checked(code);
                    Neighbour[] found = Neighbours(p, d, rows);
                    if (code < 0) throw new VesicaException((int)code, found);
                    return found;
                }
        }

        /// <summary>All pairs of an item of this index and one of another; with itself the pairs a &lt; b. Parts may be
        /// asked by several threads; one after the other they are the join.</summary>
        public Pair[] Join(ShapeIndex other, JoinQuery query = JoinQuery.Overlap, long part = 0, long parts = 1)
        {
            return Pairs((p, q, s) => Ask(other, query, part, parts, p, q, PairsACall, s));
        }

        /// <summary>Join by so many threads of the pool; 0 stands for all processors, as far as that pays. The pairs
        /// are the same, in the same order.</summary>
        public Pair[] JoinParallel(ShapeIndex other, JoinQuery query = JoinQuery.Overlap, int threads = 0)
        {
            if (other == null) throw new ArgumentNullException("other");
            if (threads < 0) throw new ArgumentException(threads + " threads");
            int count = Threads.Count(threads, Count + other.Count);
            int parts = count == 1 ? 1 : checked(8 * count); // some take longer than others
            var found = new Pair[parts][];
            Threads.EachPart(count, parts, part => found[part] = Join(other, query, part, parts));
            return found.SelectMany(pairs => pairs).ToArray();
        }

        /// <summary>All pairs of an item of this index and one of another that are at most so far apart, as Join gives
        /// them. Of ellipses also those too near to it to tell. With float shapes the distance is rounded to float
        /// first.</summary>
        public Pair[] JoinWithin(ShapeIndex other, double distance)
        {
            return Pairs((p, q, s) => AskWithin(other, distance, p, q, s));
        }

        private delegate long Writer(long* a, long* b, long* state);

        /// <summary>All pairs that a join writes in as many calls as it takes.</summary>
        private static Pair[] Pairs(Writer ask)
        {
            var pairs = new List<Pair>();
            long[] a = new long[PairsACall], b = new long[PairsACall], state = new long[4];
            fixed (long* p = a, q = b, s = state)
                while (s[0] != -1)
                {
                    long found = ask(p, q, s);
                    for (long i = 0; i < found; ++i) pairs.Add(new Pair { A = p[i], B = q[i] });
                }
            return pairs.ToArray();
        }

        /// <summary>All pairs of an item of this index and one of another that overlap and whose ratio is at least so
        /// much, in the order of Join. A pair without a ratio is left out. With float shapes the threshold is rounded to
        /// float first.</summary>
        public RatioPair[] JoinRatio(ShapeIndex other, Ratio ratio, double threshold)
        {
            if (other == null) throw new ArgumentNullException("other");
            Query.Alike(wide, other.wide);
            var pairs = new List<RatioPair>();
            long[] a = new long[PairsACall], b = new long[PairsACall], state = new long[4];
            var values = new double[PairsACall];
            using (var scratch = new Memory(Native.Checked(Native.vesica_join_scratch())))
            using (Held held = new Held(this), heldOther = new Held(other))
            using (Pinned pinned = new Pinned(sets), pinnedOther = new Pinned(other.sets))
                fixed (View* views = pinned.Views)
                fixed (View* viewsOther = pinnedOther.Views)
                fixed (long* p = a, q = b, s = state)
                fixed (double* v = values)
                    while (s[0] != -1)
                    {
                        long found = Native.Checked(Native.JoinRatio(wide, (int)ratio, threshold, held.Address, views,
                            sets.Length, heldOther.Address, viewsOther, other.sets.Length, 0, 1, scratch.Address,
                            scratch.Size, p, q, v, PairsACall, s));
                        for (long i = 0; i < found; ++i)
                            pairs.Add(new RatioPair { A = p[i], B = q[i], Value = wide ? v[i] : ((float*)v)[i] });
                    }
            return pairs.ToArray();
        }

        /// <summary>How many pairs Join gives.</summary>
        public long JoinCount(ShapeIndex other, JoinQuery query = JoinQuery.Overlap)
        {
            return Ask(other, query, 0, 1, null, null, 0, null);
        }

        private long AskWithin(ShapeIndex other, double distance, long* a, long* b, long* state)
        {
            if (other == null) throw new ArgumentNullException("other");
            Query.Alike(wide, other.wide);
            using (Held held = new Held(this), heldOther = new Held(other))
            using (Pinned pinned = new Pinned(sets), pinnedOther = new Pinned(other.sets))
                fixed (View* views = pinned.Views)
                fixed (View* viewsOther = pinnedOther.Views)
                    return Native.Checked(Native.JoinWithin(wide, held.Address, views, sets.Length, heldOther.Address,
                        viewsOther, other.sets.Length, distance, 0, 1, a, b, PairsACall, state));
        }

        private long Ask(ShapeIndex other, JoinQuery query, long part, long parts, long* a, long* b, long room,
            long* state)
        {
            if (other == null) throw new ArgumentNullException("other");
            Query.Alike(wide, other.wide);
            using (var scratch = new Memory(Native.Checked(Native.vesica_join_scratch())))
            using (Held held = new Held(this), heldOther = new Held(other))
            using (Pinned pinned = new Pinned(sets), pinnedOther = new Pinned(other.sets))
                fixed (View* views = pinned.Views)
                fixed (View* viewsOther = pinnedOther.Views)
                    return Native.Checked(Native.Join(wide, (int)query, held.Address, views, sets.Length,
                        heldOther.Address, viewsOther, other.sets.Length, part, parts, scratch.Address, scratch.Size,
                        a, b, room, state));
        }
    }
}
